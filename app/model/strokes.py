"""Lines drawn by hand, closed to a ring."""

import numpy as np
import shapely

from starskel.arrays import Floats
from starskel.crossings import crossing_edges

LOOP = 0.3
"""The longest loop that is cut off, as a part of the whole length."""

MOST = 50
"""Loops that are cut off; a scribble has more."""


def closed(line: Floats, reach: float = 0.0) -> Floats:
    """Close a line to a ring; ends that overshoot and small loops on the way are cut off where they cross.

    Parameters
    ----------
    line : (k, 2) array
        At least three points, no two in a row equal.
    reach : float
        A line that comes so near to its start ends there, wherever it goes on to.

    Returns
    -------
    (m, 2) array
        A ring that does not cross itself; or the line as it is, where that would take more than `LOOP` of it.
    """
    line = _ended(line, reach)
    ring, longest = line, LOOP * _lengths(line).sum()
    for _ in range(MOST):
        pairs = crossing_edges(ring)
        if not len(pairs):
            return ring
        lengths = _lengths(ring)
        along = np.cumsum(lengths)
        between = along[pairs[:, 1]] - along[pairs[:, 0]]
        loops = np.minimum(between, along[-1] - between)
        smallest = int(loops.argmin())
        if loops[smallest] > longest:
            break
        ring = _without_loop(ring, *pairs[smallest], inner=between[smallest] <= along[-1] / 2)
    return line


def _ended(line: Floats, reach: float) -> Floats:
    """Cut off the end of a line from where it is back at its start."""
    along = np.append(0.0, np.cumsum(_lengths(line)[:-1]))
    back = (along > (1 - LOOP) * along[-1]) & (np.hypot(*(line - line[0]).T) <= reach)
    return line[: back.argmax()] if back.any() and back.argmax() >= 3 else line


def _lengths(ring: Floats) -> Floats:
    lengths: Floats = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
    return lengths


def _without_loop(ring: Floats, i: int, j: int, *, inner: bool) -> Floats:
    """Cut off the loop between edges i and j, which cross, or all but that loop."""
    first, second = (shapely.linestrings(ring[[k, (k + 1) % len(ring)]]) for k in (i, j))
    corner = shapely.get_coordinates(shapely.intersection(first, second))[:1]
    parts = (ring[: i + 1], corner, ring[j + 1 :]) if inner else (corner, ring[i + 1 : j + 1])
    cut = np.concatenate(parts)
    repeated = (cut == np.roll(cut, 1, axis=0)).all(axis=1)
    distinct: Floats = cut[~repeated]
    return distinct
