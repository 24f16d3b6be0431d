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

from starskel.arrays import Complex, Floats
from starskel.blending.certified.morphing.surroundings import SQUARE, Surroundings
from starskel.blending.meshes.mean_values import mean_values
from starskel.polar import as_points
from starskel.task import UNWATCHED, Task


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

    def frames(self, ts: Floats, task: Task = UNWATCHED) -> Floats:
        """Give the (k, n, 2) rings, back from the square, at each of k times; that may be stopped."""
        rings = []
        for t in ts.tolist():
            task.quiet.reach(0)
            rings.append(as_points(self._back(self._inner(t)[: self.count], t)))
        return np.stack(rings)

    def _inner(self, t: float) -> Complex:
        """Solve for the inner points."""
        weights = (1 - t) * self.source + t * self.target
        inner = weights.shape[0] - len(SQUARE)
        matrix = sparse.eye_array(inner) - weights[:inner, :inner]
        pull = weights[:inner, inner:] @ np.stack([SQUARE.real, SQUARE.imag], axis=1)
        factors = splu(
            sparse.csc_array(matrix),
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )
        places = factors.solve(pull)
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
        mean_values(points, surroundings.triangles) for points in (surroundings.source, surroundings.target)
    )
    return ConvexCombination(surroundings, count, source, target)
