"""Triangulating rings: the ground that visibility expands over."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray

from starskel.arrays import Flags, Floats, Indices
from starskel.errors import InvalidPolygon, told
from starskel.points import Points
from starskel.rings import Rings

Triangle = tuple[int, int, int]

_ODD = np.uint64(0x9E3779B97F4A7C15)
"""A multiplier that spreads all bits: 2^64 divided by the golden ratio."""


@dataclass(frozen=True, eq=False)
class Triangulation:
    """Triangles without area zero that tile rings, every vertex of the rings among their corners.

    Attributes
    ----------
    points : Points
    rings : Rings
        Of h vertices over the points, each ring counter-clockwise.
    triangles : (h - 2 k, 3) array of int
        Corners as vertices of the rings, counter-clockwise. Half-edge 3 f + s runs from corner s of triangle
        f to the next.
    twins : (3 h - 6 k,) array of int
        For each half-edge the one on its other side, or -1 on the ring.
    """

    points: Points
    rings: Rings
    triangles: Indices
    twins: Indices

    @cached_property
    def vertices(self) -> Floats:
        """The (h, 2) coordinates of the rings' vertices."""
        vertices: Floats = self.points.coordinates[self.rings.rows]
        return vertices

    @cached_property
    def owner(self) -> Indices:
        """The ring that each triangle belongs to."""
        owner: Indices = self.rings.owner[self.triangles[:, 0]]
        return owner


Grounds = tuple[Triangulation, Triangulation]
"""The same rings triangulated in the source and in the target."""


def triangulate(points: Points, ring: Indices) -> Triangulation:
    """Triangulate the simple ring over some points, exactly right also where vertices lie on straight runs.

    Raises
    ------
    InvalidPolygon
        If the ring touches itself.
    """
    return triangulate_rings(points, Rings.of([ring]))


def triangulate_rings(points: Points, rings: Rings) -> Triangulation:
    """Triangulate many simple rings over the same points, each for itself.

    Raises
    ------
    InvalidPolygon
        If a ring touches itself.
    """
    corner = points.orientation(rings.rows[rings.preceding], rings.rows, rings.rows[rings.following]) != 0
    counts = np.bincount(rings.owner[corner], minlength=len(rings.counts))
    corners = Rings(rings.rows[corner], counts)
    triangles = _delaunay(points, corners)
    if triangles is None:
        triangles = np.concatenate([_one_by_one(points, ring) + first for ring, first in corners.parts()])
    triangles = np.flatnonzero(corner)[triangles]
    runs = _runs(corner, rings)
    if runs:
        triangles = np.array(_split_runs(triangles.tolist(), runs), dtype=np.intp).reshape(-1, 3)
    triangles = _sorted(triangles)
    return Triangulation(points, rings, triangles, _twins(triangles))


def _sorted(triangles: Indices) -> Indices:
    """Sort triangles, each from its least corner on: so their order is not that in which they were found."""
    least = triangles.argmin(axis=1)[:, None]
    triangles = np.take_along_axis(triangles, (least + np.arange(3)) % 3, axis=1)
    return triangles[np.lexsort(triangles.T[::-1])]


def _one_by_one(points: Points, ring: Indices) -> Indices:
    triangles = _delaunay(points, Rings.of([ring]))
    return _cut_ears(points, ring) if triangles is None else triangles


def _delaunay(points: Points, corners: Rings) -> Indices | None:
    """Let GEOS triangulate; believe it only if every triangle and every edge proves right."""
    coordinates = points.coordinates[corners.rows]
    polygons = shapely.polygons(shapely.linearrings(coordinates, indices=corners.owner))
    try:
        parts = shapely.constrained_delaunay_triangles(polygons)
    except shapely.GEOSException:  # lost its way among vertices that are all but collinear
        return None
    found, ring = shapely.get_coordinates(parts, return_index=True)
    found, ring = found.reshape(-1, 4, 2)[:, :3], ring.reshape(-1, 4)[:, :3]
    triangles = _vertices_at(found.reshape(-1, 2), ring.ravel(), coordinates, corners).reshape(-1, 3)
    counts = np.bincount(ring[:, 0], minlength=len(corners.counts))
    if (counts != corners.counts - 2).any() or triangles.min(initial=0) < 0:
        return None
    turns = points.orientation(*corners.rows[triangles].T)
    triangles[turns < 0] = triangles[turns < 0][:, ::-1]
    return triangles if (turns != 0).all() and _tiles(triangles, corners) else None


def _vertices_at(places: Floats, ring: Indices, coordinates: Floats, rings: Rings) -> Indices:
    """Give for each place, seen in a ring, the vertex of the ring that is there, or -1."""
    key, wanted = _key(coordinates, rings.owner), _key(places, ring)
    order = key.argsort()
    found = order.take(key.take(order).searchsorted(wanted), mode="clip")
    there = (coordinates.take(found, axis=0) == places).all(axis=1) & (rings.owner[found] == ring)
    return np.where(there, found, -1)


def _key(places: Floats, ring: Indices) -> NDArray[np.uint64]:
    """Mix the bits of places and rings to numbers that all but never agree for two that differ."""
    bits = (places + 0.0).view(np.uint64)  # adding zero makes -0.0 the same as 0.0
    x, y = (bits ^ (bits >> np.uint64(32))).T  # signs and round numbers differ in the highest bits only
    key: NDArray[np.uint64] = (x * _ODD + y) * _ODD + ring.astype(np.uint64)
    return key


def _tiles(triangles: Indices, rings: Rings) -> bool:
    """Tell whether counter-clockwise triangles fit together along their edges and end at the rings."""
    starts, ends = _half_edges(triangles)
    twins = _twins(triangles)
    outer, inner = np.flatnonzero(twins < 0), np.flatnonzero(twins >= 0)
    return (
        len(outer) == len(rings.rows) == np.count_nonzero(np.bincount(starts[outer]))
        and bool((ends[outer] == rings.following[starts[outer]]).all())
        and bool((starts[twins[inner]] == ends[inner]).all())
        and bool((twins[twins[inner]] == inner).all())  # no edge is there a third time
    )


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


def _runs(corner: Flags, rings: Rings) -> dict[tuple[int, int], list[int]]:
    """Give for each edge between corners the straight vertices on it, in order, if there are any."""
    runs = {}
    for start in np.flatnonzero(corner & ~corner[rings.following]).tolist():
        run = []
        vertex = int(rings.following[start])
        while not corner[vertex]:
            run.append(vertex)
            vertex = int(rings.following[vertex])
        runs[start, vertex] = run
    return runs


def _split_runs(waiting: list[Triangle], runs: dict[tuple[int, int], list[int]]) -> list[Triangle]:
    """Split triangles at straight vertices into fans from the opposite corner."""
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
    """Give for each half-edge another one between the same vertices, or -1."""
    starts, ends = _half_edges(triangles)
    key = np.minimum(starts, ends) * len(starts) + np.maximum(starts, ends)
    order = key.argsort(kind="stable")
    key = key.take(order)
    shared = np.flatnonzero(key[1:] == key[:-1])
    twins = np.full(len(starts), -1)
    one, other = order[shared], order[shared + 1]
    twins[one], twins[other] = other, one
    return twins


def _half_edges(triangles: Indices) -> tuple[Indices, Indices]:
    return triangles.ravel(), triangles[:, (1, 2, 0)].ravel()
