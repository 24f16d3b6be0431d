"""Triangles as libraries find them: not yet proven."""

import mapbox_earcut
import numpy as np
import shapely
from numpy.typing import NDArray

from starskel.arrays import Floats, Indices
from starskel.points import Points
from starskel.rings import Rings

_ODD = np.uint64(0x9E3779B97F4A7C15)
"""A multiplier that spreads all bits: 2^64 divided by the golden ratio."""


def by_earcut(points: Points, corners: Rings) -> Indices:
    """Let Earcut triangulate."""
    coordinates = points.coordinates[corners.rows]
    parts = [
        mapbox_earcut.triangulate_float64(coordinates[a : a + count], np.array([count], dtype=np.uint32)) + a
        for a, count in zip(corners.first.tolist(), corners.counts.tolist(), strict=True)
    ]
    return np.concatenate(parts).astype(np.intp).reshape(-1, 3)


def by_geos(points: Points, corners: Rings) -> Indices | None:
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
    return in_order(triangles)


def in_order(triangles: Indices) -> Indices:
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
