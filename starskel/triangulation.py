"""Triangulating a ring: the ground that visibility expands over."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely

from starskel.errors import InvalidPolygon, told
from starskel.points import Points
from starskel.predicates import Floats, Indices

Triangle = tuple[int, int, int]


@dataclass(frozen=True, eq=False)
class Triangulation:
    """Triangles without area zero that tile a ring, every vertex of the ring among their corners.

    Attributes
    ----------
    points : Points
    ring : (n,) array of int
        The rows of the ring's vertices among the points, counter-clockwise.
    triangles : (n - 2, 3) array of int
        Corners as indices of the ring, counter-clockwise. Half-edge 3 f + s runs from corner s of triangle f
        to the next.
    twins : (3 n - 6,) array of int
        For each half-edge the one on its other side, or -1 on the ring.
    """

    points: Points
    ring: Indices
    triangles: Indices
    twins: Indices

    @property
    def vertices(self) -> Floats:
        """The (n, 2) coordinates of the ring."""
        vertices: Floats = self.points.coordinates[self.ring]
        return vertices


Grounds = tuple[Triangulation, Triangulation]
"""The same ring triangulated in the source and in the target."""


def triangulate(points: Points, ring: Indices) -> Triangulation:
    """Triangulate the simple ring over some points, exactly right also where vertices lie on straight runs.

    Raises
    ------
    InvalidPolygon
        If the ring touches itself.
    """
    corners = np.flatnonzero(points.orientation(np.roll(ring, 1), ring, np.roll(ring, -1)))
    triangles = _delaunay(points, ring[corners])
    if triangles is None:
        triangles = _cut_ears(points, ring[corners])
    triangles = np.array(_split_runs(corners[triangles].tolist(), _runs(corners, len(ring))))
    return Triangulation(points, ring, triangles, _twins(triangles))


def _delaunay(points: Points, corners: Indices) -> Indices | None:
    """Let GEOS triangulate; believe it only if every triangle and every edge proves right."""
    ring = points.coordinates[corners]
    try:
        parts = shapely.constrained_delaunay_triangles(shapely.Polygon(ring))
    except shapely.GEOSException:  # lost its way among vertices that are all but collinear
        return None
    found = shapely.get_coordinates(parts).reshape(-1, 4, 2)[:, :3]
    triangles = _rows_of(found.reshape(-1, 2), ring).reshape(-1, 3)
    if len(triangles) != len(corners) - 2 or triangles.min() < 0:
        return None
    turns = points.orientation(*corners[triangles].T)
    triangles[turns < 0] = triangles[turns < 0][:, ::-1]
    return triangles if (turns != 0).all() and _tiles(triangles, len(corners)) else None


def _rows_of(places: Floats, ring: Floats) -> Indices:
    """Give for each place the row of the ring that is there, or -1."""
    at, vertices = (np.ascontiguousarray(a).view(np.complex128)[:, 0] for a in (places, ring))
    order = np.argsort(vertices)
    rows = order[np.searchsorted(vertices[order], at).clip(max=len(ring) - 1)]
    return np.where(vertices[rows] == at, rows, -1)


def _tiles(triangles: Indices, n: int) -> bool:
    """Tell whether counter-clockwise triangles fit together along their edges and end at the ring."""
    starts, ends = _half_edges(triangles)
    outer = _twins(triangles) < 0
    once = len(np.unique(starts * n + ends)) == len(starts)
    return once and np.count_nonzero(outer) == n and bool((ends[outer] == (starts[outer] + 1) % n).all())


def _cut_ears(points: Points, corners: Indices) -> Indices:
    """Triangulate by cutting ears; O(n^2), for rings too nearly degenerate for floating point."""
    left = list(range(len(corners)))
    ears: list[Triangle] = []
    at = tried = 0
    while len(left) > 2:
        ear = left[at - 1], left[at], left[(at + 1) % len(left)]
        if _is_ear(points, corners, ear, np.array(left)):
            ears.append(ear)
            left.pop(at)
            tried = 0
        elif (tried := tried + 1) > len(left):
            x, y = points.coordinates[corners[ear[1]]]
            raise InvalidPolygon(
                told(
                    "the polygon all but touches itself near vertex {i}, at ({x:g}, {y:g})",
                    i=corners[ear[1]],
                    x=x,
                    y=y,
                ),
                told("move this vertex, or those next to it, apart"),
                vertices=(int(corners[ear[1]]),),
                place=(float(x), float(y)),
            )
        else:
            at += 1
        at %= len(left)
    return np.array(ears)


def _is_ear(points: Points, corners: Indices, ear: Triangle, left: Indices) -> bool:
    a, b, c = corners[list(ear), None]
    if points.orientation(a, b, c)[0] <= 0:
        return False
    others = corners[left[~np.isin(left, ear)]]
    outside = (
        (points.orientation(a, b, others) < 0)
        | (points.orientation(b, c, others) < 0)
        | (points.orientation(c, a, others) < 0)
    )
    return bool(outside.all())


def _runs(corners: Indices, n: int) -> dict[tuple[int, int], list[int]]:
    """Give for each edge between corners the straight vertices on it, in order, if there are any."""
    ends = [*corners[1:].tolist(), int(corners[0]) + n]
    between = zip(corners.tolist(), ends, strict=True)
    return {(a, b % n): [v % n for v in range(a + 1, b)] for a, b in between if b - a > 1}


def _split_runs(waiting: list[Triangle], runs: dict[tuple[int, int], list[int]]) -> list[Triangle]:
    """Split triangles at straight vertices into fans from the opposite corner."""
    if not runs:
        return waiting[::-1]
    done: list[Triangle] = []
    while waiting:
        a, b, c = waiting.pop()
        for p, q, apex in ((a, b, c), (b, c, a), (c, a, b)):
            if (p, q) in runs:
                waiting += [(v, w, apex) for v, w in pairwise([p, *runs.pop((p, q)), q])]
                break
        else:
            done.append((a, b, c))
    return done


def _twins(triangles: Indices) -> Indices:
    """Give for each half-edge the one that runs the other way, or -1."""
    starts, ends = _half_edges(triangles)
    n = len(starts)  # more than any index
    order = np.argsort(starts * n + ends)
    found = order[np.searchsorted((starts * n + ends)[order], ends * n + starts).clip(max=n - 1)]
    return np.where((starts[found] == ends) & (ends[found] == starts), found, -1)


def _half_edges(triangles: Indices) -> tuple[Indices, Indices]:
    return triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
