"""Triangulating rings: the ground that visibility expands over.

Libraries triangulate, and are believed only where every triangle and every edge proves right. Elsewhere,
among vertices that are all but collinear, ears are cut exactly.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import mapbox_earcut
import numpy as np
import shapely
from numpy.typing import NDArray

from starskel.arrays import Flags, Floats, Indices
from starskel.ears import Triangle, cut_ears
from starskel.points import Points
from starskel.rings import Rings

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

    @classmethod
    def of(cls, points: Points, rings: Rings, triangles: Indices) -> "Triangulation":
        """Find which triangles lie side by side."""
        return cls(points, rings, triangles, _twins(triangles))

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

    @property
    def tiles(self) -> bool:
        """Whether triangles without straight vertices between them do tile the rings, exactly."""
        rings, twins = self.rings, self.twins
        if len(self.triangles) != len(rings.rows) - 2 * len(rings.counts):
            return False
        starts, ends = _half_edges(self.triangles)
        outer, inner = (twins < 0).nonzero()[0], (twins >= 0).nonzero()[0]
        other = twins.take(inner)
        return (
            bool((self.points.orientation(*rings.rows.take(self.triangles.T)) > 0).all())
            and len(outer) == len(rings.rows) == np.count_nonzero(np.bincount(starts.take(outer)))
            and bool((ends.take(outer) == rings.following.take(starts.take(outer))).all())
            and bool((starts.take(other) == ends.take(inner)).all())
            and bool((twins.take(other) == inner).all())  # no edge is there a third time
        )


Grounds = tuple[Triangulation, Triangulation]
"""The same rings triangulated in the source and in the target."""


def triangulate(points: Points, rings: Rings) -> Triangulation:
    """Triangulate simple rings over some points in any way: fast, for views, to which all ways are alike.

    Vertices may lie on straight runs.

    Raises
    ------
    InvalidPolygon
        If a ring touches itself.
    """
    return _with_runs(points, rings, lambda corners: _proven(points, corners, _by_earcut))


def delaunay(points: Points, rings: Rings) -> Triangulation:
    """Triangulate simple rings by triangles as fat as can be, the same ones wherever a ring starts.

    They are the constrained Delaunay triangles of the rings' corners, split where vertices lie on straight
    runs. It takes some 20 times as long as just any triangles.

    Raises
    ------
    InvalidPolygon
        If a ring touches itself.
    """
    return _with_runs(points, rings, lambda corners: _proven(points, corners, _by_geos))


def _with_runs(points: Points, rings: Rings, cut: Callable[[Rings], Triangulation]) -> Triangulation:
    """Triangulate the corners of rings, and split what has straight vertices on its edges."""
    corner = points.orientation(rings.rows[rings.preceding], rings.rows, rings.rows[rings.following]) != 0
    if corner.all():
        return cut(rings)
    counts = np.bincount(rings.owner[corner], minlength=len(rings.counts))
    triangles = np.flatnonzero(corner)[cut(Rings(rings.rows[corner], counts)).triangles]
    split = np.array(_split_runs(triangles.tolist(), _runs(corner, rings)), dtype=np.intp).reshape(-1, 3)
    return Triangulation.of(points, rings, _sorted(split))


def _proven(points: Points, corners: Rings, find: Callable[[Points, Rings], Indices | None]) -> Triangulation:
    """Give what is found, if it proves right; if not, ring by ring, and exactly where it is still wrong."""
    triangles = find(points, corners)
    if triangles is not None:
        found = Triangulation.of(points, corners, triangles)
        if found.tiles:
            return found
    if len(corners.counts) == 1:
        exact = _sorted(cut_ears(points, corners.rows))
        return Triangulation.of(points, corners, exact)
    parts = [_proven(points, Rings.of([r]), find).triangles + first for r, first in corners.parts()]
    return Triangulation.of(points, corners, np.concatenate(parts))


def _by_earcut(points: Points, corners: Rings) -> Indices:
    """Let Earcut triangulate."""
    coordinates = points.coordinates[corners.rows]
    parts = [
        mapbox_earcut.triangulate_float64(coordinates[a : a + count], np.array([count], dtype=np.uint32)) + a
        for a, count in zip(corners.first.tolist(), corners.counts.tolist(), strict=True)
    ]
    return np.concatenate(parts).astype(np.intp).reshape(-1, 3)


def _by_geos(points: Points, corners: Rings) -> Indices | None:
    """Let GEOS find the constrained Delaunay triangles, and name the vertices at their corners."""
    coordinates = points.coordinates[corners.rows]
    polygons = shapely.polygons(shapely.linearrings(coordinates, indices=corners.owner))
    try:
        parts = shapely.constrained_delaunay_triangles(polygons)
    except shapely.GEOSException:  # lost its way among vertices that are all but collinear
        return None
    found, ring = shapely.get_coordinates(parts, return_index=True)
    found, ring = found.reshape(-1, 4, 2)[:, :3], ring.reshape(-1, 4)[:, :3]
    triangles = _vertices_at(found.reshape(-1, 2), ring.ravel(), coordinates, corners).reshape(-1, 3)
    if triangles.min(initial=0) < 0:
        return None
    clockwise = points.orientation(*corners.rows[triangles.T]) < 0
    triangles[clockwise] = triangles[clockwise][:, ::-1]
    return _sorted(triangles)


def _sorted(triangles: Indices) -> Indices:
    """Sort triangles, each from its least corner on: so their order is not that in which they were found."""
    least = triangles.argmin(axis=1)[:, None]
    triangles = np.take_along_axis(triangles, (least + np.arange(3)) % 3, axis=1)
    return triangles[np.lexsort(triangles.T[::-1])]


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
    order = key.argsort()
    key = key.take(order)
    shared = np.flatnonzero(key[1:] == key[:-1])
    twins = np.full(len(starts), -1)
    one, other = order[shared], order[shared + 1]
    twins[one], twins[other] = other, one
    return twins


def _half_edges(triangles: Indices) -> tuple[Indices, Indices]:
    return triangles.ravel(), triangles[:, (1, 2, 0)].ravel()
