"""What render does with shapes of several polygons."""

from argparse import Namespace
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from starskel.command.progress import Progress
from starskel.errors import InvalidFile
from starskel.files.multi_pairs import MultiPair
from starskel.files.project import AnyPair
from starskel.shapes.blend import blend
from starskel.shapes.match import match
from starskel.shapes.shape_blend import ShapeBlend


class Way(NamedTuple):
    """A way to blend: what it is called, the method, and whether a meta-skeleton joins the parts."""

    name: str
    method: str
    joined: bool = True


def ways_of(
    arguments: Namespace, pairs: Sequence[AnyPair], methods: Sequence[str], *, measured: bool
) -> list[Way]:
    """Give a way for every method; a sheet of shapes of several parts shows the first also part by part.

    Raises
    ------
    InvalidFile
        If the options do not go with what is blended.
    """
    shapes = [pair for pair in pairs if isinstance(pair, MultiPair)]
    if arguments.separate and not shapes:
        raise InvalidFile(f"{arguments.file} holds no shapes of several polygons", "leave out --separate")
    if shapes and (arguments.marks or arguments.pieces):
        raise InvalidFile(
            f"{arguments.file} holds shapes of several polygons, on which marks and pieces are not drawn",
            "leave out --marks and --pieces",
        )
    ways = [Way(method, method, not arguments.separate) for method in methods]
    if measured and len(pairs) == 1 and any(_several(pair) for pair in shapes):
        ways.append(Way("parts separately", methods[0], False))
    return ways


def shape_blends(pair: MultiPair, ways: Sequence[Way]) -> Iterator[tuple[str, ShapeBlend]]:
    """Blend a pair in several ways."""
    matched = match(pair.source, pair.target, pair.marks, pairing=pair.pairing, places=pair.places)
    for way in ways:
        with Progress(f"{pair.id}: {way.name}") as bar:
            joined = way.joined and pair.joined
            made = blend(matched, method=way.method, joined=joined, turns=pair.turns, progress=bar)
        yield way.name, made


def _several(pair: MultiPair) -> bool:
    return any(shape.outer.count(-1) > 1 for shape in (pair.source, pair.target))
