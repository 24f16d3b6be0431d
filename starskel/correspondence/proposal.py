"""Marks proposed from two rings alone: of the salient vertices that correspond, some that are well spread."""

import numpy as np

from starskel.arrays import Floats
from starskel.correspondence.choice import best_alignment
from starskel.correspondence.landmarks import EXACT_DIGITS, Landmarks
from starskel.correspondence.marks import Mark
from starskel.correspondence.pricing import likeness
from starskel.task import Task

LEAST_VALUE = 0.15
"""How much both outlines must bend at a mark, and in the same way, as a part of turning back."""

NEAREST = 0.25
"""How near marks may be along either outline, as a part of the distance between evenly spread ones."""


def proposed_marks(rings: tuple[Floats, Floats], count: int, task: Task) -> list[Mark]:
    """Give at least one and at most `count` pairs of vertices, in the order of the first."""
    outlines = Landmarks.of(rings[0], task), Landmarks.of(rings[1], task)
    best = best_alignment(*outlines, task)
    first, second = best.first, best.second
    saliences = np.minimum(outlines[0].saliences[first], outlines[1].saliences[second])
    values = saliences * likeness(*outlines, first, second)
    chosen = _spread(values, (outlines[0].shares[first], outlines[1].shares[second]), count)
    return sorted((int(outlines[0].vertices[first[k]]), int(outlines[1].vertices[second[k]])) for k in chosen)


def _spread(values: Floats, shares: tuple[Floats, Floats], count: int) -> list[int]:
    """Choose one by one what has the most value, the more so the farther it is from those chosen."""
    chosen = [_largest(values)]
    gaps = np.ones(len(values))
    while len(chosen) < count:
        for own in shares:
            apart = np.abs((own - own[chosen[-1]] + 0.5) % 1 - 0.5)
            gaps = np.minimum(gaps, apart)
        eligible = (gaps >= NEAREST / count) & (values >= LEAST_VALUE)
        if not eligible.any():
            break
        chosen.append(_largest(np.where(eligible, values * gaps, -1)))
    return chosen


def _largest(values: Floats) -> int:
    return int(np.argmax(values.round(EXACT_DIGITS)))
