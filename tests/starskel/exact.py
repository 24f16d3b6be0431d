"""Visibility by rational arithmetic and definition: slow, plain, and independent of the library."""

from fractions import Fraction
from itertools import pairwise

import numpy as np

Point = tuple[Fraction, Fraction]


def rational(ring):
    return [(Fraction(float(x)), Fraction(float(y))) for x, y in ring]


def turn(a: Point, b: Point, c: Point) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def on_segment(p: Point, a: Point, b: Point) -> bool:
    if turn(a, b, p) != 0:
        return False
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def locate(p: Point, ring: list[Point]) -> int:
    """1 inside, 0 on the ring, -1 outside."""
    inside = False
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        if on_segment(p, a, b):
            return 0
        if (a[1] > p[1]) != (b[1] > p[1]) and (turn(a, b, p) > 0) == (b[1] > a[1]):
            inside = not inside
    return 1 if inside else -1


def stops(p: Point, q: Point, ring: list[Point]) -> list[Fraction]:
    """The parameters at which the segment pq meets edges of the ring."""
    found = {Fraction(0), Fraction(1)}
    length = (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        across, start = turn(p, q, b) - turn(p, q, a), turn(p, q, a)
        if across != 0:
            s = -start / across
            meeting = (a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]))
            candidates = [meeting] if 0 <= s <= 1 else []
        else:
            candidates = [a, b] if start == 0 else []
        for x, y in candidates:
            found.add(((x - p[0]) * (q[0] - p[0]) + (y - p[1]) * (q[1] - p[1])) / length)
    return sorted(t for t in found if 0 <= t <= 1)


def relations(i: int, j: int, points: list[Point], ring: list[Point]) -> tuple[bool, bool]:
    """Whether point i sees point j, and whether ij is a diagonal of the ring."""
    p, q = points[i], points[j]

    def at(t: Fraction) -> Point:
        return p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])

    ways = stops(p, q, ring)
    between = [locate(at((s + t) / 2), ring) for s, t in pairwise(ways)]
    sees = all(place >= 0 for place in between)
    return sees, len(ways) == 2 and between == [1]


def all_relations(ring) -> tuple[np.ndarray, np.ndarray]:
    exact = rational(ring)
    n = len(exact)
    sees, diagonal = np.eye(n, dtype=bool), np.zeros((n, n), dtype=bool)
    for i in range(n):
        for j in range(i):
            sees[i, j], diagonal[i, j] = relations(i, j, exact, exact)
            sees[j, i], diagonal[j, i] = sees[i, j], diagonal[i, j]
    return sees, diagonal
