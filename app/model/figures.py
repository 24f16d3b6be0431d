"""Rings of regular figures, counter-clockwise."""

import numpy as np

from app.model.point import Point
from starskel.arrays import Floats


def rectangle(corner: Point, opposite: Point) -> Floats:
    """Give the upright rectangle between two corners, from the lower left one on, (4, 2)."""
    (left, low), (right, high) = np.sort([corner, opposite], axis=0)
    return np.array([(left, low), (right, low), (right, high), (left, high)])


def ellipse(corner: Point, opposite: Point, count: int) -> Floats:
    """Give so many points of the ellipse that fills the upright box between two corners, (count, 2)."""
    low, high = np.sort([corner, opposite], axis=0)
    ring: Floats = (low + high) / 2 + _round(count) * (high - low) / 2
    return ring


def regular_polygon(centre: Point, corner: Point, count: int) -> Floats:
    """Give the regular polygon about a centre that has a vertex at a corner, (count, 2)."""
    return _about(centre, corner, _round(count))


def star(centre: Point, tip: Point, points: int, inner: float) -> Floats:
    """Give a star about a centre with a point at a tip, (2 points, 2).

    `inner` is the distance of its inner vertices from the centre as a part of that of its points.
    """
    ring = _round(2 * points)
    ring[1::2] *= inner
    return _about(centre, tip, ring)


def _round(count: int) -> Floats:
    """Give points on the unit circle from (1, 0) on."""
    angles = 2 * np.pi * np.arange(count) / count
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _about(centre: Point, tip: Point, ring: Floats) -> Floats:
    """Turn and scale a ring about (0, 0) so that (1, 0) comes to the tip."""
    x, y = np.subtract(tip, centre)
    placed: Floats = centre + ring @ np.array([(x, y), (-y, x)])
    return placed
