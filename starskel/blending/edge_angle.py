"""Edge-angle interpolation (Sederberg, Gao, Wang and Mu 1993, "2-D Shape Blending").

Edge lengths and turning angles are linear in t. The outline that they give does not close; the lengths are
changed as little as possible so that it does, an edge being the softer, the more its own length differs
between the shapes.
"""

import numpy as np
from numpy.typing import ArrayLike

from starskel.arrays import Complex, Flags, Floats, read_only
from starskel.blending.frames import Blend, checked_times, placed, with_exact_ends
from starskel.correspondence import Correspondence
from starskel.decomposition.canonical import canonical
from starskel.outline import edge_lengths, edge_vectors, turning_angles
from starskel.polar import PolarVectors, as_complex, as_points
from starskel.predicates import ROUNDING

_STIFFEST = 1e-4
"""The least softness of an edge, as a part of the softest one's, and of the mean edge length."""


class EdgeAngleBlend(Blend):
    """Edge lengths and turning angles are interpolated, the lengths adjusted to close the outline.

    The directions of all edges turn evenly, and the outline's centre of mass moves straight.

    Attributes
    ----------
    edges : PolarVectors
        The edges as they would be if the outline need not close.
    softness : (n,) array
        How readily each edge changes its length, as a part of the softest one's.
    """

    method = "edge-angle"

    def __init__(self, pair: Correspondence) -> None:
        super().__init__(pair)
        self.edges = _turning_edges(pair)
        self.softness = read_only(_softness(edge_lengths(pair.source), edge_lengths(pair.target)))
        ends = np.array([0.0, 1.0])
        self.errors = read_only(self._placed(ends) - np.stack([pair.source, pair.target]))

    def lengths(self, ts: ArrayLike) -> Floats:
        """Give the signed edge lengths at each of k times, (k, n): a negative edge runs backwards."""
        times = checked_times(ts)
        return self._closed(self.edges.lengths(times), self.edges.directions(times))

    def negative_lengths(self, ts: ArrayLike) -> Flags:
        """Tell at which of the times the outline closes only with an edge of negative length."""
        return np.asarray(self.lengths(ts).min(axis=1) < 0)

    def _frames(self, ts: Floats) -> Floats:
        return with_exact_ends(self._placed(ts), ts, self.errors)

    def _placed(self, ts: Floats) -> Floats:
        directions = self.edges.directions(ts)
        steps = self._closed(self.edges.lengths(ts), directions) * directions
        return placed(as_points(np.roll(np.cumsum(steps, axis=1), 1, axis=1)), ts, self.pair)

    def _closed(self, lengths: Floats, directions: Complex) -> Floats:
        """Change the lengths by the least that closes the outline; twice, for the sake of rounding."""
        parts = np.stack([directions.real, directions.imag], axis=1)
        soft = parts * self.softness
        normal = soft @ parts.transpose(0, 2, 1)
        # Where all edges are parallel, as far as floats can tell, nothing closes across them.
        inverse = np.linalg.pinv(normal, rcond=ROUNDING, hermitian=True)
        for _ in range(2):
            gaps = parts @ lengths[:, :, None]
            lengths = lengths - ((inverse @ gaps).transpose(0, 2, 1) @ soft)[:, 0]
        return lengths


def _turning_edges(pair: Correspondence) -> PolarVectors:
    """Give the edges; from one to the next the rotation changes by the difference of the turning angles."""
    source, target = (as_complex(edge_vectors(ring)) for ring in (pair.source, pair.target))
    bends = turning_angles(pair.target) - turning_angles(pair.source)
    bends[0] = np.angle(target[0] / source[0])
    return PolarVectors.between(source, target, np.cumsum(bends), left=not canonical(pair).swapped)


def _softness(source: Floats, target: Floats) -> Floats:
    change = np.abs(source - target)
    least = _STIFFEST * max(change.max(), (source + target).mean() / 2)
    return np.asarray((np.maximum(change, least) / max(change.max(), least)) ** 2)
