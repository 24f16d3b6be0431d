"""Star pieces of regions with holes: those of both halves that the bridges leave, joined again."""

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.correspondence import Correspondence
from starskel.decomposition import decompose
from starskel.decomposition.pieces import Decomposition
from starskel.shapes.holes.bridges import chain_of, halves
from starskel.task import Task


def decompose_region(pair: Correspondence, task: Task) -> Decomposition:
    """Cut both regions into compatible star pieces; a part without holes is decomposed as a polygon.

    Raises
    ------
    StarskelError
        Where a region is too narrow for floating point to lead a bridge through.
    Cancelled
        If the task is told to stop.
    """
    if len(pair.starts) == 1:
        return decompose(pair, progress=task.reach, should_stop=task.should_stop)
    chain = chain_of(pair, task.quiet)
    first, second = (
        np.concatenate([rows, bends])
        for rows, bends in zip((pair.source, pair.target), chain.bends, strict=True)
    )
    halved = []
    for number, rows in enumerate(halves(pair, chain)):
        half = Correspondence(first[rows], second[rows], (), np.arange(len(rows)), np.arange(len(rows)))
        part = task.part(number / 2, (number + 1) / 2)
        halved.append((rows, decompose(half, progress=part.reach, should_stop=task.should_stop)))
    return _joined(pair, (first, second), halved)


def _joined(
    pair: Correspondence, points: tuple[Floats, Floats], parts: list[tuple[Indices, Decomposition]]
) -> Decomposition:
    """Name the pieces' rows as the region does: behind its own the bends, and then all Steiner vertices."""
    source, target, pieces = [points[0]], [points[1]], []
    count = len(points[0])
    for rows, part in parts:
        steiner = len(part.source) - len(rows)
        names = [*rows.tolist(), *range(count, count + steiner)]
        pieces += [tuple(names[row] for row in piece) for piece in part.pieces]
        source.append(part.source[len(rows) :])
        target.append(part.target[len(rows) :])
        count += steiner
    return Decomposition(
        pair,
        np.concatenate(source),
        np.concatenate(target),
        tuple(pieces),
        np.concatenate([part.source_origins for _, part in parts]),
        np.concatenate([part.target_origins for _, part in parts]),
    )
