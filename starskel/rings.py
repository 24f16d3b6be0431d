"""Rings that are worked on together, so that array operations are few and long."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, pairwise

import numpy as np

from starskel.arrays import Indices


@dataclass(frozen=True, eq=False)
class Rings:
    """Rings of vertices, one after the other; in what follows vertices count through all of them.

    Attributes
    ----------
    rows : (h,) array of int
        The rows of all vertices among some points, ring by ring.
    counts : (k,) array of int
        How many vertices each ring has.
    """

    rows: Indices
    counts: Indices

    @classmethod
    def of(cls, rings: Iterable[Sequence[int] | Indices]) -> "Rings":
        """Put rings one after the other."""
        rings = list(rings)
        counts = np.array([len(ring) for ring in rings], dtype=np.intp)
        return cls(np.fromiter(chain.from_iterable(rings), dtype=np.intp, count=int(counts.sum())), counts)

    @cached_property
    def first(self) -> Indices:
        """The (k,) first vertices."""
        first: Indices = np.cumsum(self.counts) - self.counts
        return first

    @cached_property
    def last(self) -> Indices:
        """The (k,) last vertices."""
        last: Indices = np.cumsum(self.counts) - 1
        return last

    @cached_property
    def owner(self) -> Indices:
        """The (h,) rings that the vertices belong to."""
        return np.repeat(np.arange(len(self.counts)), self.counts)

    @cached_property
    def following(self) -> Indices:
        """The (h,) vertices next to each, counter-clockwise."""
        following = np.arange(1, len(self.rows) + 1)
        following[self.last] = self.first
        return following

    @cached_property
    def preceding(self) -> Indices:
        """The (h,) vertices next to each, clockwise."""
        preceding = np.arange(-1, len(self.rows) - 1)
        preceding[self.first] = self.last
        return preceding

    def parts(self) -> list[tuple[Indices, int]]:
        """Give the rows of each ring, and its first vertex."""
        return [(self.rows[a : b + 1], int(a)) for a, b in zip(self.first, self.last, strict=True)]


def ranges(first: Indices, counts: Indices) -> tuple[Indices, Indices]:
    """Count up from some numbers, so many steps from each; give for each step whose it is, and the number."""
    owner = np.arange(len(first)).repeat(counts)
    done: Indices = counts.cumsum()
    return owner, np.arange(len(owner)) + (first - (done - counts)).take(owner)


def blocks(counts: Indices, most: int) -> list[slice]:
    """Cut things, each of so many parts, into blocks of not many more than so many parts."""
    if not len(counts):
        return []
    done = counts.cumsum()
    if done[-1] < most:
        return [slice(0, len(counts))]
    block = done // most
    ends = [0, *(np.flatnonzero(np.diff(block)) + 1).tolist(), len(counts)]
    return [slice(a, b) for a, b in pairwise(ends)]
