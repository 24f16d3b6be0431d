"""Where to start without marks: the pair of vertices from which the whole outlines align best."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from starskel.correspondence.alignment import TURN_PRICE, Chains, alignment_prices
from starskel.outline import edge_lengths, edge_vectors, turning_angles
from starskel.predicates import Floats
from starskel.task import Task

ROTATION_PRICE = 0.03
"""The price, for each vertex, of turning the whole shape by pi: people expect the upright alignment."""

_SAMPLES = 64
_SHARPEST = 64
_OFFSETS = 32
_STARTS_PER_OFFSET = 4
_CELLS = 10_000_000
"""How many cells of the tables of prices may be filled: about a second's work."""


class _Views(NamedTuple):
    """An outline as seen from each of its vertices.

    Attributes
    ----------
    shapes : (n, samples) array
        The direction of the outline at equal steps, less its mean: the same for all similar shapes.
    directions : (n,) array
        These means.
    shares, turns : (n,) arrays
        The vertex's share of the length from vertex 0, and its turning angle.
    """

    shapes: Floats
    directions: Floats
    shares: Floats
    turns: Floats


def best_start(source: Floats, target: Floats, task: Task) -> tuple[int, int]:
    """Give a vertex of each ring such that the whole outlines align at the least price from there.

    The likeliest starts are found by comparing directions along the outlines, then aligned in full.
    """
    views = _views(source), _views(target)
    i, j = _candidates(*views, most=max(3, _CELLS // (len(source) * len(target))))
    task.reach(0)
    prices = alignment_prices(Chains.round(source, i), Chains.round(target, j), task)
    rotations = np.angle(np.exp(1j * (views[1].directions[j] - views[0].directions[i])))
    prices += TURN_PRICE / np.pi * np.abs(views[0].turns[i] - views[1].turns[j])
    prices += ROTATION_PRICE / np.pi * np.abs(rotations) * max(len(source), len(target))
    best = int(np.lexsort((j, i, prices))[0])
    return int(i[best]), int(j[best])


def _views(ring: Floats) -> _Views:
    n = len(ring)
    turns = turning_angles(ring)
    shares = np.concatenate([[0.0], np.cumsum(edge_lengths(ring))])
    shares /= shares[-1]
    first = np.arctan2(*edge_vectors(ring)[0][::-1])
    directions = first + np.cumsum(np.concatenate([[0.0], turns[1:], turns]))  # twice round
    steps = shares[:n, None] + (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    starts = np.concatenate([shares[:n], 1 + shares[:n]])
    seen = directions[np.searchsorted(starts, steps, side="right") - 1]
    means = seen.mean(axis=1)
    return _Views(seen - means[:, None], means, shares[:n], turns)


def _candidates(source: _Views, target: _Views, most: int) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Give the likeliest pairs of starts: a few of each offset between the outlines, the likeliest first.

    In the source only the sharpest vertices are considered: these have a partner, if any have.
    """
    sharpest = np.argsort(-np.abs(source.turns), kind="stable")[:_SHARPEST]
    unlike = _distances(source.shapes[sharpest], target.shapes)
    unlike += np.abs(source.turns[sharpest, None] - target.turns)
    i, j = np.unravel_index(np.argsort(unlike, axis=None, kind="stable"), unlike.shape)
    i = sharpest[i]
    offsets = (_OFFSETS * (source.shares[i] - target.shares[j])).round().astype(np.intp) % _OFFSETS
    by_offset = np.argsort(offsets, kind="stable")
    sorted_offsets = offsets[by_offset]
    rank = np.arange(len(i)) - np.searchsorted(sorted_offsets, sorted_offsets)
    chosen = np.sort(by_offset[rank < _STARTS_PER_OFFSET])[:most]
    return i[chosen], j[chosen]


def _distances(first: Floats, second: Floats) -> Floats:
    """Give the root mean square difference of each row of the first from each row of the second."""
    squares = (first**2).sum(axis=1)[:, None] + (second**2).sum(axis=1) - 2 * first @ second.T
    return np.asarray(np.sqrt(np.maximum(squares, 0.0) / first.shape[1]))
