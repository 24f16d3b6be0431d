"""Convex cells, many at a time, and what is left of them to the left of a line each."""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from starskel.arrays import Complex, Floats, Indices
from starskel.rings import ranges

Entry = TypeVar("Entry", bound=np.generic)


@dataclass(frozen=True, eq=False)
class Convex:
    """Convex cells, one after the other.

    Attributes
    ----------
    corners : (h,) complex array
        Counter-clockwise.
    size : (k,) array of int
        How many corners each cell has, 0 where nothing is left of it.
    """

    corners: Complex
    size: Indices

    @property
    def _ends(self) -> tuple[Indices, Indices, Indices]:
        """The first and last corners of the cells of which something is left, and which cells these are."""
        (some,) = self.size.nonzero()  # methods: functions cost more than what they do to so few numbers
        size = self.size[some]
        last = size.cumsum() - 1
        return last - size + 1, last, some

    def chosen(self, cells: Indices) -> "Convex":
        """Give some of the cells, some perhaps several times."""
        _, corner = ranges((np.cumsum(self.size) - self.size)[cells], self.size[cells])
        return Convex(self.corners[corner], self.size[cells])

    def left_of(self, start: Complex, end: Complex) -> "Convex":
        """Keep the part of each cell to the left of its line; nothing stays where that has no area."""
        off = self.corners - start.repeat(self.size)
        side: Floats = ((end - start).conj().repeat(self.size) * off).imag
        kept = side >= 0
        if kept.all():
            return self
        first, last, some = self._ends
        following = np.arange(1, len(side) + 1)
        following[last] = first
        (crossing,) = (side * side[following] < 0).nonzero()
        ahead = following[crossing]
        share = side[crossing] / (side[crossing] - side[ahead])
        met = self.corners[crossing] + share * (self.corners[ahead] - self.corners[crossing])
        kept &= (np.maximum.reduceat(side, first) > 0).repeat(self.size[some])
        count = kept.astype(np.intp)
        count[crossing] += 1
        place = count.cumsum() - count
        corners = np.empty(int(count.sum()), dtype=np.complex128)
        corners[place[kept]] = self.corners[kept]
        corners[place[crossing] + kept[crossing]] = met
        size = np.zeros_like(self.size)
        size[some] = np.add.reduceat(count, first)
        return Convex(corners, size)

    def measured(self) -> tuple[Complex, Floats]:
        """Give the (k,) centroids and areas of the cells, 0 for those of which nothing is left."""
        first, last, some = self._ends
        centroids, areas = np.zeros(len(self.size), dtype=np.complex128), np.zeros(len(self.size))
        if len(some):
            base = self.corners[first]
            a = self.corners - base.repeat(self.size[some])
            b = _next(a, first, last)
            doubled = (a.conj() * b).imag
            area = np.add.reduceat(doubled, first) / 2
            weighted = np.add.reduceat(doubled * (a + b), first)
            offset = np.divide(weighted, 6 * area, out=np.zeros_like(weighted), where=area > 0)
            centroids[some], areas[some] = base + offset, np.maximum(area, 0.0)
        return centroids, areas


def boxes(places: Complex, first: Indices) -> Convex:
    """Give the boxes round places that follow each other, those of each box from a first one on."""
    if not len(first):
        return Convex(np.empty(0, dtype=np.complex128), np.empty(0, dtype=np.intp))
    left, right = np.minimum.reduceat(places.real, first), np.maximum.reduceat(places.real, first)
    low, high = np.minimum.reduceat(places.imag, first), np.maximum.reduceat(places.imag, first)
    corners = np.stack([left, low, right, low, right, high, left, high], axis=1).ravel()
    return Convex(corners.view(np.complex128), np.full(len(first), 4))


def _next(entries: NDArray[Entry], first: Indices, last: Indices) -> NDArray[Entry]:
    """Give for each entry the next one of its cell, for the last one the first."""
    following = np.empty_like(entries)
    following[:-1] = entries[1:]
    following[last] = entries[first]
    return following
