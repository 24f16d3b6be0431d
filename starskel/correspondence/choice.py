"""The best of several alignments of two outlines, by what becomes of the shapes.

The prices of an alignment see the outlines a piece at a time, and none sees whether the one shape can become
the other. So the alignments are tried: each costs its price and what strains a quick blend, and more where
that crosses itself.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from starskel.correspondence.cyclic import Alignment, alignments, price
from starskel.correspondence.landmarks import EXACT_DIGITS, Landmarks
from starskel.correspondence.pricing import LENGTHS, SHAPES
from starskel.correspondence.trial import Trial
from starskel.task import Task

STRAIN_PRICE = 1.0
"""The price of a quick blend whose vectors are off by their own lengths."""

CROSSING_PRICE = 1.0
"""How much dearer an alignment is where all frames cross themselves, as a part of its cost."""


def best_alignment(first: Landmarks, second: Landmarks, task: Task) -> Alignment:
    """Give the alignment that costs the least.

    Those that match what looks alike come first, in order of their prices; none costs less than its price, so
    few have to be tried. Only where the best of them crosses itself the way along the outlines leads.
    """
    chosen = _cheapest(first, second, alignments(first, second, SHAPES, task), task)
    if chosen.crosses:
        others = _cheapest(first, second, alignments(first, second, LENGTHS, task), task)
        chosen = min(chosen, others, key=lambda tried: tried.cost)
    return chosen.alignment


def _cheapest(first: Landmarks, second: Landmarks, candidates: Iterator[Alignment], task: Task) -> "_Tried":
    """Try alignments, in order of their prices, while any can still cost less than those tried."""
    best = _Tried.of(first, second, next(candidates))
    for alignment in candidates:
        task.reach(0)
        if price(first, second, alignment) >= best.cost:
            continue
        best = min(best, _Tried.of(first, second, alignment), key=lambda tried: tried.cost)
    return best


@dataclass(frozen=True)
class _Tried:
    alignment: Alignment
    cost: float
    crosses: bool

    @classmethod
    def of(cls, first: Landmarks, second: Landmarks, alignment: Alignment) -> "_Tried":
        trial = Trial.of(first, second, (alignment.first, alignment.second))
        work = price(first, second, alignment) + STRAIN_PRICE * trial.strain
        cost = work * (1 + CROSSING_PRICE * trial.crossings)
        return cls(alignment, round(cost, EXACT_DIGITS), trial.crossings > 0)
