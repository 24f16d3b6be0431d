"""The shapes of any file that is known: drawings, maps, projects, files of pairs."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from starskel.errors import InvalidFile
from starskel.files import multi_pairs, pairs, project
from starskel.files.documents import check_format
from starskel.files.multi_pairs import read_multi_pairs
from starskel.files.pairs import read_pairs
from starskel.files.project import letter, read_project
from starskel.polygon import Polygon
from starskel.reading.found import Found as NamedShape
from starskel.reading.readers import ENDINGS, TOLERANCE, read_shapes
from starskel.shapes.shape import Shape

__all__ = ["Holdings", "NamedShape", "holdings"]


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


def holdings(path: Path, tolerance: float = TOLERANCE) -> Holdings:
    """Give the shapes of a file.

    Raises
    ------
    InvalidFile
        If it cannot be read, or is of no kind that is known.
    """
    if path.suffix.lower() in ENDINGS:
        reading = read_shapes(path, tolerance)
        return Holdings(path.suffix[1:].lower(), reading.shapes, reading.notes)
    if path.suffix.lower() != ".json":
        raise InvalidFile(
            f'{path} ends in "{path.suffix}"', f"give a file that ends in .json, {', '.join(ENDINGS)}"
        )
    kind = check_format(path, pairs.FORMAT, multi_pairs.FORMAT, project.FORMAT)
    shapes = {pairs.FORMAT: _pairs, multi_pairs.FORMAT: _multi_pairs, project.FORMAT: _project}[kind]
    return Holdings(kind, tuple(NamedShape(name, shape) for name, shape in shapes(path)))


def _pairs(path: Path) -> Iterator[tuple[str, Shape]]:
    file = read_pairs(path)
    for name in file.ids:
        pair = file.pair(name)
        yield f"{name} source", Shape([pair.source])
        yield f"{name} target", Shape([pair.target])


def _multi_pairs(path: Path) -> Iterator[tuple[str, Shape]]:
    file = read_multi_pairs(path)
    for name in file.ids:
        pair = file.pair(name)
        yield f"{name} source", pair.source
        yield f"{name} target", pair.target


def _project(path: Path) -> Iterator[tuple[str, Shape]]:
    for number, shape in enumerate(read_project(path).shapes):
        if shape is not None:
            yield letter(number), Shape([shape]) if isinstance(shape, Polygon) else shape
