"""Star pieces of regions with holes: those of both halves that the bridges leave, joined again."""

import numpy as np

from starskel.correspondence import Correspondence
from starskel.decomposition import decompose
from starskel.decomposition.pieces import Decomposition
from starskel.shapes.bridges import chain_of, halves
from starskel.task import Task


def decompose_region(pair: Correspondence, task: Task) -> Decomposition:
    """Cut both regions into compatible star pieces; a part without holes is decomposed as a polygon.

    Raises
    ------
    StarskelError
        Where the holes cannot be joined to the outline by bridges that both regions have.
    Cancelled
        If the task is told to stop.
    """
    if len(pair.starts) == 1:
        return decompose(pair, progress=task.reach, should_stop=task.should_stop)
    rows = halves(pair, chain_of(pair, task.quiet))
    parts = [
        decompose(
            _half(pair, own), progress=task.part(k / 2, (k + 1) / 2).reach, should_stop=task.should_stop
        )
        for k, own in enumerate(rows)
    ]
    return _joined(pair, list(zip(rows, parts, strict=True)))


def _half(pair: Correspondence, rows: np.ndarray) -> Correspondence:
    own = np.arange(len(rows))
    return Correspondence(pair.source[rows], pair.target[rows], (), own, own)


def _joined(pair: Correspondence, parts: list[tuple[np.ndarray, Decomposition]]) -> Decomposition:
    """Name the pieces' rows as the region does, Steiner vertices behind all others."""
    source, target, pieces = [pair.source], [pair.target], []
    count = len(pair)
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
