"""What lies to the left of many lines, for many cells at a time.

A line bounds its cell along one stretch at most: what all the other lines leave of it. The stretches are
found from all pairs of lines at once, in a few array operations however many lines there are; their ends are
the corners of the cell. Where lines lie on top of each other each has a part of the stretch, or the whole:
that makes no other corners.

Corners that are `NEAR` to each other, in distances from the middle, are one. Of a cell that is too small by
no more than this share of a way something is left, without area: it may be a point.

Cells of many lines are thinned first: a line that bounds nothing among some of the others bounds nothing.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Flags, Floats, Indices
from starskel.decomposition.kernels.clipping import Convex
from starskel.predicates import NEAR
from starskel.rings import Rings
from starskel.task import UNWATCHED, Task

WIDE = 32
"""Cells of more lines are thinned, in groups of so many."""

ALIKE = 0.6
"""Cells are worked on in one array with others of that share of the lines at least: rows are filled up."""

FEW = 1 << 12
"""Cells with so few pairs of lines are worked on in one array, alike or not."""

PAIRS = 1 << 16
"""Pairs of lines that are looked at between two questions whether to stop."""


@dataclass(frozen=True, eq=False)
class Lines:
    """Directed lines, those of each cell one after the other.

    Attributes
    ----------
    start, way : (h,) complex arrays
        A point of each line, and the way from there to another one.
    counts : (k,) array of int
        How many lines each cell has.
    """

    start: Complex
    way: Complex
    counts: Indices

    @classmethod
    def round(cls, rings: Rings, at: Complex) -> "Lines":
        """Give the edges of rings of points that lie at (m,) places."""
        start = at[rings.rows]
        return cls(start, start[rings.following] - start, rings.counts)

    @property
    def owner(self) -> Indices:
        """The (h,) cells that the lines belong to."""
        return np.repeat(np.arange(len(self.counts)), self.counts)

    def chosen(self, some: Flags | Indices) -> "Lines":
        """Give some of the lines, those of each cell still one after the other."""
        counts = np.bincount(self.owner[some], minlength=len(self.counts))
        return Lines(self.start[some], self.way[some], counts)


def left_of_all(lines: Lines, task: Task = UNWATCHED) -> Convex:
    """Give for each cell what lies to the left of all its lines, nothing where that has no bounds.

    Lines without length bound nothing.
    """
    lines = _thinned(lines, task)
    low, high = _stretches(lines, task)
    some = np.flatnonzero((low < high + NEAR) & np.isfinite(low) & np.isfinite(high))
    bounds = lines.chosen(some)
    ends = np.concatenate([bounds.start + share * bounds.way for share in (low[some], high[some])])
    return _hulls(ends, np.tile(bounds.owner, 2), len(lines.counts))


def _hulls(corners: Complex, owner: Indices, count: int) -> Convex:
    """Put the corners of cells in order round the middle of each; those that all but coincide are one."""
    size = np.bincount(owner, minlength=count)
    middle = np.bincount(owner, corners.real, count) + 1j * np.bincount(owner, corners.imag, count)
    off = corners - (middle / np.maximum(size, 1))[owner]
    turn = np.rint(np.angle(off) * (2.0**30 / np.pi)).astype(np.int64)
    order = np.argsort((owner << 32) + turn, kind="stable")  # by one key, exact whatever cells there are
    corners, owner = corners[order], owner[order]
    following = corners[Rings(order, size[size > 0]).following]
    apart = np.abs(following - corners) >= NEAR * np.abs(off[order])
    return Convex(corners[apart], np.bincount(owner[apart], minlength=count))


def _thinned(lines: Lines, task: Task) -> Lines:
    """Leave out lines that bound nothing in cells of many, and all lines of those that are seen to be empty.

    Lines in one direction leave each other alone here: of two on top of each other rounding might leave none.
    """
    while lines.counts.max(initial=0) > WIDE:
        groups = -(-lines.counts // WIDE)
        cell = np.repeat(np.arange(len(groups)), groups)
        counts = np.full(len(cell), WIDE)
        counts[(np.cumsum(groups) - 1)[groups > 0]] -= (WIDE * groups - lines.counts)[groups > 0]
        low, high = _stretches(Lines(lines.start, lines.way, counts), task, apart=NEAR)
        bounds = low < high + NEAR
        left = np.logical_or.reduceat(bounds, np.cumsum(counts) - counts)
        bounds &= np.bincount(cell[~left], minlength=len(groups))[lines.owner] == 0
        bounds |= groups[lines.owner] == 1  # so that a cell does not depend on others
        if bounds.all():
            break
        lines = lines.chosen(bounds)
    return lines


def _stretches(lines: Lines, task: Task, apart: float = 0.0) -> tuple[Floats, Floats]:
    """Give where on each line, as shares of its way, the stretch begins and ends that the others leave.

    Lines leave each other alone whose directions differ by less than a sine.
    """
    low, high = np.empty(len(lines.way)), np.empty(len(lines.way))
    first = np.cumsum(lines.counts) - lines.counts
    for cells in _alike(lines.counts):
        counts = lines.counts[cells]
        place = np.arange(counts[0])[:, None]
        filled = place < counts
        line = np.where(filled, first[cells] + place, 0)
        start, way = lines.start[line] - lines.start[first[cells]], np.where(filled, lines.way[line], 0)
        step = max(1, PAIRS // line.size)
        for some in (slice(k, k + step) for k in range(0, len(line), step)):
            task.reach(0)
            found, kept = _stretch(start, way, some, apart), filled[some]
            low[line[some][kept]], high[line[some][kept]] = (part[kept] for part in found)
    return low, high


def _alike(counts: Indices) -> Iterator[Indices]:
    """Give the cells that have lines, those of many first, together with others that are alike."""
    cells = np.argsort(-counts, kind="stable")
    fewer = -counts[cells]
    at, end = 0, int(np.count_nonzero(fewer))
    while at < end:
        most = -int(fewer[at])
        alike = int(np.searchsorted(fewer, -ALIKE * most, "right")) - at
        count = max(1, min(max(alike, FEW // most**2), PAIRS // most**2))
        yield cells[at : min(at + count, end)]
        at += count


def _stretch(start: Complex, way: Complex, some: slice, apart: float) -> tuple[Floats, Floats]:
    """Give the stretches of some lines, each a place in a column, that all lines of the column leave.

    What fills a column up has no length and leaves all. Signs choose through infinities: masks take longer.
    """
    x, y = way.real[:, None], way.imag[:, None]
    turn = x * way.imag[some] - y * way.real[some] + 0.0  # no negative zeros
    right = y * start.real[some] - x * start.imag[some] - (y * start.real[:, None] - x * start.imag[:, None])
    own = np.arange(len(way))[some]
    turn[own, own - own[0]], right[own, own - own[0]] = 0.0, -1.0
    if apart:
        alone = np.abs(turn) < apart * np.abs(way)[:, None] * np.abs(way[some])
        turn[alone], right[alone] = 0.0, -1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        share, side = right / turn, turn * np.inf  # no number where lines are parallel
        low = np.fmax.reduce(np.fmin(share, side), axis=0, initial=-np.inf)
        high = np.fmin.reduce(np.maximum(share, side), axis=0, initial=np.inf)
    return low, high
