"""Ways to blend a pair, be it of two polygons or of shapes of several."""

from argparse import Namespace
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

from starskel.blending.frames import Blend
from starskel.command.methods import blends, shared
from starskel.command.progress import Progress
from starskel.errors import InvalidFile
from starskel.files.multi_pairs import MultiPair
from starskel.files.project import AnyPair
from starskel.shapes.blend import blend
from starskel.shapes.match import match
from starskel.shapes.shape_blend import ShapeBlend

Watch: TypeAlias = Callable[[str, float], None]
"""Told the way under way and the fraction of all that is done."""


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
    ways = [Way(method, method, not arguments.separate) for method in methods]
    return [*ways, *comparison(pairs[0], methods)] if measured and len(pairs) == 1 else ways


def comparison(pair: AnyPair, methods: Sequence[str]) -> list[Way]:
    """Give the first method part by part, of shapes of several parts (paper, figure 9)."""
    shapes = (pair.source, pair.target) if isinstance(pair, MultiPair) else ()
    several = any(shape.outer.count(-1) > 1 for shape in shapes)
    return [Way("parts separately", methods[0], False)] if several else []


def blends_of(
    pair: AnyPair, ways: Sequence[Way], watch: Watch | None = None
) -> Iterator[tuple[str, Blend | ShapeBlend]]:
    """Blend a pair in several ways, and give each blend under the way's name; watched as by `blends`.

    Raises
    ------
    StarskelError
        If the pair cannot be matched or blended.
    """
    if isinstance(pair, MultiPair):
        yield from _shape_blends(pair, ways, watch)
    else:
        yield from blends(pair, [way.method for way in ways], watch)


def _shape_blends(
    pair: MultiPair, ways: Sequence[Way], watch: Watch | None
) -> Iterator[tuple[str, ShapeBlend]]:
    matched = match(pair.source, pair.target, pair.marks, pairing=pair.pairing, places=pair.places)
    for number, way in enumerate(ways):
        with Progress(f"{pair.id}: {way.name}") as bar:
            progress = bar if watch is None else shared(watch, way.name, number, len(ways))
            joined = way.joined and pair.joined
            made = blend(
                matched,
                method=way.method,
                joined=joined,
                roots=pair.roots,
                turns=pair.turns,
                progress=progress,
            )
        yield way.name, made
