"""Kernels: from where a ring is seen whole."""

import numpy as np

from starskel.points import Points, points_of
from starskel.polygon import signed_area
from starskel.predicates import ROUNDING, Floats, orientation


def star_vertices(ring: Floats) -> np.ndarray:
    """Give for each vertex of a simple ring whether it lies in the kernel, exactly."""
    points = points_of(ring)
    start, end = _edges(points)
    viewers = np.arange(len(ring))[:, None]
    return np.asarray(np.all(points.orientation(start[None], end[None], viewers) >= 0, axis=1))


def star_point(ring: Floats) -> Floats | None:
    """Give a point strictly inside the kernel: the kernel's centroid; None where the kernel has no inside.

    The answer is proven by exact predicates; a kernel too thin for floats to name a point in it is none.
    """
    points = points_of(ring)
    start, end = (ring[rows] for rows in _edges(points))
    cell = _clip(ring, start, end)
    if len(cell) < 3:
        return None
    centre = _centroid(cell)
    return centre if (orientation(start, end, centre[None]) > 0).all() else None


def is_star_point(ring: Floats, place: Floats) -> bool:
    """Tell whether a place, known up to rounding, sees the whole of a simple ring, its boundary included."""
    start, end = (ring[rows] for rows in _edges(points_of(ring)))
    edge = end - start
    normal = np.stack([-edge[:, 1], edge[:, 0]], axis=1) / np.hypot(*edge.T)[:, None]
    inward = (normal * (place - start)).sum(axis=1)
    return bool((inward >= -ROUNDING * np.abs(ring).max()).all())


def _edges(points: Points) -> tuple[np.ndarray, np.ndarray]:
    """Give the corners at the starts and ends of the edges; straight vertices bound nothing."""
    corners = np.flatnonzero(~points.straight)
    return corners, np.roll(corners, -1)


def _clip(ring: Floats, start: Floats, end: Floats) -> Floats:
    """Cut the box of the ring to the left sides of all edges."""
    (left, low), (right, high) = ring.min(axis=0), ring.max(axis=0)
    cell = np.array([(left, low), (right, low), (right, high), (left, high)])
    for a, b in zip(start, end, strict=True):
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
    area = signed_area(cell)
    if not area > 0:
        return np.asarray(cell.mean(axis=0))
    base = cell[0]
    a, b = cell[1:-1] - base, cell[2:] - base
    doubled = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return np.asarray(base + (doubled[:, None] * (a + b)).sum(axis=0) / (6 * area))
