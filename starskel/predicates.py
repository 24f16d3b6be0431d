"""Exact decisions about points: on which side of a line a point lies.

A determinant in floating point is believed where it exceeds its own error bound (Shewchuk 1997, "Adaptive
Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates"). What that filter leaves open is
summed without any rounding: every product is split into its rounded value and its error, and the twelve parts
are distilled until they do not overlap, so that the largest of them carries the sign.

This module holds the only tolerances of decisions: `ROUNDING`, and `NEAR` for what is proven exactly after.
By `DIGITS` nothing is decided that is right or wrong, only which of equals is taken.
"""

import numpy as np

from starskel.arrays import Flags, Floats, Signs

UNIT = 2.0**-53
"""The largest relative error of one rounded operation."""

ROUNDING = 8 * UNIT
"""Coordinates count as known to this part of the largest of them: inserted vertices are rounded."""

NEAR = 1e-9
"""Smaller shares are no matter of floats: what is found with this counts only once it is proven."""

DIGITS = 9
"""Where one of several is chosen, what agrees to so many decimals is equal: rounding chooses nothing."""

LARGEST = 1e75
"""Products of four larger coordinates overflow, those of coordinates all below 1/LARGEST underflow."""

_FILTER = (3 + 16 * UNIT) * UNIT
_SPLITTER = 2.0**27 + 1


def orientation(a: Floats, b: Floats, c: Floats) -> Signs:
    """Tell whether the turn from a over b to c is left (1), right (-1) or none (0), exactly.

    Parameters
    ----------
    a, b, c : (..., 2) arrays
        Points; the leading shapes broadcast.

    Returns
    -------
    (...) array of int8
    """
    left = (a[..., 0] - c[..., 0]) * (b[..., 1] - c[..., 1])
    right = (a[..., 1] - c[..., 1]) * (b[..., 0] - c[..., 0])
    determinant = left - right
    signs: Signs = np.asarray(np.sign(determinant), dtype=np.int8)
    bound = _FILTER * (np.abs(left) + np.abs(right))
    undecided = (np.abs(determinant) <= bound) & (bound > 0)  # where both products vanish, so they do exactly
    if undecided.any():
        points = [np.broadcast_to(p, (*undecided.shape, 2))[undecided] for p in (a, b, c)]
        signs = np.array(signs)  # a scalar result is not assignable
        signs[undecided] = _exact_orientation(*points)
    return signs


def _exact_orientation(a: Floats, b: Floats, c: Floats) -> Signs:
    if (_exact_difference(a, c) & _exact_difference(b, c)).all():  # so it is on grids and between neighbours
        return _sign_of_cross_products([(a - c, b - c)])
    return _sign_of_cross_products([(a, b), (b, c), (c, a)])


def _exact_difference(a: Floats, b: Floats) -> Flags:
    """Tell whether a - b is free of rounding in both coordinates (the error term of Knuth's sum)."""
    difference = a - b
    virtual = a - difference
    error = (a - (difference + virtual)) + (virtual - b)
    exact: Flags = (error == 0).all(axis=1)
    return exact


def _sign_of_cross_products(pairs: list[tuple[Floats, Floats]]) -> Signs:
    parts: list[Floats] = []
    for p, q in pairs:
        parts += _two_product(p[:, 0], q[:, 1])
        parts += _two_product(-p[:, 1], q[:, 0])
    return _sign_of_sum(np.array(parts))


def _two_product(a: Floats, b: Floats) -> tuple[Floats, Floats]:
    """Give the rounded product and its rounding error (Dekker 1971)."""
    product = a * b
    a_high, a_low = _split(a)
    b_high, b_low = _split(b)
    error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)
    return product, error


def _split(a: Floats) -> tuple[Floats, Floats]:
    scaled = _SPLITTER * a
    high = scaled - (scaled - a)
    return high, a - high


def _sign_of_sum(parts: Floats) -> Signs:
    """Give the exact sign of the sum over axis 0, by error-free sums repeated until nothing changes."""
    while True:
        before = parts.copy()
        for i in range(1, len(parts)):
            total = parts[i] + parts[i - 1]
            virtual = total - parts[i - 1]
            parts[i - 1] = (parts[i - 1] - (total - virtual)) + (parts[i] - virtual)
            parts[i] = total
        if np.array_equal(before, parts):
            break
    largest = np.take_along_axis(parts, np.abs(parts).argmax(axis=0)[None], axis=0)[0]
    signs: Signs = np.sign(largest).astype(np.int8)
    return signs


def segments_meet(a: Floats, b: Floats, c: Floats, d: Floats) -> Flags:
    """Tell whether closed segments ab and cd, (..., 2), whose boxes overlap, have a common point, exactly."""
    parted_by_ab = orientation(a, b, c) * orientation(a, b, d) > 0
    parted_by_cd = orientation(c, d, a) * orientation(c, d, b) > 0
    meet: Flags = ~(parted_by_ab | parted_by_cd)
    return meet


def folds_back(a: Floats, b: Floats, c: Floats) -> Flags:
    """Tell whether the way from a over b to c, (..., 2), turns back on itself at b, exactly."""
    same_side = (np.sign(a - b) * np.sign(c - b) > 0).any(axis=-1)
    folded: Flags = same_side & (orientation(a, b, c) == 0)
    return folded
