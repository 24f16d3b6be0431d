"""Points that are known exactly, though some were rounded: vertices that lie on a straight run of a ring.

A vertex inserted on an edge is rounded to floats and so misses the edge by a hair. Taken literally it would
bend the edge, now inwards, now outwards, and hide the run's other vertices from each other. Here such a
vertex stands exactly on the chord of its run, as a share of the way between the corners at its ends; corners
stand where their coordinates say. All decisions are exact in this model, which differs from the coordinates
by less than `ROUNDING`.
"""

from dataclasses import dataclass, field
from functools import cached_property
from itertools import product
from typing import NamedTuple

import numpy as np

from starskel.arrays import Complex, Flags, Floats, Indices, Signs
from starskel.predicates import ROUNDING, orientation


@dataclass(frozen=True, eq=False)
class Points:
    """The vertices of a ring, followed by any number of further points.

    Attributes
    ----------
    coordinates : (m, 2) array
    start, end : (m,) arrays of int
        The points between which a rounded point lies; every other point names itself twice.
    share : (m,) array
        The share of the way from start to end, inside (0, 1) for rounded points.
    """

    coordinates: Floats
    start: Indices
    end: Indices
    share: Floats
    places: dict[int, "_Place"] = field(default_factory=dict, repr=False)

    @property
    def rounded(self) -> Flags:
        """For each point whether its coordinates miss its place, which its share tells."""
        rounded: Flags = self.start != self.end
        return rounded

    def with_free(self, coordinates: Floats) -> "Points":
        """Give these points followed by free ones at (k, 2) coordinates."""
        new = len(self.start) + np.arange(len(coordinates))
        return Points(
            np.concatenate([self.coordinates, coordinates]),
            np.concatenate([self.start, new]),
            np.concatenate([self.end, new]),
            np.concatenate([self.share, np.zeros(len(coordinates))]),
            dict(self.places),  # the new rows are other points in each copy
        )

    def with_on_chords(self, start: Indices, end: Indices, share: Floats) -> "Points":
        """Give these points followed by (k,) others exactly on chords, at a share of the way between two."""
        first, last = self.coordinates[start], self.coordinates[end]
        return Points(
            np.concatenate([self.coordinates, (1 - share)[:, None] * first + share[:, None] * last]),
            np.concatenate([self.start, start]),
            np.concatenate([self.end, end]),
            np.concatenate([self.share, share]),
            dict(self.places),
        )

    def again(self, rows: Indices) -> "Points":
        """Give these points followed by some of them once more."""
        free = self.start[rows] == self.end[rows]
        new = len(self.start) + np.arange(len(rows))
        return Points(
            np.concatenate([self.coordinates, self.coordinates[rows]]),
            np.concatenate([self.start, np.where(free, new, self.start[rows])]),
            np.concatenate([self.end, np.where(free, new, self.end[rows])]),
            np.concatenate([self.share, self.share[rows]]),
            dict(self.places),
        )

    @cached_property
    def _at(self) -> tuple[Complex, float]:
        """All points, and up to which doubled area of a triangle rounding might turn its sign."""
        return self.coordinates.view(np.complex128)[:, 0], doubtful_area(self.coordinates)

    @cached_property
    def _box(self) -> tuple[Floats, Floats]:
        """The corners of the box round all points."""
        return self.coordinates.min(axis=0), self.coordinates.max(axis=0)

    def orientation(self, i: Indices, j: Indices, k: Indices) -> Signs:
        """Tell whether the turn from point i over j to k is left (1), right (-1) or none (0), exactly."""
        at, doubtful = self._at
        base = at[k]
        doubled = ((at[i] - base).conj() * (at[j] - base)).imag
        signs = np.sign(doubled).astype(np.int8)
        close = np.abs(doubled) <= doubtful
        if close.any():
            signs[close] = self._decided(*(p[close] for p in np.broadcast_arrays(i, j, k)))
        return signs

    def orientation_to(self, i: Indices, j: Indices, k: Indices, places: Floats) -> Signs:
        """Tell the same of turns to free places, (h, 2) of which the k-th is meant, without adding them."""
        at, doubtful = self._at
        low, high = self._box
        if (places < low).any() or (places > high).any():  # rounding may matter more there
            return self.with_free(places).orientation(i, j, len(at) + k)
        base: Complex = places.view(np.complex128)[k, 0]
        doubled = ((at[i] - base).conj() * (at[j] - base)).imag
        signs: Signs = np.sign(doubled).astype(np.int8)
        close = np.flatnonzero(np.abs(doubled) <= doubtful)
        if len(close):
            signs[close] = self.with_free(places).orientation(i[close], j[close], len(at) + k[close])
        return signs

    def _decided(self, i: Indices, j: Indices, k: Indices) -> Signs:
        """Tell the same of points that are all but collinear."""
        signs = np.zeros(len(i), dtype=np.int8)
        apart = np.flatnonzero((i != j) & (j != k) & (k != i))
        if len(apart):
            i, j, k = i[apart], j[apart], k[apart]
            start, end = self.start[[i, j, k]], self.end[[i, j, k]]
            low, high = np.minimum(start, end).min(axis=0), np.maximum(start, end).max(axis=0)
            off_chord = (((start != low) & (start != high)) | ((end != low) & (end != high))).any(axis=0)
            rounded = (start != end).any(axis=0)
            for kind, turn in ((~rounded, self._between_free), (rounded, self._filtered)):
                chosen = np.flatnonzero(off_chord & kind)
                if len(chosen):
                    signs[apart[chosen]] = turn(i[chosen], j[chosen], k[chosen])
        return signs

    def _between_free(self, i: Indices, j: Indices, k: Indices) -> Signs:
        return orientation(*(self.coordinates[p] for p in (i, j, k)))

    def _filtered(self, i: Indices, j: Indices, k: Indices) -> Signs:
        a = self.coordinates[i] - self.coordinates[k]
        b = self.coordinates[j] - self.coordinates[k]
        determinant = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        slack = 2 * ROUNDING * np.abs(self.coordinates).max()  # of a rounded point, in each coordinate
        bound = 4 * slack * (np.abs(a).sum(axis=1) + np.abs(b).sum(axis=1) + slack)
        signs = np.sign(determinant).astype(np.int8)
        undecided = np.flatnonzero(np.abs(determinant) <= bound)
        if len(undecided):
            signs[undecided] = self._by_ends(i[undecided], j[undecided], k[undecided])
        return signs

    def _by_ends(self, i: Indices, j: Indices, k: Indices) -> Signs:
        """Decide from the turns of the chords' ends: a determinant is a positive mean of theirs."""
        ends = [(self.start[p], self.end[p]) for p in (i, j, k)]
        chosen = np.stack([np.stack(corners) for corners in product(*ends)], axis=1)
        turns = self._decided(*chosen.reshape(3, -1)).reshape(8, -1)  # an end may be rounded, too
        low, high = turns.min(axis=0), turns.max(axis=0)
        signs: Signs = np.where(low >= 0, high, low)
        for p in np.flatnonzero((low < 0) & (high > 0)):
            signs[p] = self._by_integers(int(i[p]), int(j[p]), int(k[p]))
        return signs

    def _by_integers(self, i: int, j: int, k: int) -> int:
        places = [self._place(p) for p in (i, j, k)]
        finest = max(place.exponent for place in places)
        (ax, ay), (bx, by), (cx, cy) = (place.scaled(finest) for place in places)
        determinant = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)
        return (determinant > 0) - (determinant < 0)

    def _place(self, i: int) -> "_Place":
        if i not in self.places:
            if self.start[i] == self.end[i]:
                x, y, exponent = _dyadic(self.coordinates[i].tolist())
                self.places[i] = _Place(x, y, exponent)
            else:
                ends = self._place(int(self.start[i])), self._place(int(self.end[i]))
                self.places[i] = ends[0].towards(ends[1], float(self.share[i]))
        return self.places[i]


