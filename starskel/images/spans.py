"""Triangles to runs of pixels: every pixel whose middle lies in a mesh belongs to one of its triangles."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.rings import ranges


@dataclass(frozen=True, eq=False)
class Spans:
    """Runs of pixels, each in one row and one triangle, in the order of the triangles.

    Attributes
    ----------
    triangles : (s,) array of int
    first : (s,) array of int
        The run's first pixel, counted through all rows.
    counts : (s,) array of int
        How many pixels it has, at least 1.
    start, step : (c, s) arrays
        The values that go evenly over the triangle: at the middle of the first pixel, and from one pixel to
        the next.
    """

    triangles: Indices
    first: Indices
    counts: Indices
    start: Floats
    step: Floats

    def __len__(self) -> int:
        return len(self.first)


def spans_of(places: Floats, triangles: Indices, values: Floats, size: tuple[int, int]) -> Spans:
    """Give the runs of pixels of triangles.

    Where two triangles share an edge, its crossing with a row is the same number for both, so no pixel is
    left out or taken twice; values come from the crossings, so they never leave what they are at the corners.

    Parameters
    ----------
    places : (m, 2) array
        In pixels, right and down.
    triangles : (k, 3) array of int
    values : (m, c) array
        What goes evenly over each triangle.
    size : (int, int)
        Width and height of the image; what lies outside is left out.
    """
    width, height = size
    left, right = _halves(places, triangles)
    rows = np.ceil(places[:, 1] - 0.5).clip(0, height).astype(np.intp)
    begin = np.maximum(rows[left[0]], rows[right[0]])
    times = np.minimum(rows[left[1]], rows[right[1]]) - begin
    owners, row = ranges(begin, times)
    near, far = (_shares(places[:, 1], side, times, row) for side in (left, right))
    x0, x1 = _between(places[:, 0], left, near, times), _between(places[:, 0], right, far, times)
    first = np.ceil(x0 - 0.5).clip(0, width).astype(np.intp)
    counts = np.ceil(x1 - 0.5).clip(0, width).astype(np.intp) - first
    kept = np.flatnonzero(counts > 0)
    owners, row, first, x0, x1 = owners[kept], row[kept], first[kept], x0[kept], x1[kept]
    near, far, times = near[kept], far[kept], np.bincount(owners, minlength=len(times))
    start, step = (np.empty((values.shape[1], len(kept))) for _ in range(2))
    ahead, across = first + 0.5 - x0, 1 / (x1 - x0)
    for number, value in enumerate(values.T):
        begin_value = _between(value, left, near, times)
        step[number] = (_between(value, right, far, times) - begin_value) * across
        start[number] = begin_value + ahead * step[number]
    return Spans(owners // 2, row * width + first, counts[kept], start, step)


Sides = tuple[Indices, Indices]
"""The upper and the lower ends of sides."""


def _halves(places: Floats, triangles: Indices) -> tuple[Sides, Sides]:
    """Cut each triangle at its middle corner's row; give the left and right sides of the (2 k) halves.

    A side may reach beyond its half: the rows of a half are those that both its sides have.
    """
    order = np.argsort(places[triangles, 1], axis=1, kind="stable")
    a, b, c = np.take_along_axis(triangles, order, axis=1).T
    (ax, ay), (bx, by), (cx, cy) = places[a].T, places[b].T, places[c].T
    swapped = np.repeat((bx - ax) * (cy - ay) > (cx - ax) * (by - ay), 2)
    short = np.stack([a, b], axis=1).ravel(), np.stack([b, c], axis=1).ravel()
    long = np.repeat(a, 2), np.repeat(c, 2)
    left = np.where(swapped, long[0], short[0]), np.where(swapped, long[1], short[1])
    right = np.where(swapped, short[0], long[0]), np.where(swapped, short[1], long[1])
    return left, right


def _shares(y: Floats, sides: Sides, times: Indices, rows: Indices) -> Floats:
    """Give where sides, each so many times, cross the middles of rows, as shares of the way down."""
    upper, lower = y[sides[0]], y[sides[1]]
    height = np.where(lower > upper, lower - upper, 1.0)
    return np.asarray((rows + 0.5 - np.repeat(upper, times)) / np.repeat(height, times))


def _between(value: Floats, sides: Sides, shares: Floats, times: Indices) -> Floats:
    """Give a value at shares of sides, of each so many."""
    start = value[sides[0]]
    return np.asarray(np.repeat(start, times) + shares * np.repeat(value[sides[1]] - start, times))
