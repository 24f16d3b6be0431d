"""Matrices of weighted graphs, factored once and solved for every frame.

SuperLU orders and factors them sparsely (scipy.sparse.linalg.splu): the fans of m points take O(m) memory,
or little more, instead of the m^2 of an inverse.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import SuperLU, splu

from starskel.predicates import Floats, Indices


@dataclass(frozen=True, eq=False)
class Factored:
    """A factored matrix A."""

    factors: SuperLU

    def solve(self, right: Floats) -> Floats:
        """Give for each r of k right sides, (k, m) or (k, m, 2), the x with A x = r.

        They are solved one by one: what comes of one does not depend, not even by rounding, on the others.
        """
        if not len(right):
            return right
        return np.stack([self.factors.solve(each) for each in right])


def factor(edges: Indices, weights: Floats, diagonal: Floats) -> Factored:
    """Factor the Laplacian of a weighted graph plus a diagonal.

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
    matrix = csc_array((values, places), shape=(count, count))
    return Factored(
        splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    )
