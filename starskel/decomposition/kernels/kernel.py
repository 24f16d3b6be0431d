"""Kernels: from where a ring is seen whole."""

from collections.abc import Sequence

import numpy as np

from starskel.arrays import Flags, Floats, Indices, Signs
from starskel.decomposition.kernels.half_planes import Lines, left_of_all
from starskel.points import Points
from starskel.predicates import NEAR
from starskel.rings import Rings, ranges
from starskel.task import UNWATCHED, Task

_FIRST_EDGES = 8
"""Edges that vertices are held against at first; each time those left are held against twice as many."""

_LARGE = 200
"""Vertices of a ring from which on it pays to look for straight runs first."""

_PAIRS = 1 << 16
"""Pairs of a vertex and an edge that are looked at between two questions whether to stop, or few more."""


def star_vertices(sides: Sequence[Points], rings: Rings, task: Task = UNWATCHED) -> Flags:
    """Tell for each of m vertices of simple rings, (m,), whether it lies in the kernels of its ring, exactly.

    The rings are the same over all sides. A few edges leave few vertices to be held against the others.
    """
    ends = rings.rows[rings.following]
    star = np.arange(len(rings.rows))
    for points in sides:
        edges, first, counts = _lines(points, rings)
        most = int(counts.max(initial=0))
        done, step = 0, _FIRST_EDGES
        while done < most and len(star):
            task.reach(0)
            owner = rings.owner[star]
            held, place = ranges(first[owner] + done, (counts[owner] - done).clip(0, step))
            edge = edges[place]
            right = points.orientation(rings.rows[edge], ends[edge], rings.rows[star[held]]) < 0
            star = star[np.bincount(held[right], minlength=len(star)) == 0]
            done, step = done + step, max(_FIRST_EDGES, min(2 * step, _PAIRS // max(1, len(star))))
    stars = np.zeros(len(rings.rows), dtype=bool)
    stars[star] = True
    return stars


def _lines(points: Points, rings: Rings) -> tuple[Indices, Indices, Indices]:
    """Give the edges that vertices are held against; for each ring the first of these, and how many.

    Of large rings they are one edge for each straight run, and none where the ring is convex.
    """
    if rings.counts.max(initial=0) < _LARGE:
        return np.arange(len(rings.rows)), rings.first, rings.counts
    signs = turns(points, rings)
    convex = np.minimum.reduceat(signs, rings.first) >= 0
    edges = np.flatnonzero((signs != 0) & ~convex[rings.owner])
    counts = np.bincount(rings.owner[edges], minlength=len(rings.counts))
    return edges, np.cumsum(counts) - counts, counts


def turns(points: Points, rings: Rings) -> Signs:
    """Tell whether rings turn left (1), right (-1) or not at all (0) at each vertex."""
    return points.orientation(rings.rows[rings.preceding], rings.rows, rings.rows[rings.following])


def _without_straight(points: Points, rings: Rings) -> Rings:
    """Leave out of large rings vertices at which they do not turn: all edges of a run lie on one line."""
    if rings.counts.max(initial=0) < _LARGE:
        return rings
    bent = turns(points, rings) != 0
    return Rings(rings.rows[bent], np.bincount(rings.owner[bent], minlength=len(rings.counts)))


def star_points(sides: Sequence[Points], rings: Rings, task: Task = UNWATCHED) -> list[tuple[Floats, Floats]]:
    """Give for many rings, the same over all sides, the centroids of their kernels, and the kernels' areas.

    Exact predicates prove that the centroid is strictly to the left of all edges, and that the ring goes
    round it once. So the ring is simple, counter-clockwise and seen whole from there. Where that cannot be
    proven the area is 0, also where a kernel is too thin for floats to name a point in it. It is below 0
    where the kernel is empty, and not by rounding alone.

    Returns
    -------
    list of (k, 2) and (k,) arrays, for each side
    """
    return [_star_points(points, rings, task) for points in sides]


def _star_points(points: Points, rings: Rings, task: Task) -> tuple[Floats, Floats]:
    lines = Lines.round(_without_straight(points, rings), points.coordinates.view(np.complex128)[:, 0])
    kernels = left_of_all(lines, task)
    centroids, areas = kernels.measured()
    areas[kernels.size == 0] = -1
    places = centroids[:, None].view(np.float64)
    some = areas > 0
    proven = _round_once(points, Rings(rings.rows[some[rings.owner]], rings.counts[some]), places[some])
    areas[np.flatnonzero(some)[~proven]] = 0
    return places, areas


def are_seen_well_from(sides: Sequence[Points], rings: Rings, places: Sequence[Floats]) -> Flags:
    """Tell which rings, the same over all sides, are seen whole from (k, 2) places in each, exactly.

    The places keep so far off the lines along all edges, as a share of the largest coordinate, that rounding
    is no matter: `star_points` proves the rings, too.
    """
    seen: Flags = np.ones(len(rings.counts), dtype=bool)
    for points, place in zip(sides, places, strict=True):
        edges = Lines.round(rings, points.coordinates.view(np.complex128)[:, 0])
        off = (edges.way.conj() * (place.view(np.complex128)[rings.owner, 0] - edges.start)).imag
        margin = NEAR * np.maximum.reduceat(np.abs(edges.start), rings.first)[rings.owner]
        seen &= np.logical_and.reduceat(off > margin * np.abs(edges.way), rings.first)
        seen &= _round_once(points, rings, place)
    return seen


def _round_once(points: Points, rings: Rings, places: Floats) -> Flags:
    """Tell whether each ring runs round its place once, always to the left, exactly."""
    vertices, owner, after = rings.rows, rings.owner, rings.following
    sides = points.orientation_to(vertices, vertices[after], owner, places)
    above = points.coordinates[vertices, 1] > places[owner, 1]
    turns = np.bincount(owner[above[after] & ~above], minlength=len(rings.counts))
    once: Flags = np.logical_and.reduceat(sides > 0, rings.first) & (turns == 1)
    return once
