"""How near a moving ring comes to touching itself, over all of the motion and not only at samples.

Seen from a vertex in even motion, both ends of an edge stay in the hull of where they begin and end: no
nearer than that hull is the edge, at any moment. The hull's distance is found by the separating line across
the nearest point. Motions for which that says too little are halved.
"""

from itertools import pairwise
from typing import NamedTuple

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
        corners = corners[:, _rough_bounds(corners) < TIGHT * known]
        corners = corners[:, _bounds(corners) < TIGHT * known]
        if not corners.shape[1]:
            return known
        known = min(known, float(_least_at_times(corners).min()))
        corners = _halves(corners)
    return 0.0


class Swept(NamedTuple):
    """Pairs of a vertex and an edge while a ring moves evenly.

    Attributes
    ----------
    vertex, edge : (k,) arrays
        The pairs; an edge counts by its first end.
    corners : (4, k) complex array
        Both ends of the edge as seen from the vertex, before and after.
    bounds : (k,) array
        A lower bound of how near they come, right but for rounding.
    """

    vertex: Indices
    edge: Indices
    corners: Complex
    bounds: Floats

    @classmethod
    def nearer(
        cls, before: Complex, after: Complex, vertex: Indices, edge: Indices, distance: float
    ) -> "Swept":
        """Give those of some pairs that may come nearer than a distance, from one (n,) frame to another."""
        corners = np.array([*seen_ends(before, vertex, edge), *seen_ends(after, vertex, edge)])
        near = np.flatnonzero(_rough_bounds(corners) < distance)
        bounds = _bounds(corners[:, near])
        near, bounds = near[bounds < distance], bounds[bounds < distance]
        return cls(vertex[near], edge[near], corners[:, near], bounds)

    def keep(self, floors: Floats) -> bool:
        """Tell whether all keep their distances, (k,); it may be no where one is all but reached."""
        near = self.bounds < floors
        corners, floors = self.corners[:, near], floors[near]
        for _ in range(_MOST_HALVINGS):
            if not len(floors):
                return True
            if (_least_at_times(corners) < floors).any():
                return False
            corners, floors = _halves(corners), np.tile(floors, 2)
            near = _bounds(corners) < floors
            corners, floors = corners[:, near], floors[near]
        return not len(floors)


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


def _rough_bounds(corners: Complex) -> Floats:
    """Give quick lower bounds of the same: the distance half-way, less what the edge moves from there."""
    before, after = corners[:2], corners[2:]
    moved = np.abs(after - before).max(axis=0)
    return np.asarray(np.abs(_nearest(*(before + after) / 2)) - moved / 2)


def _bounds(corners: Complex) -> Floats:
    """Give lower bounds of how far from zero the hulls of (4, k) points are; 0 where zero may be inside."""
    nearest = _nearest(*corners[_SIDES])
    distance = np.abs(nearest)
    normals = nearest.conj() / np.where(distance > 0, distance, 1.0)
    along = (corners * normals[:, None]).real
    return np.asarray(np.maximum(along.min(axis=1).max(axis=0), 0.0))
