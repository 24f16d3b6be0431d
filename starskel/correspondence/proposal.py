"""Marks proposed from two rings alone: of the salient vertices that correspond, some that are well spread."""

import numpy as np

from starskel.correspondence.cyclic import aligned_landmarks, likeness
from starskel.correspondence.landmarks import Landmarks
from starskel.correspondence.marks import Mark
from starskel.predicates import Floats
from starskel.task import Task

LEAST_SALIENCE = 0.15
"""How much the outline must bend at a mark, as a part of turning back."""


def proposed_marks(rings: tuple[Floats, Floats], count: int, task: Task) -> list[Mark]:
    """Give at least one and at most `count` pairs of vertices, in the order round the first ring.

    Marks are chosen one by one: that which is most salient and alike, in the widest gap between those chosen.
    """
    outlines = Landmarks.of(rings[0], task), Landmarks.of(rings[1], task)
    first, second = aligned_landmarks(*outlines, task)
    saliences = np.minimum(outlines[0].saliences[first], outlines[1].saliences[second])
    values = saliences * likeness(*outlines, first, second)
    shares = outlines[0].shares[first], outlines[1].shares[second]
    gaps = np.ones(len(first))
    chosen: list[int] = []
    while len(chosen) < count:
        best = int(np.argmax(values * gaps))
        if chosen and not (gaps[best] > 0 and values[best] >= LEAST_SALIENCE):
            break
        chosen.append(best)
        for own in shares:
            apart = np.abs((own - own[best] + 0.5) % 1 - 0.5)
            gaps = np.minimum(gaps, apart)
    return sorted((int(outlines[0].vertices[first[k]]), int(outlines[1].vertices[second[k]])) for k in chosen)
