"""Curves as lines: Bezier curves are cut so finely that no chord leaves them by more than a tolerance."""

from itertools import pairwise
from math import ceil, sqrt

import numpy as np

from starskel.arrays import Floats

_MOST = 1000
"""Chords that a single curve gets at most."""


def flattened(control: Floats, tolerance: float) -> Floats:
    """Give points on a Bezier curve behind its start, the end the last.

    A chord over a share 1/n of the parameter is off by at most max|B''| / (8 n^2), and B'' is bounded by the
    second differences of the control points.

    Parameters
    ----------
    control : (k, 2) array
        The control points: two of a line, three of a quadratic, four of a cubic curve.
    tolerance : float
        How far a chord may leave the curve, in the same units.
    """
    degree = len(control) - 1
    if degree == 1:
        return control[1:]
    bends = control[2:] - 2 * control[1:-1] + control[:-2]
    bend = degree * (degree - 1) * float(np.hypot(bends[:, 0], bends[:, 1]).max())
    count = min(max(ceil(sqrt(bend / (8 * tolerance))), 1), _MOST) if tolerance > 0 else _MOST
    points = [np.repeat(row[None], count, axis=0) for row in control]
    t = (np.arange(1, count + 1) / count)[:, None]
    while len(points) > 1:  # de Casteljau
        points = [(1 - t) * a + t * b for a, b in pairwise(points)]
    points[0][-1] = control[-1]
    return points[0]