class _Place(NamedTuple):
    """An exact place: integers x and y over 2 to the exponent."""

    x: int
    y: int
    exponent: int

    def scaled(self, exponent: int) -> tuple[int, int]:
        """Give the numerators over a finer power of two."""
        return self.x << exponent - self.exponent, self.y << exponent - self.exponent

    def towards(self, other: "_Place", share: float) -> "_Place":
        """Give the place at a share of the way to another."""
        part, bits = _dyadic([share])
        whole, finest = 1 << bits, max(self.exponent, other.exponent)
        (ax, ay), (bx, by) = self.scaled(finest), other.scaled(finest)
        x, y = ax * (whole - part) + bx * part, ay * (whole - part) + by * part
        return _Place(x, y, finest + bits)


def _dyadic(numbers: list[float]) -> list[int]:
    """Give floats as integers over one power of two, and behind them its exponent."""
    ratios = [number.as_integer_ratio() for number in numbers]
    exponent = max(denominator.bit_length() - 1 for _, denominator in ratios)
    return [*(n << exponent - d.bit_length() + 1 for n, d in ratios), exponent]


def doubtful_area(points: Floats) -> float:
    """Give how large doubled areas of triangles of points must be for rounding not to turn their sign."""
    slack = 2 * ROUNDING * float(np.abs(points).max())  # of two coordinates together
    return 8 * slack * float(np.hypot(*np.ptp(points, axis=0)))


