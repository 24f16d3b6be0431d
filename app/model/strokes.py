"""Lines drawn by hand, closed to a ring."""

import numpy as np
import shapely

from starskel.polygon import crossing_edges
from starskel.predicates import Floats

TAIL = 0.3
"""What may be cut off a line's two ends, as a part of its length, where they cross."""


def closed(line: Floats) -> Floats:
    """Close a line to a ring; where its ends cross, what is beyond the crossing goes.

    Parameters
    ----------
    line : (k, 2) array
        At least three points, no two in a row equal.

    Returns
    -------
    (m, 2) array
        The ring; it crosses itself where the line does so elsewhere than at its ends.
    """
    line = line[:-1] if (line[0] == line[-1]).all() else line
    pairs = crossing_edges(line)
    lengths = np.hypot(*np.diff(line, axis=0, append=line[:1]).T)
    before = np.concatenate([[0.0], np.cumsum(lengths)])[:-1]
    waste = before[pairs[:, 0]] + (before[-1] - before[pairs[:, 1]])
    allowed = waste <= TAIL * before[-1]
    for i, j in pairs[allowed][np.argsort(waste[allowed], kind="stable")].tolist():
        ring = _cut(line, i, j)
        if len(ring) >= 3 and not len(crossing_edges(ring)):
            return ring
    return line


def _cut(line: Floats, i: int, j: int) -> Floats:
    """Give the loop that begins and ends where edge i crosses edge j."""
    first, second = (shapely.linestrings(line[[k, (k + 1) % len(line)]]) for k in (i, j))
    corner = shapely.get_coordinates(shapely.intersection(first, second))[:1]
    loop = line[i + 1 : j + 1]
    return loop if len(corner) and (loop == corner).all(axis=1).any() else np.concatenate([corner, loop])
