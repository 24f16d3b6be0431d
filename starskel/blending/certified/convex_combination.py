"""The last resort: every point a mean of its neighbours, with weights that go evenly from source to target.

Source and target lie in one square, inside and outside triangulated in the same way. Each inner point is a
convex combination of its neighbours, by mean value coordinates (Floater 2003). At any time the weights are
positive, and the corners of the square stay: so the triangulation is never folded (Tutte 1963, Floater and
Gotsman 1999), and the ring, which consists of edges of it, never crosses itself (Surazhsky and Gotsman 2001).
"""

from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from starskel.blending.certified.surroundings import SQUARE, Surroundings
from starskel.blending.mesh import corner_angles
from starskel.polar import as_points
from starskel.predicates import Complex, Floats, Indices

_FLATTEST = 1e-6
"""Angles keep so far from 0 and from pi: some triangles have no area, where vertices lie on a line."""


@dataclass(frozen=True, eq=False)
class ConvexCombination:
    """A morph of everything in the square.

    Attributes
    ----------
    surroundings : Surroundings
    count : int
        How many of the points are the ring's.
    source, target : (m, m) sparse arrays
        The weights of each point's neighbours, which sum up to 1 for inner points.
    """

    surroundings: Surroundings
    count: int
    source: sparse.csr_array
    target: sparse.csr_array

    def frames(self, ts: Floats) -> Floats:
        """Give the (k, n, 2) rings, back from the square, at each of k times."""
        return np.stack([as_points(self._back(self._inner(float(t))[: self.count], float(t))) for t in ts])

    def _inner(self, t: float) -> Complex:
        """Solve for the inner points."""
        weights = (1 - t) * self.source + t * self.target
        inner = weights.shape[0] - len(SQUARE)
        matrix = sparse.eye_array(inner) - weights[:inner, :inner]
        pull = weights[:inner, inner:] @ np.stack([SQUARE.real, SQUARE.imag], axis=1)
        places = splu(sparse.csc_array(matrix)).solve(pull)
        return np.asarray(places[:, 0] + 1j * places[:, 1])

    def _back(self, points: Complex, t: float) -> Complex:
        """Turn, scale and move evenly."""
        first, last = self.surroundings.places
        growth = abs(last.scale) / abs(first.scale)
        scale = first.scale * ((1 - t) + t * growth) * np.exp(1j * t * self.surroundings.turn)
        return np.asarray((1 - t) * first.centre + t * last.centre + scale * points)


def convex_combination_of(surroundings: Surroundings, count: int) -> ConvexCombination:
    """Prepare the morph of a pair of this many vertices."""
    source, target = (
        _mean_values(points, surroundings.triangles) for points in (surroundings.source, surroundings.target)
    )
    return ConvexCombination(surroundings, count, source, target)


def _mean_values(points: Complex, triangles: Indices) -> sparse.csr_array:
    """Give the mean value coordinates of inner points among their neighbours."""
    corners = points[triangles]
    angles = np.clip(corner_angles(corners), _FLATTEST, np.pi - _FLATTEST)
    halves = np.tan(angles / 2)
    rows, columns, values = [], [], []
    for step in (1, 2):
        other = np.roll(triangles, -step, axis=1)
        distances = np.maximum(np.abs(points[other] - corners), np.finfo(np.float64).tiny)
        rows.append(triangles.ravel())
        columns.append(other.ravel())
        values.append((halves / distances).ravel())
    count = len(points)
    entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
    weights = sparse.csr_array(entries, shape=(count, count))
    return sparse.csr_array(sparse.diags_array(1 / weights.sum(axis=1)) @ weights)