def points_of(vertices: Floats, starts: tuple[int, ...] = (0,)) -> Points:
    """Give the vertices of a ring, or of rings from these rows on, as exact points, straight runs found."""
    if len(starts) == 1:
        return _points_of(vertices)
    rings = [_points_of(ring) for ring in np.split(vertices, starts[1:])]
    return Points(
        vertices,
        np.concatenate([ring.start + first for ring, first in zip(rings, starts, strict=True)]),
        np.concatenate([ring.end + first for ring, first in zip(rings, starts, strict=True)]),
        np.concatenate([ring.share for ring in rings]),
    )


def _points_of(ring: Floats) -> Points:
    n = len(ring)
    own = np.arange(n)
    points = Points(ring, own.copy(), own.copy(), np.zeros(n))
    slack = ROUNDING * float(np.abs(ring).max())
    corner = ~_near_chord(np.roll(ring, 1, axis=0), ring, np.roll(ring, -1, axis=0), 2 * slack)
    corner[[np.lexsort(ring.T)[0], np.lexsort(ring.T)[-1]]] = True  # hull vertices: every run ends somewhere
    ends = np.flatnonzero(corner)
    after = np.append(ends[1:], ends[0] + n)
    for run in np.flatnonzero(after - ends > 1).tolist():
        _straighten(points, int(ends[run]), int(after[run]), slack)
    return points


def _straighten(points: Points, first: int, last: int, slack: float) -> None:
    """Set the rounded vertices between two corners, splitting the run where it leaves its chord."""
    ring = points.coordinates
    n = len(ring)
    runs = [(first, last)]
    while runs:
        first, last = runs.pop()
        if last - first < 2:
            continue
        inner = np.arange(first + 1, last) % n
        a, b = ring[first % n], ring[last % n]
        share = ((ring[inner] - a) @ (b - a)) / ((b - a) @ (b - a))
        ways = np.concatenate([[0.0], share, [1.0]])
        if _near_chord(a, ring[inner], b, slack).all() and (np.diff(ways) > 0).all():
            off = orientation(a, ring[inner], b) != 0  # the others are where their coordinates say
            points.start[inner[off]], points.end[inner[off]] = first % n, last % n
            points.share[inner[off]] = share[off]
        else:
            split = first + 1 + int(_distance(a, ring[inner], b).argmax())
            runs += [(first, split), (split, last)]


def _near_chord(a: Floats, v: Floats, b: Floats, slack: float) -> Flags:
    near: Flags = _distance(a, v, b) <= slack
    return near


def _distance(a: Floats, v: Floats, b: Floats) -> Floats:
    """Give the distances of points v from the segments ab."""
    chord = b - a
    squared = (chord**2).sum(axis=-1)
    share = ((v - a) * chord).sum(axis=-1) / np.where(squared > 0, squared, 1.0)
    foot = a + np.clip(share, 0.0, 1.0)[..., None] * chord
    distance: Floats = np.hypot(*(v - foot).T)
    return distance
