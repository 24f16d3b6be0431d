"""Bezier curves as lines of a stated accuracy."""

from math import ceil, sqrt

import numpy as np

from starskel.predicates import Floats

MOST = 256
"""Points that one curve is given at most; only a tolerance far below what a screen shows asks for more."""


def flattened(curve: Floats, tolerance: float) -> Floats:
    """Give points along a cubic Bezier curve so near that the lines between them stay within a tolerance.

    A line over a step h of the parameter leaves a curve by at most h^2/8 times its largest second derivative,
    and that of a cubic is reached at one of its ends.

    Parameters
    ----------
    curve : (4, 2) array
        Start, two control points, end.
    tolerance : float
        The largest distance between curve and lines, above 0, in the units of the points.

    Returns
    -------
    (k, 2) array
        Without the start, with the end.
    """
    bends = 6 * np.hypot(*(curve[:-2] - 2 * curve[1:-1] + curve[2:]).T)
    count = min(max(ceil(sqrt(float(bends.max()) / (8 * tolerance))), 1), MOST)
    t = np.arange(1, count + 1)[:, None] / count
    a, b, c, d = curve
    points: Floats = (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d
    points[-1] = d
    return points
