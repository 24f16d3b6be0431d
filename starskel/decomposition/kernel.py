"""Kernels: from where a ring is seen whole."""

import numpy as np

from starskel.outline import signed_areas
from starskel.points import Indices, Points, points_of
from starskel.predicates import ROUNDING, Floats
from starskel.visibility import Relation

_AT_ONCE = 64


def star_vertices(points: Points, ring: Indices) -> Relation:
    """Give for each vertex of a simple ring over points whether it lies in the kernel, exactly."""
    stars = np.ones(len(ring), dtype=bool)
    ends = np.roll(ring, -1)
    for first in range(0, len(ring), _AT_ONCE):  # few edges leave few vertices to look at
        edges = slice(first, first + _AT_ONCE)
        sides = points.orientation(ring[edges][None], ends[edges][None], ring[stars, None])
        stars[stars] = (sides >= 0).all(axis=1)
    return stars


def star_point(points: Points, ring: Indices) -> Floats | None:
    """Give a point strictly inside the kernel: the kernel's centroid; None where the kernel has no inside.

    The answer is proven by exact predicates; a kernel too thin for floats to name a point in it is none.
    """
    cell = _clip(points.coordinates[ring[_corners(points, ring)]])
    if len(cell) < 3:
        return None
    centre = _centroid(cell)
    sides = points.with_free(centre[None]).orientation(
        ring, np.roll(ring, -1), np.array(len(points.coordinates))
    )
    return centre if (sides > 0).all() else None


def is_star_point(ring: Floats, place: Floats) -> bool:
    """Tell whether a place, known up to rounding, sees the whole of a simple ring, its boundary included."""
    points = points_of(ring)
    start = ring[_corners(points, np.arange(len(ring)))]
    edge = np.roll(start, -1, axis=0) - start
    normal = np.stack([-edge[:, 1], edge[:, 0]], axis=1) / np.hypot(*edge.T)[:, None]
    inward = (normal * (place - start)).sum(axis=1)
    return bool((inward >= -ROUNDING * np.abs(ring).max()).all())


def _corners(points: Points, ring: Indices) -> Indices:
    """Give the places in the ring of its corners; straight vertices bound nothing."""
    return np.flatnonzero(points.orientation(np.roll(ring, 1), ring, np.roll(ring, -1)))


def _clip(ring: Floats) -> Floats:
    """Cut the box of the ring to the left sides of all edges."""
    if not len(ring):  # all vertices lie on one line
        return ring
    (left, low), (right, high) = ring.min(axis=0), ring.max(axis=0)
    cell = np.array([(left, low), (right, low), (right, high), (left, high)])
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        side = (b[0] - a[0]) * (cell[:, 1] - a[1]) - (b[1] - a[1]) * (cell[:, 0] - a[0])
        if side.min() >= 0:
            continue
        if side.max() <= 0:
            return cell[:0]
        cell = _cut(cell, side)
    return cell


def _cut(cell: Floats, side: Floats) -> Floats:
    """Keep the part of a convex cell where the side is not negative."""
    following, beyond = np.roll(cell, -1, axis=0), np.roll(side, -1)
    crossing = side * beyond < 0
    share = np.divide(side, side - beyond, out=np.zeros_like(side), where=crossing)
    corners = np.stack([cell, cell + share[:, None] * (following - cell)], axis=1)
    kept: Floats = corners[np.stack([side >= 0, crossing], axis=1)]
    return kept


def _centroid(cell: Floats) -> Floats:
    area = signed_areas(cell)
    if not area > 0:
        return np.asarray(cell.mean(axis=0))
    base = cell[0]
    a, b = cell[1:-1] - base, cell[2:] - base
    doubled = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return np.asarray(base + (doubled[:, None] * (a + b)).sum(axis=0) / (6 * area))
