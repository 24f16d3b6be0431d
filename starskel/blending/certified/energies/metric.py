"""How far a frame is from the one that is wanted, by the strain of the fans, not by the vertices' ways."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from starskel.arrays import Complex, Floats, Indices
from starskel.blending.meshes.fans import fans_of
from starskel.decomposition.pieces import Decomposition
from starskel.polar import as_complex
from starskel.task import Task

ON_RING = 3.0
"""How much more the edges of the outline count than those inside."""

SHORTEST_EDGE = 1e-3
"""Edges shorter than this part of the size count as so long."""

HELD = 1e-2
"""How much the place of a vertex counts beside its edges."""

DENSE = 350
"""Outlines of no more vertices have a form without inner points; that of larger ones is sparse."""

Form = Floats | sparse.csc_array
"""Without inner points or with them."""

_BATCH = 64
"""So many right sides are solved before asking again whether to stop."""


@dataclass(frozen=True, eq=False)
class Metric:
    """A quadratic form on displacements of an outline; without dimension.

    Attributes
    ----------
    whole : (m, m) sparse array
        The form, for one coordinate, of the n points of the outline and of inner points behind them.
    stiffness : (n, n) array
        The form of the outline, inner points where the strain is least.
    compliance : (n, n) array
        Its inverse.
    size : float
        The shapes' extent, twice the largest distance from the mean of the vertices.
    """

    whole: sparse.csc_array
    stiffness: Floats
    compliance: Floats
    size: float

    def strains(self, away: Complex, step: Complex) -> tuple[float, float, float]:
        """Give half the form of displacements and s steps of the outline, as a polynomial in s."""
        parts = np.array([[away.real, away.imag], [step.real, step.imag]]).transpose(2, 0, 1)
        pulls = (self.stiffness @ parts.reshape(len(away), 4)).reshape(parts.shape)
        forms = np.einsum("nic,njc->ij", parts, pulls)
        return float(forms[0, 0]) / 2, float(forms[0, 1]), float(forms[1, 1]) / 2

    def turned(self, goal: Complex, frame: Complex) -> Complex:
        """Give a goal whose parts are turned as they are in a frame, and that lies where the frame does.

        One round of local rotations and global solving (Sorkine and Alexa 2007), over all pairs of vertices:
        off its diagonal the stiffness is minus what each of them weighs.
        """
        one = np.ones(len(frame))
        back = goal.conj()
        sums, goals, frames, products = (self.stiffness @ z for z in (one, back, frame, back * frame))
        turns = frame * goals + back * frames - products - sums * back * frame
        sizes = np.abs(turns)
        turns = np.where(sizes > 0, turns / np.where(sizes > 0, sizes, 1.0), 1.0)
        goals, turned, products = (self.stiffness @ z for z in (goal, turns, turns * goal))
        pulls = (turns * goals + products - goal * turned - sums * turns * goal) / 2
        return np.asarray(self.compliance @ (pulls + sums * frame))

    @cached_property
    def both(self) -> Form:
        """The form of the x of all points, and behind them the y; inner points only where it is sparse."""
        if len(self.stiffness) <= DENSE:
            return np.asarray(np.kron(np.eye(2), self.stiffness))
        return sparse.csc_array(sparse.block_diag((self.whole, self.whole), format="csc"))


def metric_of(decomposition: Decomposition, size: float, task: Task) -> Metric:
    """Weigh the edges of the fans of all pieces by 1 / length^2: what counts is strain."""
    fans = fans_of(decomposition, task)
    n, m = len(decomposition.pair), len(fans.source)
    ends = np.sort(fans.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    i, j = np.unique(ends, axis=0).T
    lengths = sum(np.abs(z[i] - z[j]) for z in (as_complex(fans.source), as_complex(fans.target))) / 2
    on_ring = (j < n) & ((j - i == 1) | (j - i == n - 1))
    weights = np.where(on_ring, ON_RING, 1.0) / np.maximum(lengths, SHORTEST_EDGE * size) ** 2
    incidence = _incidence(i, j, m)
    held = np.where(np.arange(m) < n, HELD / size**2, 0.0)
    whole = sparse.csc_array(incidence.T @ sparse.diags_array(weights) @ incidence + sparse.diags_array(held))
    stiffness = whole[:n, :n].toarray()
    if m > n:
        stiffness -= whole[:n, n:] @ _solved(whole[n:, n:], whole[n:, :n].toarray(), task)
    return Metric(whole, stiffness, _solved(whole, np.eye(m, n), task)[:n], size)


def _solved(matrix: sparse.csc_array, right: Floats, task: Task) -> Floats:
    """Solve for columns, not too many at a time."""
    factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    parts = []
    for k in range(0, right.shape[1], _BATCH):
        task.reach(0)
        parts.append(factors.solve(right[:, k : k + _BATCH]))
    return np.concatenate(parts, axis=1)


def _incidence(i: Indices, j: Indices, m: int) -> sparse.csr_array:
    rows = np.arange(len(i))
    ones = np.ones(len(i))
    entries = np.concatenate([-ones, ones]), (np.tile(rows, 2), np.concatenate([i, j]))
    return sparse.csr_array(entries, shape=(len(i), m))
