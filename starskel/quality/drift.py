"""How far frames drift from what is between source and target in even steps."""

from collections.abc import Callable, Sequence

import numpy as np

from starskel.arrays import Floats
from starskel.outline import edge_lengths, turning_angles

_EVEN_STEPS = 50
"""Steps over which a vertex should move evenly."""


def linear(start: Floats, end: Floats, times: Floats) -> Floats:
    """Blend values linearly: for start and end of shape (...) give (k, ...)."""
    t = times.reshape(-1, *[1] * np.ndim(start))
    return np.asarray((1 - t) * start + t * end)


def length_deviations(lengths: Floats, times: Floats) -> Floats:
    """Give for each frame the part by which edge lengths, (k, n), differ in sum from the linear blend."""
    expected = linear(lengths[0], lengths[-1], times)
    return np.asarray(np.abs(lengths - expected).sum(axis=1) / expected.sum(axis=1))


def angle_deviation(rings: Sequence[Floats], times: Floats) -> float:
    """Give the mean by which turning angles of (k, n, 2) rings differ from their linear blend, in radians.

    Angles count by the lengths of the edges beside them; a ring that is a point has the angles that it has
    at the other end.
    """
    differences, weights = zip(*(_turns(ring, times) for ring in rings), strict=True)
    off, weight = np.concatenate(differences, axis=1), np.concatenate(weights, axis=1)
    return float(((weight * off).sum(axis=1) / weight.sum(axis=1)).mean())


def _turns(ring: Floats, times: Floats) -> tuple[Floats, Floats]:
    """Give how far turning angles are off in each frame, and how much they count, (k, n)."""
    angles, lengths = turning_angles(ring), edge_lengths(ring[[0, -1]])
    start, end = angles[0 if lengths[0].any() else -1], angles[-1 if lengths[1].any() else 0]
    differences = np.angle(np.exp(1j * (angles - linear(start, end, times))))
    adjacent = lengths + np.roll(lengths, 1, axis=1)
    return np.abs(differences), linear(adjacent[0], adjacent[1], times)


def roughness(rings_at: Callable[[Floats], list[Floats]], rings: Sequence[Floats]) -> float:
    """Give how far a vertex is at most from the middle of where it is 1/50 before and after.

    Parameters
    ----------
    rings_at : callable
        Gives the rings at some times, as `Blend.rings`.
    rings : sequence of (k, n, 2) arrays
        What it gives at k times evenly spread over [0, 1]; computed anew where they are not among these.

    Returns
    -------
    float, in parts of the longer side of the boxes of source and target
    """
    stride, rest = divmod(len(rings[0]) - 1, _EVEN_STEPS)
    if not stride or rest:
        stride, rings = 1, rings_at(np.linspace(0, 1, _EVEN_STEPS + 1))
    rows = np.concatenate([ring[::stride] for ring in rings], axis=1)
    strayed = rows[1:-1] - (rows[:-2] + rows[2:]) / 2
    size = np.ptp(rows[[0, -1]], axis=1).max()
    return float(np.hypot(strayed[..., 0], strayed[..., 1]).max() / size)
