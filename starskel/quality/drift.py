"""How far frames drift from what is between source and target in even steps."""

import numpy as np

from starskel.arrays import Floats
from starskel.outline import edge_lengths, turning_angles


def linear(start: Floats, end: Floats, times: Floats) -> Floats:
    """Blend values linearly: for start and end of shape (...) give (k, ...)."""
    t = times.reshape(-1, *[1] * np.ndim(start))
    return np.asarray((1 - t) * start + t * end)


def length_deviations(lengths: Floats, times: Floats) -> Floats:
    """Give for each frame the part by which edge lengths, (k, n), differ in sum from the linear blend."""
    expected = linear(lengths[0], lengths[-1], times)
    return np.asarray(np.abs(lengths - expected).sum(axis=1) / expected.sum(axis=1))


def angle_deviation(rings: Floats, times: Floats) -> float:
    """Give the mean by which turning angles of (k, n, 2) rings differ from their linear blend, in radians.

    Angles count by the lengths of the edges beside them.
    """
    angles, lengths = turning_angles(rings), edge_lengths(rings[[0, -1]])
    differences = np.angle(np.exp(1j * (angles - linear(angles[0], angles[-1], times))))
    adjacent = lengths + np.roll(lengths, 1, axis=1)
    weights = linear(adjacent[0], adjacent[1], times)
    return float(((weights * np.abs(differences)).sum(axis=1) / weights.sum(axis=1)).mean())


def roughness(rings: Floats) -> float:
    """Give how far a vertex is at most from the middle of where it is one frame before and after.

    Parameters
    ----------
    rings : (k, n, 2) array
        Frames at even steps, source and target at the ends; in parts of the longer side of their boxes.
    """
    strayed = rings[1:-1] - (rings[:-2] + rings[2:]) / 2
    size = np.ptp(rings[[0, -1]], axis=1).max()
    return float(np.hypot(strayed[..., 0], strayed[..., 1]).max() / size)
