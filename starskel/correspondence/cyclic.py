"""Which salient vertices of two outlines may correspond: the cheapest alignments once round.

To the mean price of all landmarks comes that of turning the whole shape: people expect it to stay upright.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.correspondence.alignment import Table, align, alignment_prices
from starskel.correspondence.landmarks import EXACT_DIGITS, Landmarks
from starskel.correspondence.pricing import SHAPES, Pricing, Starts, prices_from, rotations
from starskel.task import Task

ROTATION_PRICE = 0.15
"""The price of turning the whole shape by pi."""

_BATCH = 32
"""So many starts are priced together: what they need stays in the processor's cache."""

_PHASES = 16
"""So many ways to turn one outline along the other are told apart."""

_SALIENT, _COUNTERPARTS = 6, 24
"""So many landmarks of each outline, the most salient, are tried as starts with so many of the other."""


@dataclass(frozen=True, eq=False)
class Alignment:
    """Landmarks of both outlines that correspond, in the order round both from the start."""

    first: Indices
    second: Indices


def alignments(first: Landmarks, second: Landmarks, pricing: Pricing, task: Task) -> Iterator[Alignment]:
    """Give the cheapest alignment for each way to turn one outline along the other, the cheapest first."""
    i, j = _starts(first.saliences, second.saliences)
    batches = [(i[k : k + _BATCH], j[k : k + _BATCH]) for k in range(0, len(i), _BATCH)]
    totals = np.concatenate([_totals(first, second, starts, pricing, task) for starts in batches])
    phases = np.floor(((second.shares[j] - first.shares[i]).round(EXACT_DIGITS) * _PHASES + 0.5) % _PHASES)
    taken = set()
    for k in np.argsort(totals.round(EXACT_DIGITS), kind="stable"):
        if phases[k] not in taken:
            taken.add(phases[k])
            yield _alignment(first, second, (i[k : k + 1], j[k : k + 1]), pricing, task)


def price(first: Landmarks, second: Landmarks, alignment: Alignment) -> float:
    """Give the price of an alignment of shapes that bend somewhat."""
    starts = alignment.first[:1], alignment.second[:1]
    starting, prices = prices_from(first, second, starts, SHAPES)
    i = (alignment.first[1:] - starts[0]) % len(first) - 1
    j = (alignment.second[1:] - starts[1]) % len(second) - 1
    alone = np.delete(prices.first_alone[0], i).sum() + np.delete(prices.second_alone[0], j).sum()
    works = starting[0] + prices.match[0, i, j].sum() + alone
    return float(works / max(len(first), len(second)) + _turning_prices(first, second, starts)[0])


def _alignment(
    first: Landmarks, second: Landmarks, starts: Starts, pricing: Pricing, task: Task
) -> Alignment:
    """Give the cheapest alignment that matches two landmarks."""
    _, prices = prices_from(first, second, starts, pricing)
    one = Table(prices.match[0], prices.first_alone[0], prices.second_alone[0])
    pairs = np.array([(-1, -1), *align(one, task)], dtype=np.intp) + 1
    return Alignment((starts[0] + pairs[:, 0]) % len(first), (starts[1] + pairs[:, 1]) % len(second))


def _totals(first: Landmarks, second: Landmarks, starts: Starts, pricing: Pricing, task: Task) -> Floats:
    """Give the price of the cheapest alignment from each of the starts."""
    task.reach(0)
    starting, prices = prices_from(first, second, starts, pricing)
    totals = (starting + alignment_prices(prices, task)) / max(len(first), len(second))
    return np.asarray(totals + _turning_prices(first, second, starts))


def _turning_prices(first: Landmarks, second: Landmarks, starts: Starts) -> Floats:
    return np.asarray(ROTATION_PRICE / np.pi * np.abs(np.angle(rotations(first, second, starts))))


def _starts(first: Floats, second: Floats) -> Starts:
    """Give the pairs of landmarks to try, from their saliences."""
    ranks = [
        np.argsort(np.argsort(-saliences.round(EXACT_DIGITS), kind="stable")) for saliences in (first, second)
    ]
    lower, higher = np.minimum.outer(*ranks), np.maximum.outer(*ranks)
    i, j = np.nonzero((lower < _SALIENT) & (higher < _COUNTERPARTS))
    return i, j
