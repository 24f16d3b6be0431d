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
    inner, across, rest = _assembled(dissection, weights, diagonal)
    blocks = _inverse(inner)
    flat = (blocks.shape[0] * blocks.shape[1], len(rest))
    links = np.matmul(blocks, across).reshape(flat)
    return Factored(dissection, blocks, links, _inverse(rest - across.reshape(flat).T @ links))


def _inverse(matrices: Floats) -> Floats:
    return np.asarray(np.linalg.inv(matrices), dtype=np.float64)


def _assembled(dissection: Dissection, weights: Floats, diagonal: Floats) -> tuple[Floats, Floats, Floats]:
    """Give the matrix within the blocks, between these and the separating points, and among the latter.

    Places that a block does not need are filled by ones on the diagonal.
    """
    separating, (count, width) = len(dissection.separator), dissection.blocks.shape
    inner = np.zeros((count, width, width))
    inner[:, np.arange(width), np.arange(width)] = 1.0
    across, rest = np.zeros((count, width, separating)), np.zeros((separating, separating))
    block, place = dissection.places
    sums = diagonal + np.bincount(dissection.edges.ravel(), np.repeat(weights, 2), len(diagonal))
    inside = block >= 0
    inner[block[inside], place[inside], place[inside]] = sums[inside]
    rest[place[~inside], place[~inside]] = sums[~inside]
    for i, j in (dissection.edges.T, dissection.edges.T[::-1]):
        within, outside = inside[i] & inside[j], ~inside[i] & ~inside[j]
        leaving = inside[i] & ~inside[j]
        inner[block[i[within]], place[i[within]], place[j[within]]] = -weights[within]
        across[block[i[leaving]], place[i[leaving]], place[j[leaving]]] = -weights[leaving]
        rest[place[i[outside]], place[j[outside]]] = -weights[outside]
    return inner, across, rest
