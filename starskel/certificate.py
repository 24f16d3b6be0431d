"""Proofs that a moving ring never crosses itself, at no moment between two frames.

While every vertex moves evenly along a straight line, a simple ring stops being simple only at a moment when
a vertex touches an edge that it is no end of; folds and collapsing edges are such moments, too. Seen from a
vertex, let the edge's ends be the complex numbers p and q. The vertex lies on the edge where conj(p) q is a
number on the negative real axis, zero included. In time that product is a quadratic curve, which stays in the
triangle of its Bernstein coefficients: a triangle off the negative axis proves the pair of vertex and edge
clear. Other curves are halved (de Casteljau), a few times. All that carries rigorous bounds on rounding; what
they leave open is decided in rational arithmetic, from the roots. So the answers are right, and final.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction

import numpy as np
import shapely

from starskel.arrays import Complex, Flags, Floats, Indices
from starskel.polar import as_complex
from starskel.predicates import UNIT

HALVINGS = 8
"""How often a curve is halved before rational arithmetic decides."""

_MOST_CURVES = 1 << 18
"""So many pairs are looked at together, and so many halves: pairs that touch all the time would double on."""

_FEW = 400
"""Boxes of rings with no more vertices are compared each with each: that is quicker than to plant a tree."""

_ROUNDING = (8 + 2 * HALVINGS) * UNIT
"""Bounds the rounding of a coefficient, over the product of the largest distances: up to four differences,
four products and their sum; then two means with every halving."""

_TINY = float(np.finfo(np.float64).tiny)


def safe(before: Floats, after: Floats) -> bool:
    """Tell whether a simple ring stays simple while its vertices move evenly from one frame to another.

    Exact: the answer is that for the coordinates as they are, and for all moments, both ends included.

    Parameters
    ----------
    before, after : (n, 2) arrays
        The ring at both ends; it is taken for granted that it does not cross itself before.
    """
    pairs = near_pairs(as_complex(before), as_complex(after), 0.0)
    return not any(meet(before, after, vertex, edge) for vertex, edge in pairs)


def safe_rings(before: Floats, after: Floats, following: Indices, excused: Flags) -> bool:
    """Tell whether rings touch neither themselves nor each other while their vertices move evenly.

    Exact, like `safe`.

    Parameters
    ----------
    before, after : (n, 2) arrays
        The vertices of all rings at both ends.
    following : (n,) array of int
        For each vertex the one after it on its ring.
    excused : (n, n) array of bool
        For a vertex and an edge, named by its first end, whether they may touch.
    """
    for vertex, edge in near_pairs(as_complex(before), as_complex(after), 0.0, following):
        due = ~excused[vertex, edge]
        if meet(before, after, vertex[due], edge[due], following):
            return False
    return True


def meet(
    before: Floats, after: Floats, vertex: Indices, edge: Indices, following: Indices | None = None
) -> bool:
    """Tell whether of some pairs a vertex touches its edge while rings move evenly; exact, like `safe`."""
    first, second = as_complex(before), as_complex(after)
    onward = _onward(len(before)) if following is None else following
    open_ = _undecided(*seen_ends(first, vertex, edge, onward), *seen_ends(second, vertex, edge, onward))
    return any(_touches(before, after, int(vertex[k]), int(edge[k]), onward) for k in open_)


def first_unsafe(keys: Floats) -> int | None:
    """Give the first of the links between (k, n, 2) keyframes that is not safe; None where all are."""
    return next((k for k in range(len(keys) - 1) if not safe(keys[k], keys[k + 1])), None)


def near_pairs(
    first: Complex, second: Complex, reach: float, following: Indices | None = None
) -> Iterator[tuple[Indices, Indices]]:
    """Give the vertices and edges that may come within this reach of each other, not many at a time.

    An edge counts by its first end; edges that end in the vertex are left out.

    Parameters
    ----------
    first, second : (n,) complex arrays
        The ring at both ends of an even motion.
    reach : float
        Not negative; rounding is allowed for.
    following : (n,) array of int, optional
        For each vertex the one after it, where there are several rings.
    """
    n = len(first)
    onward = _onward(n) if following is None else following
    lows = np.minimum(first.real, second.real), np.minimum(first.imag, second.imag)
    highs = np.maximum(first.real, second.real), np.maximum(first.imag, second.imag)
    slack = reach * (1 + 8 * UNIT) + 4 * UNIT * float(max(np.abs(first).max(), np.abs(second).max()))
    edges = [np.minimum(low, low[onward]) for low in lows]
    edges += [np.maximum(high, high[onward]) for high in highs]
    wide = lows[0] - slack, lows[1] - slack, highs[0] + slack, highs[1] + slack
    overlaps = _compared(wide, edges) if n <= _FEW else _looked_up(wide, edges)
    for vertex, edge in overlaps:
        foreign = (vertex != edge) & (vertex != onward[edge])
        yield vertex[foreign], edge[foreign]


def _compared(boxes: Sequence[Floats], others: Sequence[Floats]) -> Iterator[tuple[Indices, Indices]]:
    """Give the boxes (left, bottom, right, top) that overlap with others, each compared with each."""
    left, bottom, right, top = (side[:, None] for side in boxes)
    overlap = (left <= others[2]) & (others[0] <= right)
    overlap &= bottom <= others[3]
    overlap &= others[1] <= top
    first, second = overlap.nonzero()
    yield first, second


def _looked_up(boxes: Sequence[Floats], others: Sequence[Floats]) -> Iterator[tuple[Indices, Indices]]:
    """Give the boxes (left, bottom, right, top) that overlap with others, from a tree of these."""
    tree = shapely.STRtree(shapely.box(*others))
    wide = shapely.box(*boxes)
    step = max(1, _MOST_CURVES // len(wide))
    for k in range(0, len(wide), step):
        first, second = tree.query(wide[k : k + step])
        yield first + k, second


def seen_ends(
    ring: Complex, vertex: Indices, edge: Indices, following: Indices | None = None
) -> tuple[Complex, Complex]:
    """Give both ends of edges as seen from vertices, as complex numbers."""
    place = ring[vertex]
    end = (edge + 1) % len(ring) if following is None else following[edge]
    return ring[edge] - place, ring[end] - place


def _onward(n: int) -> Indices:
    """Give for each vertex of one ring the next."""
    return np.append(np.arange(1, n), 0)


def _undecided(p0: Complex, q0: Complex, p1: Complex, q1: Complex) -> Indices:
    """Give the pairs that floating point does not prove clear, p and q seen before (0) and after (1)."""
    curves = np.stack([p0.conj() * q0, (p0.conj() * q1 + p1.conj() * q0) / 2, p1.conj() * q1])
    scale = np.maximum(np.abs(p0), np.abs(p1)) * np.maximum(np.abs(q0), np.abs(q1))
    bounds = _ROUNDING * scale + _TINY
    rows, found = np.arange(len(p0)), []
    for _ in range(HALVINGS):
        open_ = ~_clear(curves, bounds)
        still = open_ & (curves == curves[0]).all(axis=0)  # halves of a point are no better
        found.append(rows[still])
        open_ &= ~still
        curves, bounds, rows = _halves(curves[:, open_]), np.tile(bounds[open_], 2), np.tile(rows[open_], 2)
        if not 0 < len(rows) < _MOST_CURVES:
            return np.unique(np.concatenate([rows, *found]))
    return np.unique(np.concatenate([rows[~_clear(curves, bounds)], *found]))


def _clear(curves: Complex, bounds: Floats) -> Flags:
    """Tell which (3, k) triangles lie in one of five half-planes without the negative real axis."""
    real, imaginary = curves.real, curves.imag
    low, high = imaginary.min(axis=0), imaginary.max(axis=0)
    beside = (low > bounds) | (high < -bounds)
    ahead = np.maximum((real + imaginary).min(axis=0), (real - imaginary).min(axis=0)) > 3 * bounds
    return np.asarray(beside | ahead | (real.min(axis=0) > bounds))


def _halves(curves: Complex) -> Complex:
    start, middle, end = curves
    left, right = (start + middle) / 2, (middle + end) / 2
    centre = (left + right) / 2
    return np.concatenate([np.stack([start, left, centre]), np.stack([centre, right, end])], axis=1)


def _touches(before: Floats, after: Floats, vertex: int, edge: int, following: Indices) -> bool:
    """Tell whether a vertex touches an edge at some moment in [0, 1], in rational arithmetic."""
    corners = [edge, following[edge]]
    (vx, vy), *ends = (_path(before[k], after[k]) for k in (vertex, *corners))
    (px, py), (qx, qy) = (((x[0] - vx[0], x[1] - vx[1]), (y[0] - vy[0], y[1] - vy[1])) for x, y in ends)
    cross = _sum(_product(px, qy), _product(py, qx), -1)
    dot = _sum(_product(px, qx), _product(py, qy), 1)
    return _not_positive_at_roots(dot, cross)


Line = tuple[Fraction, Fraction]
Quadratic = tuple[Fraction, Fraction, Fraction]


def _path(start: Floats, end: Floats) -> tuple[Line, Line]:
    """Give both coordinates of an even motion as value at the start, and gain."""
    (x0, y0), (x1, y1) = ((Fraction(x), Fraction(y)) for x, y in (start.tolist(), end.tolist()))
    return (x0, x1 - x0), (y0, y1 - y0)


def _product(a: Line, b: Line) -> Quadratic:
    return a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[1] * b[1]


def _sum(a: Quadratic, b: Quadratic, sign: int) -> Quadratic:
    return a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]


def _not_positive_at_roots(dot: Quadratic, cross: Quadratic) -> bool:
    """Tell whether one quadratic is at most zero at a root in [0, 1] of the other."""
    c, b, a = cross
    if not a:
        if not b:
            return not c and _least(dot) <= 0
        return 0 <= -c / b <= 1 and _value(dot, -c / b) <= 0
    square = b * b - 4 * a * c
    if square < 0:
        return False
    share = dot[2] / a
    rest = dot[0] - share * c, dot[1] - share * b  # what dot is at the roots of cross, as a line
    return any(
        _sign(-b / (2 * a), way / (2 * a), square) >= 0
        and _sign(1 + b / (2 * a), -way / (2 * a), square) >= 0
        and _sign(rest[0] - rest[1] * b / (2 * a), rest[1] * way / (2 * a), square) <= 0
        for way in (1, -1)
    )


def _least(quadratic: Quadratic) -> Fraction:
    """Give the least value in [0, 1]."""
    _, b, a = quadratic
    turn = -b / (2 * a) if a > 0 else Fraction(0)
    return min(
        _value(quadratic, s) for s in (Fraction(0), Fraction(1), min(max(turn, Fraction(0)), Fraction(1)))
    )


def _value(quadratic: Quadratic, s: Fraction) -> Fraction:
    return quadratic[0] + s * (quadratic[1] + s * quadratic[2])


def _sign(x: Fraction, y: Fraction, square: Fraction) -> int:
    """Give the sign of x + y sqrt(square)."""
    if min(x, y) >= 0 or max(x, y) <= 0:
        total = x + y if square else x
        return (total > 0) - (total < 0)
    difference = x * x - y * y * square
    sign = (difference > 0) - (difference < 0)
    return sign if x > 0 else -sign
