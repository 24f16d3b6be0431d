"""Which salient vertices of two outlines correspond: the cheapest alignment once round.

The prices are works in the manner of Sederberg and Greenwood 1992, "A Physically Based Approach to 2-D Shape
Blending": of bending, at a vertex and over longer reaches, and of stretching, as the drift of the shares of
the length. Besides, after the rotation that fits the whole shape best, a vertex should lie in the same place
and the outline run the same way there; that rotation has its price, for people expect the upright alignment.
"""

import numpy as np

from starskel.correspondence.alignment import Prices, align, alignment_prices
from starskel.correspondence.landmarks import EXACT_DIGITS, Complexes, Indices, Landmarks
from starskel.predicates import Floats
from starskel.task import Task

STRETCH_PRICE = 1.0
"""The price of a difference in share by the whole length."""

TURN_PRICE = 0.3
"""The price of a difference in turning angle by pi; so are the others of angles."""

BEND_PRICE = 0.2
PLACE_PRICE = 0.1
"""The price of a distance by the radius of gyration."""

DIRECTION_PRICE = 0.05
ALONE_PRICE = 0.2
"""The price of a landmark without a partner, beside that of its turning angle."""

LEAST_WEIGHT = 0.2
"""The weight of a match where neither outline bends at all, against one of right angles."""

ROTATION_PRICE = 0.1
"""The price, for each landmark, of turning the whole shape by pi."""

_BATCH = 32
"""So many starts are priced together: what they need stays in the processor's cache."""

_SALIENT, _COUNTERPARTS = 8, 32
"""So many landmarks of each outline, the most salient, are tried as starts with so many of the other."""


def aligned_landmarks(first: Landmarks, second: Landmarks, task: Task) -> tuple[Indices, Indices]:
    """Give which landmarks of both correspond, in the order round the outlines."""
    i, j = _starts(first.saliences, second.saliences)
    totals = np.concatenate(
        [
            _totals(first, second, (i[k : k + _BATCH], j[k : k + _BATCH]), task)
            for k in range(0, len(i), _BATCH)
        ]
    )
    best = [int(np.argmin(totals.round(EXACT_DIGITS)))]
    _, prices = _prices_from(first, second, (i[best], j[best]))
    one = Prices(prices.match[0], prices.first_alone[0], prices.second_alone[0])
    pairs = np.array([(-1, -1), *align(one, task)], dtype=np.intp) + 1
    return (i[best] + pairs[:, 0]) % len(first), (j[best] + pairs[:, 1]) % len(second)


def _totals(first: Landmarks, second: Landmarks, starts: tuple[Indices, Indices], task: Task) -> Floats:
    """Give the price of the cheapest alignment from each of the starts."""
    task.reach(0)
    starting, prices = _prices_from(first, second, starts)
    rotations = ROTATION_PRICE / np.pi * np.abs(np.angle(_rotations(first, second, starts)))
    return np.asarray(starting + alignment_prices(prices, task) + rotations * max(len(first), len(second)))


def _starts(first: Floats, second: Floats) -> tuple[Indices, Indices]:
    """Give the pairs of landmarks to try, from their saliences."""
    ranks = [
        np.argsort(np.argsort(-saliences.round(EXACT_DIGITS), kind="stable")) for saliences in (first, second)
    ]
    lower, higher = np.minimum.outer(*ranks), np.maximum.outer(*ranks)
    i, j = np.nonzero((lower < _SALIENT) & (higher < _COUNTERPARTS))
    return i, j


def _bending_prices(first: Landmarks, second: Landmarks) -> Floats:
    """Give the price of the difference in turns and bends, for each pair of landmarks."""
    turns = np.abs(np.subtract.outer(first.turns, second.turns))
    bends = np.mean(
        [_angles(np.subtract.outer(a, b)) for a, b in zip(first.bends[1:], second.bends[1:], strict=True)],
        axis=0,
    )
    return np.asarray(TURN_PRICE / np.pi * turns + BEND_PRICE / np.pi * bends)


def _angles(differences: Floats) -> Floats:
    return np.abs((differences + np.pi) % (2 * np.pi) - np.pi)


def _rotations(first: Landmarks, second: Landmarks, starts: tuple[Indices, Indices]) -> Complexes:
    """Give the rotations that bring the first outline nearest to the second, in least squares."""
    products = np.conj(first.samples[starts[0]]) * second.samples[starts[1]]
    return np.asarray(np.exp(1j * np.angle(products.sum(axis=1))))


def _prices_from(
    first: Landmarks, second: Landmarks, starts: tuple[Indices, Indices]
) -> tuple[Floats, Prices]:
    """Give the prices of matching the starts, and those for all other landmarks in order from there."""
    rows, columns = (
        (start[:, None] + np.arange(len(outline))) % len(outline)
        for start, outline in zip(starts, (first, second), strict=True)
    )
    shares = [
        (outline.shares[order] - outline.shares[start][:, None]) % 1
        for outline, order, start in zip((first, second), (rows, columns), starts, strict=True)
    ]
    match = _bending_prices(first, second)[rows[:, :, None], columns[:, None, :]]
    match += STRETCH_PRICE * np.abs(shares[0][:, :, None] - shares[1][:, None, :])
    rotations = _rotations(first, second, starts)[:, None]
    positions = first.positions[rows] * rotations
    match += PLACE_PRICE * np.abs(positions[:, :, None] - second.positions[columns][:, None, :])
    directions = first.directions[rows] * rotations
    ratios = directions[:, :, None] * np.conj(second.directions[columns])[:, None, :]
    match += DIRECTION_PRICE / np.pi * np.abs(np.angle(ratios))
    match *= _weights(first, second)[rows[:, :, None], columns[:, None, :]]
    alone = [ALONE_PRICE + TURN_PRICE / np.pi * np.abs(outline.turns) for outline in (first, second)]
    rest = Prices(match[:, 1:, 1:], alone[0][rows[:, 1:]], alone[1][columns[:, 1:]])
    return match[:, 0, 0], rest


def _weights(first: Landmarks, second: Landmarks) -> Floats:
    """Tell how much a match counts: that of tips and notches more than that of points on long bends."""
    return np.asarray(LEAST_WEIGHT + 2 * np.maximum.outer(first.saliences, second.saliences))


def likeness(first: Landmarks, second: Landmarks, i: Indices, j: Indices) -> Floats:
    """Tell how much alike pairs of landmarks bend, from 0 to 1."""
    bends = _angles(first.bends[:, i] - second.bends[:, j]).mean(axis=0)
    turns = _angles(first.turns[i] - second.turns[j])
    return np.asarray((1 - bends / np.pi) * (1 - turns / np.pi))
