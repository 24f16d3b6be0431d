"""How near a moving ring comes to touching itself, over all of the motion and not only at samples.

Seen from a vertex in even motion, both ends of an edge stay in the hull of where they begin and end: no
nearer than that hull is the edge, at any moment. The hull's distance is found by the separating line across
the nearest point. Motions for which that says too little are halved.
"""

from itertools import pairwise

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.certificate import near_pairs, seen_ends
from starskel.outline import edge_lengths
from starskel.polar import as_complex
from starskel.task import UNWATCHED, Task

TIGHT = 0.9
"""The figure given is at least this part of the true one."""

_HALVINGS = 40
"""The most halvings: of a motion that touches, no hull says anything."""

_SIDES = np.array([(i, j) for i in range(4) for j in range(i)]).T
"""The pairs of corners of a hull of four points: its sides are among them."""

_MOST_HALVINGS = 6
"""The most halvings where a distance is asked for: it may be all but reached all the time."""


def clearance(keys: Floats, task: Task = UNWATCHED) -> float:
    """Give a lower bound of the distance that vertices keep from edges that they are no end of.

    It is short of the true distance by a tenth at most, and right but for rounding.

    Parameters
    ----------
    keys : (k, n, 2) array
        Frames, each moving evenly to the next.
    task : Task, optional

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    known = float(edge_lengths(keys).min())  # neighbours' other edges are no farther than this
    rows = as_complex(keys)
    for at, (first, second) in enumerate(pairwise(rows)):
        task.reach(at / len(rows))
        for vertex, edge in near_pairs(first, second, known):
            corners = np.stack([*seen_ends(first, vertex, edge), *seen_ends(second, vertex, edge)])
            known = _least(corners, known)
    return TIGHT * known


def _least(corners: Complex, known: float) -> float:
    """Give the least distance of (4, k) edges in motion, two ends before and two after, or what is known."""
    for _ in range(_HALVINGS):
        corners = corners[:, _bounds(corners) < TIGHT * known]
        if not corners.shape[1]:
            return known
        known = min(known, float(_least_at_times(corners).min()))
        corners = _halves(corners)
    return 0.0


def nearer_pairs(
    before: Complex, after: Complex, vertex: Indices, edge: Indices, distance: float
) -> tuple[Indices, Indices]:
    """Give those of some pairs of a vertex and an edge that may come nearer than a distance."""
    corners = np.stack([*seen_ends(before, vertex, edge), *seen_ends(after, vertex, edge)])
    near = _bounds(corners) < distance
    return vertex[near], edge[near]


def stay_clear(before: Complex, after: Complex, vertex: Indices, edge: Indices, floors: Floats) -> bool:
    """Tell whether pairs of a vertex and an edge keep their distances while a ring moves evenly.

    The answer is right where it is yes, but for rounding; it may be no where a distance is all but reached.

    Parameters
    ----------
    before, after : (n,) complex arrays
    vertex, edge, floors : (k,) arrays
        The pairs, and the distances to be kept.
    """
    corners = np.stack([*seen_ends(before, vertex, edge), *seen_ends(after, vertex, edge)])
    for _ in range(_MOST_HALVINGS):
        near = _bounds(corners) < floors
        corners, floors = corners[:, near], floors[near]
        if not len(floors):
            return True
        if (_least_at_times(corners) < floors).any():
            return False
        corners, floors = _halves(corners), np.tile(floors, 2)
    return False


def _least_at_times(corners: Complex) -> Floats:
    """Give the least of the distances before, after and half-way between."""
    before, after = corners[:2], corners[2:]
    edges = np.stack([before, (before + after) / 2, after], axis=1)
    return np.asarray(np.abs(_nearest(*edges)).min(axis=0))


def _halves(corners: Complex) -> Complex:
    before, after = corners[:2], corners[2:]
    middle = (before + after) / 2
    return np.concatenate([np.concatenate([before, middle]), np.concatenate([middle, after])], axis=1)


def _nearest(p: Complex, q: Complex) -> Complex:
    """Give the points nearest to zero on the lines from p to q."""
    along = q - p
    squared = along.real**2 + along.imag**2
    share = -(along.real * p.real + along.imag * p.imag) / np.where(squared > 0, squared, 1.0)
    return np.asarray(p + np.minimum(np.maximum(share, 0.0), 1.0) * along)


def _bounds(corners: Complex) -> Floats:
    """Give lower bounds of how far from zero the hulls of (4, k) points are; 0 where zero may be inside."""
    nearest = _nearest(*corners[_SIDES])
    distance = np.abs(nearest)
    normals = nearest.conj() / np.where(distance > 0, distance, 1.0)
    along = (corners * normals[:, None]).real
    return np.asarray(np.maximum(along.min(axis=1).max(axis=0), 0.0))
