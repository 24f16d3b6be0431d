"""Solving with symmetric matrices on a mesh, many times and fast: blocks, and what separates them.

A triangulated polygon falls apart into small blocks when few points are taken out of it: the hubs of large
fans, and thin layers across (nested dissection, George 1973). Each block is solved by its own dense
inverse, the separating points by that of their Schur complement. This takes little more than O(m) for m
points where a full inverse takes O(m^2), after O(m) instead of O(m^3) to prepare, and needs no library for
sparse matrices.
"""

from dataclasses import dataclass

import numpy as np

from starskel.blending.dissection import Dissection
from starskel.predicates import Floats


@dataclass(frozen=True, eq=False)
class Factored:
    """A factored matrix A over b blocks of w points and s separating points.

    Attributes
    ----------
    dissection : Dissection
        Which points these are.
    blocks : (b, w, w) array
        The inverse of each block.
    links : (b w, s) array
        These inverses times the columns of A that belong to the separating points.
    rest : (s, s) array
        The inverse of what is left for the separating points.
    """

    dissection: Dissection
    blocks: Floats
    links: Floats
    rest: Floats

    def solve(self, right: Floats) -> Floats:
        """Give for each row r of a (k, m) array the x with A x = r."""
        k, count = right.shape
        separator, blocks = self.dissection.separator, self.dissection.blocks
        inner = np.concatenate([right, np.zeros((k, 1))], axis=1)[:, blocks]
        solved = np.matmul(inner.transpose(1, 0, 2), self.blocks).transpose(1, 0, 2).reshape(k, -1)
        outer = (right[:, separator] - inner.reshape(k, -1) @ self.links) @ self.rest
        solution = np.empty((k, count + 1))
        solution[:, blocks.ravel()] = solved - outer @ self.links.T
        solution[:, separator] = outer
        return solution[:, :count]


def factor(dissection: Dissection, weights: Floats, diagonal: Floats) -> Factored:
    """Factor the matrix of a weighted graph: the Laplacian of its edges' weights plus a diagonal.

    Parameters
    ----------
    dissection : Dissection
        The graph, divided.
    weights : (e,) array
        Of the edges, positive.
    diagonal : (m,) array
        Not negative, and positive somewhere.
    """
    d = dissection
    count, width = len(d.blocks), d.blocks.shape[1]
    sums = diagonal + np.bincount(d.edges.ravel(), np.repeat(weights, 2), len(diagonal))
    block, slot = d.places
    rows = block * width + slot
    (i, j), both = d.edges.T, np.concatenate([weights, weights])
    i, j = np.concatenate([i, j]), np.concatenate([j, i])

    inner = np.zeros((count * width, width))
    inner[np.arange(count * width), np.tile(np.arange(width), count)] = 1.0
    own = block >= 0
    inner[rows[own], slot[own]] = sums[own]
    within = own[i] & (block[i] == block[j])
    inner[rows[i[within]], slot[j[within]]] = -both[within]
    inverses = np.linalg.inv(inner.reshape(count, width, width))

    across = np.zeros((count * width, len(d.separator)))
    leaving = own[i] & ~own[j]
    across[rows[i[leaving]], slot[j[leaving]]] = -both[leaving]
    links = np.matmul(inverses, across.reshape(count, width, -1)).reshape(count * width, -1)

    rest = np.diag(sums[d.separator])
    outside = ~own[i] & ~own[j]
    rest[slot[i[outside]], slot[j[outside]]] = -both[outside]
    return Factored(d, inverses, links, np.linalg.inv(rest - across.T @ links))
