"""What is done to a whole shape, with its marks kept where that is possible."""

from collections.abc import Callable, Collection, Iterable

import numpy as np

from app.model import marks as pins
from app.model.density import kept_vertices, refined
from app.model.document import Document
from app.model.marks import Side, other
from app.model.transforms import box_of, scaled
from starskel.arrays import Floats
from starskel.errors import InvalidMarks


def simplify(document: Document, side: Side, tolerance: float, among: Collection[int]) -> Document:
    """Leave out vertices that matter less than a tolerance; marked ones stay, and those not among these."""
    ring = document.vertices(side)
    pinned = {*document.marked(side), *(set(range(len(ring))) - set(among))}
    kept = kept_vertices(ring, tolerance, pinned)
    places = {int(vertex): place for place, vertex in enumerate(kept)}
    return document.reform(side, ring[kept], places.get)


def refine(document: Document, side: Side, count: int, among: Collection[int]) -> Document:
    """Add vertices evenly, on the edges between these vertices."""
    ring = document.vertices(side)
    edges = [vertex for vertex in among if (vertex + 1) % len(ring) in among]
    finer, places = refined(ring, count, edges)
    return document.reform(side, finer, lambda vertex: int(places[vertex]))


def set_first(document: Document, side: Side, vertex: int) -> Document:
    """Let the vertices count from this one on."""
    ring = document.vertices(side)
    return document.reform(side, np.roll(ring, -vertex, axis=0), lambda v: (v - vertex) % len(ring))


def mirrored(document: Document, side: Side, vertices: Collection[int], factors: tuple[int, int]) -> Floats:
    """Give the ring with vertices mirrored about their box's middle: (-1, 1) exchanges left and right."""
    ring = document.vertices(side).copy()
    rows = sorted(vertices)
    ring[rows] = scaled(ring[rows], box_of(ring[rows]).middle, factors)
    return ring


def turn_round(document: Document, side: Side, ring: Floats) -> Document:
    """Put each vertex where it is in a ring that may run the other way round.

    Of more than two marks some then no longer come in the same order on both shapes: those set last are
    left out.
    """
    kept: tuple[int, ...] = ()
    for vertex in document.marked(side):
        if _agrees(document, side, ring, (*kept, vertex)):
            kept = (*kept, vertex)
    return document.reform(side, ring, _only(kept))


def copy_across(document: Document, side: Side) -> Document:
    """Copy a shape to the other canvas; where it is marked it then corresponds to itself."""
    marked = [pins.end(mark, side) for mark in document.marks]
    copied = document.draw(other(side), document.polygon(side))
    for vertex in marked:
        copied = copied.mark(vertex, vertex)
    return copied


def _agrees(document: Document, side: Side, ring: Floats, kept: Iterable[int]) -> bool:
    try:
        document.reform(side, ring, _only(kept))
    except InvalidMarks:
        return False
    return True


def _only(kept: Iterable[int]) -> Callable[[int], int | None]:
    stay = frozenset(kept)
    return lambda vertex: vertex if vertex in stay else None
