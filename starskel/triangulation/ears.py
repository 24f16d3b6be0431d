"""Cutting ears off a ring exactly, for rings too nearly degenerate for floating point."""

import numpy as np

from starskel.arrays import Indices
from starskel.errors import InvalidPolygon, told
from starskel.points import Points


def cut_ears(points: Points, corners: Indices) -> Indices:
    """Triangulate a ring without straight vertices; O(n^2).

    Returns
    -------
    (n - 2, 3) array of int
        Corners as vertices of the ring, counter-clockwise.

    Raises
    ------
    InvalidPolygon
        If the ring touches itself.
    """
    left = list(range(len(corners)))
    ears: list[tuple[int, int, int]] = []
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


def _is_ear(points: Points, corners: Indices, ear: tuple[int, int, int], left: Indices) -> bool:
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
