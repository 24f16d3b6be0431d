"""What it costs to match salient vertices of two outlines.

The prices are works in the manner of Sederberg and Greenwood 1992, "A Physically Based Approach to 2-D Shape
Blending": of bending, at a vertex and over longer reaches, and of stretching, as the drift of the shares of
the length. Besides, after the rotation that fits the whole shape best, a vertex should lie in the same place
and the outline run the same way there.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.correspondence.alignment import Table
from starskel.correspondence.landmarks import Landmarks

Starts = tuple[Indices, Indices]
"""Landmarks of the first and of the second outline that are matched, (k,) alternatives."""


@dataclass(frozen=True)
class Pricing:
    """What is asked for what.

    Attributes
    ----------
    stretch : float
        For a difference in share by the whole length.
    turn, bend, direction : float
        For a difference by pi: of turning angles, of bends over longer reaches, of directions.
    place : float
        For a distance by the radius of gyration.
    alone : float
        For a landmark without a partner, beside its turning angle.
    """

    stretch: float
    turn: float
    bend: float
    place: float
    direction: float
    alone: float


SHAPES = Pricing(stretch=1.0, turn=0.3, bend=0.2, place=0.1, direction=0.05, alone=0.2)
"""For shapes that bend somewhat: what looks alike and lies alike belongs together."""

LENGTHS = Pricing(stretch=4.0, turn=0.3, bend=0.0, place=0.0, direction=0.0, alone=0.2)
"""For shapes that bend at large: only the way along the outline remains."""

_LEAST_WEIGHT = 0.2
"""The weight of a match where neither outline bends at all, against one of right angles."""


def prices_from(
    first: Landmarks, second: Landmarks, starts: Starts, pricing: Pricing
) -> tuple[Floats, Table]:
    """Give the (k,) prices of matching the starts, and those for all other landmarks in order from there."""
    rows, columns = (
        (start[:, None] + np.arange(len(outline))) % len(outline)
        for start, outline in zip(starts, (first, second), strict=True)
    )
    shares = [
        (outline.shares[order] - outline.shares[start][:, None]) % 1
        for outline, order, start in zip((first, second), (rows, columns), starts, strict=True)
    ]
    match = _bending_prices(first, second, pricing)[rows[:, :, None], columns[:, None, :]]
    match += pricing.stretch * np.abs(shares[0][:, :, None] - shares[1][:, None, :])
    if pricing.place or pricing.direction:
        turned = rotations(first, second, starts)[:, None]
        positions, directions = first.positions[rows] * turned, first.directions[rows] * turned
        match += pricing.place * np.abs(positions[:, :, None] - second.positions[columns][:, None, :])
        ratios = directions[:, :, None] * np.conj(second.directions[columns])[:, None, :]
        match += pricing.direction / np.pi * np.abs(np.angle(ratios))
    match *= _weights(first, second)[rows[:, :, None], columns[:, None, :]]
    alone = [pricing.alone + pricing.turn / np.pi * np.abs(outline.turns) for outline in (first, second)]
    return match[:, 0, 0], Table(match[:, 1:, 1:], alone[0][rows[:, 1:]], alone[1][columns[:, 1:]])


def rotations(first: Landmarks, second: Landmarks, starts: Starts) -> Complex:
    """Give the (k,) unit numbers that turn the first outline nearest to the second, in least squares."""
    products = np.conj(first.samples[starts[0]]) * second.samples[starts[1]]
    return np.asarray(np.exp(1j * np.angle(products.sum(axis=1))))


def likeness(first: Landmarks, second: Landmarks, i: Indices, j: Indices) -> Floats:
    """Tell how much alike k pairs of landmarks bend, (k,), from 0 to 1."""
    bends = _angles(first.bends[:, i] - second.bends[:, j]).mean(axis=0)
    turns = _angles(first.turns[i] - second.turns[j])
    return np.asarray((1 - bends / np.pi) * (1 - turns / np.pi))


def _bending_prices(first: Landmarks, second: Landmarks, pricing: Pricing) -> Floats:
    """Give the price of the difference in turns and bends, for each pair of landmarks."""
    turns = np.abs(np.subtract.outer(first.turns, second.turns))
    bends = np.mean(
        [_angles(np.subtract.outer(a, b)) for a, b in zip(first.bends[1:], second.bends[1:], strict=True)],
        axis=0,
    )
    return np.asarray(pricing.turn / np.pi * turns + pricing.bend / np.pi * bends)


def _angles(differences: Floats) -> Floats:
    return np.abs((differences + np.pi) % (2 * np.pi) - np.pi)


def _weights(first: Landmarks, second: Landmarks) -> Floats:
    """Tell how much a match counts: that of tips and notches more than that of points on long bends."""
    return np.asarray(_LEAST_WEIGHT + 2 * np.maximum.outer(first.saliences, second.saliences))
