"""How far a frame is from the one that is wanted, by the strain of the fans, not by the vertices' ways."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from starskel.blending.certified.keys import farthest
from starskel.blending.fans import fans_of
from starskel.decomposition.pieces import Decomposition
from starskel.polar import as_complex
from starskel.predicates import Complex, Floats, Indices
from starskel.task import Task

ON_RING = 3.0
"""How much more the edges of the outline count than those inside."""

SHORTEST = 1e-3
"""Edges shorter than this part of the size count as so long."""

HELD = 1e-2
"""How much the place of a vertex counts beside its edges."""


@dataclass(frozen=True, eq=False)
class Metric:
    """A quadratic form on displacements of a mesh whose first points are the outline; without dimension.

    Attributes
    ----------
    matrix : (2 m, 2 m) sparse array
        For displacements x0, y0, x1, y1, ... of all points.
    outline : (n, n) sparse array, links : (n, m - n) sparse array
        The same for one coordinate: the outline's part, and what links it to inner points.
    inner : callable, optional
        Solves the inner points' part; None where there are no inner points.
    size : float
        The shapes' extent, twice the largest distance from the mean of the vertices.
    """

    matrix: sparse.csc_array
    outline: sparse.csr_array
    links: sparse.csr_array
    inner: Callable[[Floats], Floats] | None
    size: float

    def strain(self, away: Complex) -> float:
        """Give half the form of the outline's displacements, the inner points where it is least."""
        parts = np.stack([away.real, away.imag], axis=1)
        pull = self.outline @ parts
        if self.inner is not None:
            pull = pull - self.links @ self.inner(self.links.T @ parts)
        return float((parts * pull).sum() / 2)


def metric_of(decomposition: Decomposition, task: Task) -> Metric:
    """Weigh the edges of the fans of all pieces by 1 / length^2: what counts is strain."""
    fans = fans_of(decomposition, task)
    n, m = len(decomposition.pair), len(fans.source)
    rings = decomposition.pair.source, decomposition.pair.target
    size = 2 * max(farthest(ring - ring.mean(axis=0)) for ring in rings)
    ends = np.sort(fans.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    i, j = np.unique(ends, axis=0).T
    lengths = sum(np.abs(z[i] - z[j]) for z in (as_complex(fans.source), as_complex(fans.target))) / 2
    on_ring = (j < n) & ((j - i == 1) | (j - i == n - 1))
    weights = np.where(on_ring, ON_RING, 1.0) / np.maximum(lengths, SHORTEST * size) ** 2
    incidence = _incidence(i, j, m)
    held = np.where(np.arange(m) < n, HELD / size**2, 0.0)
    one = incidence.T @ sparse.diags_array(weights) @ incidence + sparse.diags_array(held)
    one = sparse.csc_array(one)
    task.reach(0)
    inner = splu(one[n:, n:]).solve if m > n else None
    task.reach(0)
    whole = sparse.csc_array(sparse.kron(one, sparse.eye_array(2)))
    return Metric(whole, sparse.csr_array(one[:n, :n]), sparse.csr_array(one[:n, n:]), inner, size)


def _incidence(i: Indices, j: Indices, m: int) -> sparse.csr_array:
    rows = np.arange(len(i))
    ones = np.ones(len(i))
    entries = np.concatenate([-ones, ones]), (np.tile(rows, 2), np.concatenate([i, j]))
    return sparse.csr_array(entries, shape=(len(i), m))
