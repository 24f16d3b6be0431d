"""Views that expand through the convex cells of a triangulation.

A view looks into a cell through one of its sides, between two vertices that limit it to the right and to the
left. It sees the corners between its limits, and goes on through the sides between them. The views of many
viewers advance together, so that the work, which grows with the corners of the cells that are looked into, is
done in few array operations.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Indices
from starskel.rings import blocks, ranges
from starskel.task import Task
from starskel.visibility.cells import Cells
from starskel.visibility.viewers import Viewers

BLOCK = 1 << 17
"""Pairs of a viewer and a vertex that are worked on at a time: what fits a processor's cache."""


@dataclass(frozen=True, eq=False)
class Walks:
    """Walks of viewers round their own cells: where they start and how many corners they pass.

    A viewer on a corner passes all others; one inside a cell passes every corner.
    """

    viewer: Indices
    start: Indices
    count: Indices

    def part(self, some: slice) -> "Walks":
        """Give some of the walks."""
        return Walks(self.viewer[some], self.start[some], self.count[some])


@dataclass(frozen=True, eq=False)
class _Views:
    """Views of viewers into cells, each between limits, two vertices.

    A view enters its cell over the side that ends where the walk along all the other sides starts.

    Attributes
    ----------
    viewer, start : (v,) arrays of int
        Who looks, and where the walk starts.
    limits : (2, v) array of int
        The vertices that limit the view to the right and to the left.
    """

    viewer: Indices
    start: Indices
    limits: Indices

    def part(self, some: slice | Flags) -> "_Views":
        """Give some of the views."""
        return _Views(self.viewer[some], self.start[some], self.limits[:, some])


def look(viewers: Viewers, walks: Walks, task: Task) -> tuple[Flags, Flags]:
    """Tell which vertices viewers see in their own cells and behind these, and to which they have diagonals.

    Both tables have a row for each viewer and a column for each vertex.
    """
    sees = np.zeros((len(viewers.rows), len(viewers.ring)), dtype=bool)
    waiting, grazed = [], []
    for part in blocks(walks.count, BLOCK):
        task.reach(0)
        around = _look_around(viewers, walks.part(part), sees)
        grazed.append(_behind_ends(viewers, around))
        waiting.append(around.part(around.start >= 0))
    while waiting:
        views = waiting.pop()
        for part in blocks(viewers.cells.others.take(views.start), BLOCK):
            task.reach(0)
            onward, passed = _advance(viewers, views.part(part), sees)
            waiting.append(onward)
            grazed.append(passed)
    diagonal = sees.copy()
    for pairs in grazed:
        diagonal.ravel()[pairs] = False
    return sees, diagonal


def _look_around(viewers: Viewers, walks: Walks, sees: Flags) -> _Views:
    """Note the corners on the walks, and give the views through all sides but those that end at a viewer."""
    cells, count = viewers.cells, walks.count
    walk, place = ranges(walks.start, count)
    viewer = walks.viewer.take(walk)
    sees[viewer, cells.corner.take(place)] = True
    away = np.ones(len(place), dtype=bool)
    away[np.cumsum(count)[count == cells.others.take(walks.start)] - 1] = False
    viewer, place = viewer[away], place[away]
    return _Views(viewer, cells.behind.take(place), cells.corner.take([place, place + 1]))


def _behind_ends(viewers: Viewers, views: _Views) -> Indices:
    """Give the pairs that pass the nearer end of a side, which is seen edge-on."""
    sight = viewers.vertices.take(views.limits)
    sight -= viewers.at.take(views.viewer)
    away = np.abs(sight)
    along = np.flatnonzero(np.abs((sight[0].conj() * sight[1]).imag) <= viewers.slack * away.sum(axis=0))
    farther = np.where(away[0] > away[1], views.limits[0], views.limits[1])
    return viewers.pairs(views.viewer.take(along), farther.take(along))


def _advance(viewers: Viewers, views: _Views, sees: Flags) -> tuple[_Views, Indices]:
    """Note which corners are seen in the cells that views enter; give the views onward, and grazing pairs."""
    cells, steps = viewers.cells, _Steps.of(viewers.cells, views)
    inside, grazing = _inside(viewers, views, steps)
    seen = (inside[0] & inside[1]).nonzero()[0]
    sees.ravel()[viewers.pairs(steps.viewer.take(seen), steps.corner.take(seen))] = True
    end_inside = _of_next(inside, steps.last)
    onward = (inside[1] & end_inside[0]).nonzero()[0]
    onward = onward[cells.behind.take(steps.place.take(onward)) >= 0]
    place = steps.place.take(onward)
    limits = np.where(
        [inside[0].take(onward), end_inside[1].take(onward)],
        cells.corner.take([place, place + 1]),
        views.limits.take(steps.view.take(onward), axis=1),
    )
    further = _Views(steps.viewer.take(onward), cells.behind.take(place), limits)
    return further, viewers.pairs(steps.viewer.take(grazing), steps.corner.take(grazing))


@dataclass(frozen=True, eq=False)
class _Steps:
    """The steps of views on their walks, each to a corner from which a side leads on (all arrays of int).

    Attributes
    ----------
    view, viewer : (h,) arrays
        Whose step it is.
    place, corner : (h,) arrays
        Where in the cells the step leads, and which vertex stands there.
    first, last : (v,) arrays
        The first and the last step of each walk. The first leads to the right end of the side that is looked
        through, and from the last the walk leads to its left end.
    """

    view: Indices
    viewer: Indices
    place: Indices
    corner: Indices
    first: Indices
    last: Indices

    @classmethod
    def of(cls, cells: Cells, views: _Views) -> "_Steps":
        count = cells.others.take(views.start)
        view, place = ranges(views.start, count)
        ends = count.cumsum()
        return cls(view, views.viewer.take(view), place, cells.corner.take(place), ends - count, ends - 1)


def _of_next(inside: Flags, last: Indices) -> Flags:
    """Give each step the flags of the next one, and the last ones those of left ends."""
    following = np.empty_like(inside)
    following[:, :-1] = inside[:, 1:]
    following[0, last] = True
    following[1, last] = False
    return following


def _inside(viewers: Viewers, views: _Views, steps: _Steps) -> tuple[Flags, Indices]:
    """Tell which steps lead at or left of right limits, at or right of left ones, and which graze either."""
    sight = viewers.vertices.take(views.limits)
    sight -= viewers.at.take(views.viewer)
    np.conj(sight, out=sight)
    np.negative(sight[1], out=sight[1])
    towards = viewers.vertices.take(steps.corner)
    towards -= viewers.at.take(steps.viewer)
    turned = sight.take(steps.view, axis=1)
    turned *= towards
    inwards = turned.imag
    inwards[0, steps.first] = -np.inf
    inwards[1, steps.first] = np.inf
    inside = inwards > viewers.doubtful
    close = np.abs(inwards) <= viewers.doubtful
    if not close.any():
        return inside, steps.first[:0]
    side, doubt = close.nonzero()
    left = 1 - 2 * side  # 1 if the inside lies to the left, -1 if to the right
    limit, corner = views.limits[side, steps.view[doubt]], steps.corner[doubt]
    signs, grazes = viewers.turns(steps.viewer[doubt], limit, corner, left * inwards[side, doubt])
    inside[side, doubt] = left * signs >= 0
    return inside, doubt[grazes]
