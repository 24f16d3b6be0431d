"""The shapes of any file that is known: drawings, maps, projects, files of pairs."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from starskel.command.opening import opened
from starskel.errors import InvalidFile
from starskel.files.documents import format_of
from starskel.files.multi_pairs import MultiPair
from starskel.files.pairs import ShapePair
from starskel.files.projects import project_document
from starskel.files.projects.project import AnyPair, letter
from starskel.files.projects.project_file import read_project
from starskel.reading.named_shape import NamedShape
from starskel.reading.readers import ENDINGS, FORMATS, read_shapes
from starskel.reading.wanted import TOLERANCE
from starskel.shapes.matching.pairing import suggest_pairing
from starskel.shapes.shape import Shape

FONTS = next(found.endings for found in FORMATS if found.module == "font")


@dataclass(frozen=True)
class Holdings:
    """What a file holds.

    Attributes
    ----------
    kind : str
        What it is.
    shapes : tuple of NamedShape
    notes : tuple of str
        What could not be read, a sentence each.
    """

    kind: str
    shapes: tuple[NamedShape, ...]
    notes: tuple[str, ...] = ()


def holdings(path: Path, tolerance: float = TOLERANCE, texts: Sequence[str] = ()) -> Holdings:
    """Give the shapes of a file.

    Raises
    ------
    InvalidFile
        If it cannot be read, or is of no kind that is known.
    """
    if path.suffix.lower() in ENDINGS:
        reading = read_shapes(path, tolerance, texts)
        return Holdings(path.suffix[1:].lower(), reading.shapes, reading.notes)
    if path.suffix.lower() != ".json":
        raise InvalidFile(
            f'{path} ends in "{path.suffix}"', f"give a file that ends in .json, {', '.join(ENDINGS)}"
        )
    kind = format_of(path)
    shapes = _key_shapes(path) if kind == project_document.FORMAT else _ends(path)
    return Holdings(kind, tuple(NamedShape(name, shape) for name, shape in shapes))


def check_texts(paths: Sequence[Path], texts: Sequence[str]) -> None:
    """See that texts are asked of a font.

    Raises
    ------
    InvalidFile
        If there are texts, but no font that could set them.
    """
    if texts and not any(path.suffix.lower() in FONTS for path in paths):
        raise InvalidFile(
            f'no font is there to set "{texts[0]}"', f"leave out --text, or give a font ({', '.join(FONTS)})"
        )


def pair_of(name: str, source: Shape, target: Shape) -> AnyPair:
    """Give two shapes as a pair, without marks; of several rings those become each other that fit best."""
    if len(source) == len(target) == 1:
        return ShapePair(name, source.rings[0], target.rings[0])
    return MultiPair(name, source, target, tuple(suggest_pairing(source, target)), marks=(), places={})


def _ends(path: Path) -> Iterator[tuple[str, Shape]]:
    file = opened(path)
    for name in file.ids:
        pair = file.pair(name)
        for end in ("source", "target"):
            given = getattr(pair, end)
            yield f"{name} {end}", given if isinstance(given, Shape) else Shape([given])


def _key_shapes(path: Path) -> Iterator[tuple[str, Shape]]:
    for number, shape in enumerate(read_project(path).shapes):
        if shape.parts:
            yield letter(number), shape.shape
