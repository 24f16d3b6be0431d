"""How much of each pixel lies inside outlines: exact areas, so that edges are smooth.

Every edge adds, in the pixels that it crosses, the area to the right of it, and in all further pixels of the
row the height that it spans there (as font rasterisers do): the sums along rows are winding numbers, averaged
over the pixel; a pixel with edges of several overlapping parts counts by the sum of them, 1 at most. Only
pixels at edges are looked at; what lies between two of them in a row is all alike.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Floats, Indices
from starskel.rings import ranges


@dataclass(frozen=True, eq=False)
class Coverage:
    """The share of each pixel of an image that lies inside, and where the edges are.

    Attributes
    ----------
    size : (int, int)
        Width and height of the image.
    pixels : (p,) array of int
        The pixels with an edge in them, counted through all rows, each once.
    shares : (p,) array
        How much of each lies inside, from 0 to 1.
    edges : (p,) array of int
        An edge in each of them: the one of which most lies there.
    places : (p,) array
        Where on that edge the middle of what lies there is, from 0 to 1.
    changes, windings : (q,) arrays
        From which pixels on, counted with one more at the end of each row, which winding numbers hold.
    """

    size: tuple[int, int]
    pixels: Indices
    shares: Floats
    edges: Indices
    places: Floats
    changes: Indices
    windings: Floats

    def inside(self) -> Flags:
        """Tell which pixels, (h w,), lie inside wholly or in part."""
        width, height = self.size
        ends = np.append(self.changes[1:], height * (width + 1))
        runs = np.repeat(np.abs(self.windings) > 0.5, ends - self.changes)
        lead = np.zeros(height * (width + 1) - len(runs), dtype=np.bool_)
        inside = np.concatenate([lead, runs]).reshape(height, width + 1)[:, :width].ravel()
        inside[self.pixels] = self.shares > 0
        return inside


@dataclass(frozen=True, eq=False)
class _Parts:
    """Edges cut at whole numbers.

    Attributes
    ----------
    owners : (p,) array of int
        Which edge each part belongs to.
    cells : (p,) array of int
        Between which whole numbers it lies, counted by the lower; -1 and the size stand for all beyond.
    enter, leave : (p,) arrays
        The shares of the edge between which it lies.
    """

    owners: Indices
    cells: Indices
    enter: Floats
    leave: Floats


def coverage_of(starts: Floats, ends: Floats, size: tuple[int, int]) -> Coverage:
    """Give how much of each pixel lies inside closed rings.

    Inside is what the rings go round, either way: winding numbers other than 0.

    Parameters
    ----------
    starts, ends : (n, 2) arrays
        The edges of all rings, in pixels, right and down.
    size : (int, int)
        Width and height of the image.
    """
    width, height = size
    rows = _cut(starts[:, 1], ends[:, 1], height)
    seen = (rows.cells >= 0) & (rows.cells < height)
    owners, row, enter, leave = rows.owners[seen], rows.cells[seen], rows.enter[seen], rows.leave[seen]
    x, right, down = starts[owners, 0], *(ends - starts)[owners].T
    columns = _cut(x + enter * right, x + leave * right, width)
    own = columns.owners
    span = leave - enter
    lengths = (columns.leave - columns.enter) * span[own]
    places = enter[own] + (columns.enter + columns.leave) / 2 * span[own]
    middles = (x[own] + places * right[own]).clip(0, width)
    cells = columns.cells.clip(0, width)
    behind = (middles - cells).clip(0, 1)
    weights = lengths * down[own]
    pixels = row[own] * (width + 1) + cells
    changes, windings = _sums(pixels, weights, behind)
    inside = np.flatnonzero((columns.cells >= 0) & (columns.cells < width))
    shown = inside[np.lexsort((-lengths[inside] * np.hypot(right, down)[own[inside]], pixels[inside]))]
    shown = shown[np.diff(pixels[shown], prepend=-1) > 0]
    shares = np.minimum(np.abs(windings[np.searchsorted(changes, pixels[shown])]), 1.0)
    edges = owners[own[shown]]
    return Coverage(size, pixels[shown] - row[own[shown]], shares, edges, places[shown], changes, windings)


def _sums(pixels: Indices, weights: Floats, behind: Floats) -> tuple[Indices, Floats]:
    """Give the winding numbers from all places on where they change.

    What is left of an edge in its pixel is left out there, and counts from the next one on.
    """
    places = np.concatenate([pixels, pixels + 1])
    order = np.argsort(places, kind="stable")
    sums = np.cumsum(np.concatenate([weights * (1 - behind), weights * behind])[order])
    last = np.flatnonzero(np.diff(places[order], append=-1))
    return places[order][last], sums[last]


def _cut(starts: Floats, ends: Floats, size: int) -> _Parts:
    """Cut what goes evenly from start to end at the whole numbers from 0 to a size."""
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    first = np.floor(low).clip(-1, size).astype(np.intp)
    last = np.maximum((np.ceil(high) - 1).clip(-1, size).astype(np.intp), first)
    owners, cells = ranges(first, last - first + 1)
    way = high - low
    level = way == 0
    way[level] = 1.0
    below, scale = low[owners], 1 / way[owners]
    one = np.where(cells < 0, 0.0, ((cells - below) * scale).clip(0, 1))
    two = np.where(cells < size, ((cells + 1 - below) * scale).clip(0, 1), 1.0)
    one[level[owners]], two[level[owners]] = 0.0, 1.0
    falling = (starts > ends)[owners]
    return _Parts(owners, cells, np.where(falling, 1 - two, one), np.where(falling, 1 - one, two))
