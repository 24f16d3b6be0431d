"""Matrices of weighted graphs, factored once and solved for every frame.

SuperLU orders and factors them sparsely (scipy.sparse.linalg.splu): the fans of m points take O(m) memory,
or little more, instead of the m^2 of an inverse.

SuperLU gives memory back only in the thread that took it (scipy issue 15921). So factors stay in their
thread, and another one factors the same matrix again, to the same bits. The main thread keeps those that it
used last. In others they are freed as work ends: as the thread ends it would be too late, and where it
is none of Python's own, but one of Qt's, say, freeing them then brings Python down.
"""

import threading
from collections import OrderedDict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import SuperLU, splu

from starskel.arrays import Floats, Indices

KEPT = 32
"""So many factors a thread keeps; a blend has three at most."""


@dataclass(frozen=True, eq=False)
class Factored:
    """A positive definite matrix A, factored where it is used."""

    matrix: csc_array

    def solve(self, right: Floats) -> Floats:
        """Give for each r of k right sides, (k, m) or (k, m, 2), the x with A x = r.

        They are solved one by one: what comes of one does not depend, not even by rounding, on the others.
        """
        if not len(right):
            return right
        with factors_kept():
            factors = _factors_of(self)
            return np.stack([factors.solve(each) for each in right])


class _Recent(threading.local):
    """The factors that the running thread has used, the last one last, and how deep in work it is."""

    def __init__(self) -> None:
        self.factors: OrderedDict[Factored, SuperLU] = OrderedDict()
        self.depth = 0


_RECENT = _Recent()


def _factors_of(factored: Factored) -> SuperLU:
    recent = _RECENT.factors
    if factored not in recent:
        recent[factored] = splu(
            factored.matrix,
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )
        if len(recent) > KEPT:
            recent.popitem(last=False)
    recent.move_to_end(factored)
    return recent[factored]


@contextmanager
def factors_kept() -> Iterator[None]:
    """Keep what is factored until this work ends, or the work round it; in the main thread for longer."""
    _RECENT.depth += 1
    try:
        yield
    finally:
        _RECENT.depth -= 1
        if not _RECENT.depth and threading.get_ident() != threading.main_thread().ident:
            _RECENT.factors.clear()


def factor(edges: Indices, weights: Floats, diagonal: Floats) -> Factored:
    """Give the Laplacian of a weighted graph plus a diagonal, to be solved for many right sides.

    Parameters
    ----------
    edges : (e, 2) array
        The graph, connected, each edge once.
    weights : (e,) array
        Of the edges, positive.
    diagonal : (m,) array
        Not negative, and positive somewhere: the matrix is positive definite and needs no pivots.
    """
    count = len(diagonal)
    i, j = edges.T
    every = np.arange(count)
    sums = diagonal + np.bincount(edges.ravel(), np.repeat(weights, 2), count)
    values = np.concatenate([sums, -weights, -weights])
    places = np.concatenate([every, i, j]), np.concatenate([every, j, i])
    return Factored(csc_array((values, places), shape=(count, count)))
