"""Flipping edges of both triangulations together, so that triangles change their shape less."""

import numpy as np

from starskel.arrays import Flags, Floats, Indices
from starskel.blending.meshes.distortion import Shapes
from starskel.predicates import NEAR
from starskel.task import Task

_WORTH = 1e-6
"""A flip must lessen the distortion of its two triangles by this part: rounding decides nothing."""


def flipped(triangles: Indices, shapes: Shapes, task: Task) -> Indices:
    """Flip edges while that lessens the distortion.

    Edges whose flips gain more than those of all others of their two triangles are flipped at once; a round
    costs O(k) for k triangles, and each lessens the sum, so that there is an end.

    Parameters
    ----------
    triangles : (k, 3) array
    shapes : Shapes
    task : Task

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    while True:
        task.reach(0)
        pairs, after, gains = _flips(triangles, shapes)
        best = np.zeros(len(triangles))
        np.maximum.at(best, pairs, gains[:, None])
        chosen = (gains > 0) & (gains[:, None] >= (1 - NEAR) * best[pairs]).all(axis=1)
        chosen &= _first_of_each(pairs, chosen, len(triangles))
        if not chosen.any():
            return triangles
        triangles = triangles.copy()
        triangles[pairs[chosen]] = after[chosen]


def _first_of_each(pairs: Indices, chosen: Flags, count: int) -> Flags:
    """Tell which of the chosen pairs are the first of both their triangles: gains may be all but equal."""
    rank = np.where(chosen, np.arange(len(pairs)), len(pairs))
    first = np.full(count, len(pairs))
    np.minimum.at(first, pairs, rank[:, None])
    return np.asarray((first[pairs] == rank[:, None]).all(axis=1))


def _flips(triangles: Indices, shapes: Shapes) -> tuple[Indices, Indices, Floats]:
    """Give for each inner edge its two triangles, (e, 2); what becomes of them, (e, 2, 3); and the gain."""
    count = len(triangles)
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    apex = np.roll(triangles, 1, axis=1).ravel()
    size = int(triangles.max()) + 1
    keys, backwards = start * size + end, end * size + start
    order = np.argsort(keys)
    found = order[np.minimum(np.searchsorted(keys[order], backwards), len(order) - 1)]
    inner = np.flatnonzero((keys[found] == backwards) & (start < end))
    other = found[inner]
    a, b, c, d = start[inner], end[inner], apex[inner], apex[other]
    pairs = np.repeat(np.arange(count), 3)[np.stack([inner, other], axis=1)]
    after = np.stack([np.stack([a, d, c], axis=1), np.stack([d, b, c], axis=1)], axis=1)
    before = shapes.distortions(triangles)[pairs].sum(axis=1)
    gains = before * (1 - _WORTH) - shapes.distortions(after).sum(axis=1)
    linked = np.isin(np.minimum(c, d) * size + np.maximum(c, d), np.minimum(keys, backwards))
    possible = shapes.have_area(after).all(axis=1) & ~linked
    return pairs, after, np.where(possible, gains, 0.0)
