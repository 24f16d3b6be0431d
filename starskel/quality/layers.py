"""Natural crossings: the polygon would be valid in a world of two and a half dimensions (paper, figure 11).

The rule: a crossing is natural where the outline bounds a sheet that lies flat, this side up everywhere, but
may lie over itself: an immersed disk. The outline is all that counts, so the rule is the same for every
method. An outline bounds such a sheet where it turns round once in all and can be cut, as a string of
vertices, into triangles that all run counter-clockwise (Shor and Van Wyk 1992, "Detecting and Decomposing
Self-Overlapping Curves"); then no part of it has a negative winding number.

The triangles are sought in O(n^3). Before that all corners are cut off whose triangle nothing else enters:
the sheet only loses or gains that triangle. Few vertices are left round the crossings.
"""

import numpy as np
import shapely

from starskel.arrays import Flags, Floats, Indices, Signs
from starskel.outline import turning_angles
from starskel.predicates import folds_back, orientation, segments_meet
from starskel.task import UNWATCHED, Task


def in_layers(ring: Floats, task: Task = UNWATCHED) -> bool:
    """Tell whether an (n, 2) ring bounds an immersed disk, exactly.

    Rings with repeated vertices or edges that fold back do not.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    before, after = np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0)
    if (ring == after).all(axis=1).any() or folds_back(before, ring, after).any():
        return False
    turns = float(turning_angles(ring).sum()) / (2 * np.pi)
    return round(turns) == 1 and _can_be_filled(_with_corners_cut(ring, task), task)


def _with_corners_cut(ring: Floats, task: Task) -> Floats:
    """Leave out vertices, every second one in turn, while there are empty corners."""
    count, first = len(ring) + 1, 0
    while len(ring) > 4:
        if first == 0 and len(ring) == count:
            return ring
        task.reach(0)
        count = len(ring) if first == 0 else count
        ring = np.delete(ring, _empty_corners(ring, first), axis=0)
        first = 1 - first
    return ring


def _empty_corners(ring: Floats, first: int) -> Indices:
    """Give those of every second vertex whose triangle no other part of the ring touches.

    It is enough that nothing crosses its sides: what enters it must leave it again, or end in it.
    """
    n = len(ring)
    corner = np.arange(first, n - 1 + first, 2)
    a, b, c = ring[corner - 1], ring[corner], ring[(corner + 1) % n]
    turn = orientation(a, b, c)
    blocked = _enters(turn, a, b, c, ring[corner - 2]) | _enters(-turn, c, b, a, ring[(corner + 2) % n])
    starts, ends = ring, np.roll(ring, -1, axis=0)
    tree = shapely.STRtree(shapely.linestrings(np.stack([starts, ends], axis=1)))
    low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
    owner, edge = tree.query(shapely.box(*low.T, *high.T))
    foreign = (edge - corner[owner] + 2) % n > 3
    owner, edge = owner[foreign], edge[foreign]
    for p, q in ((a, b), (b, c), (a, c)):
        blocked[owner[segments_meet(p[owner], q[owner], starts[edge], ends[edge])]] = True
    return np.asarray(corner[~blocked | (turn == 0)])


def _enters(turn: Signs, a: Floats, b: Floats, c: Floats, other: Floats) -> Flags:
    """Tell whether the way from a to the other point begins in the triangle that turns so, or on its side."""
    return np.asarray((turn * orientation(a, b, other) >= 0) & (turn * orientation(a, c, other) <= 0))


def _can_be_filled(ring: Floats, task: Task) -> bool:
    """Tell whether the string of vertices can be cut into counter-clockwise triangles."""
    n = len(ring)
    filled = np.eye(n, k=1, dtype=np.bool_)
    for span in range(2, n):
        task.reach(0)
        i = np.arange(n - span)[:, None]
        k, j = i + np.arange(1, span), i + span
        row, step = np.nonzero(filled[i, k] & filled[k, j])
        first, middle, last = row, row + step + 1, row + span
        left = orientation(ring[first], ring[middle], ring[last]) > 0
        filled[first[left], last[left]] = True
    return bool(filled[0, n - 1])
