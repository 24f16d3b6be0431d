"""From a few marks to a complete correspondence: align vertices, give new partners to those left alone."""

from collections.abc import Iterable
from typing import TypeAlias

import numpy as np
import shapely
from numpy.typing import ArrayLike

from starskel.arrays import Floats, Indices
from starskel.correspondence.alignment import Chain, ChainPrices, align
from starskel.correspondence.insertion import Rows, inserted, merged
from starskel.correspondence.marks import Mark, as_marks, checked_marks
from starskel.correspondence.pair import Correspondence
from starskel.correspondence.proposal import proposed_marks
from starskel.errors import InvalidPolygon, told
from starskel.outline import precedes
from starskel.polygon import Polygon
from starskel.task import ShouldStop, Task

PolygonLike: TypeAlias = Polygon | shapely.Polygon | ArrayLike

UNMARKED = 8
"""So many marks are proposed where none are given."""


def match(
    source: PolygonLike,
    target: PolygonLike,
    marks: Iterable[tuple[int, int]] = (),
    *,
    should_stop: ShouldStop | None = None,
) -> Correspondence:
    """Complete a partial correspondence between two polygons.

    The marks cut both outlines into chains, whose vertices are aligned by share of the length and by turning
    angle. A vertex left alone gets a new partner on an edge of the other polygon, by edge lengths between its
    matched neighbours (paper, section 5). The shapes do not change, and exchanging them gives the same pairs
    of vertices. Without marks those are used that `suggest_marks` proposes.

    Parameters
    ----------
    source, target : Polygon, shapely Polygon or (n, 2) array-like
    marks : iterable of (int, int)
        Vertices that correspond, as indices of the points given, from 0.
    should_stop : callable, optional
        Asked often whether to give up.

    Raises
    ------
    InvalidPolygon
        Where the points form no simple polygon, or an edge is too short to take new vertices.
    InvalidMarks
        Where a mark names a missing vertex, or two of them contradict each other.
    StarskelError
        If both have so many vertices that comparing them all would take too much memory.
    Cancelled
        If ``should_stop`` answered True.
    """
    task = Task(should_stop=should_stop)
    polygons = as_polygon(source, "source"), as_polygon(target, "target")
    task.reach(0)
    given = as_marks(marks)
    own = checked_marks(*polygons, given)
    rings = polygons[0].vertices, polygons[1].vertices
    if precedes(rings[1], rings[0]):
        points, vertices = _completed(rings[::-1], ("target", "source"), [(j, i) for i, j in own], task)
        points, vertices = points[::-1], vertices[::-1]
    else:
        points, vertices = _completed(rings, ("source", "target"), own, task)
    start = int(np.flatnonzero(vertices[0] == 0)[0])
    source_ring, target_ring = (np.roll(ring, -start, axis=0) for ring in points)
    source_rows, target_rows = (np.roll(rows, -start) for rows in vertices)
    row_of = {vertex: row for row, vertex in enumerate(source_rows.tolist())}
    marked = tuple(row_of[polygons[0].vertex_of(i)] for i, _ in given)
    return Correspondence(source_ring, target_ring, given, source_rows, target_rows, marked_rows=marked)


def as_polygon(shape: PolygonLike, side: str) -> Polygon:
    """Give the shape as a checked polygon; errors say whether it is the source or the target."""
    if isinstance(shape, Polygon):
        return shape
    try:
        return Polygon(shape)
    except InvalidPolygon as error:
        raise error.within(told(side)) from None


def _completed(
    rings: tuple[Floats, Floats], names: tuple[str, str], marks: list[Mark], task: Task
) -> tuple[tuple[Floats, Floats], Indices]:
    """Give both rings with as many points, and for each of these the vertex, or -1."""
    matched = _aligned(*rings, sorted(marks) or proposed_marks(rings, UNMARKED, task), task)
    rows = merged(rings, np.array(matched, dtype=np.intp))
    return (_filled(rings[0], rows, 0, names[0]), _filled(rings[1], rows, 1, names[1])), rows.vertices


def _filled(ring: Floats, rows: Rows, number: int, side: str) -> Floats:
    """Give the ring with a point for every row; errors say whether it is the source or the target."""
    try:
        return inserted(ring, rows, number)
    except InvalidPolygon as error:
        raise error.within(told(side)) from None


def _aligned(source: Floats, target: Floats, marks: list[Mark], task: Task) -> list[Mark]:
    """Give all pairs of vertices that correspond, in the order round the source from the first mark."""
    matched: list[Mark] = []
    for (i, j), (next_i, next_j) in zip(marks, [*marks[1:], marks[0]], strict=True):
        pairs = align(ChainPrices(Chain.of(source, i, next_i), Chain.of(target, j, next_j)), task)
        matched.append((i, j))
        matched += [((i + 1 + k) % len(source), (j + 1 + m) % len(target)) for k, m in pairs]
    return matched
