"""Who sees whom: all pairs at once, by views that expand through the convex cells of a triangulation.

A view looks into a cell through one of its sides, between two vertices that limit it to the right and to the
left. It sees the corners between its limits, and goes on through the sides between them. The views of many
viewers advance together, so that the work, which grows with the corners of the cells that are looked into, is
done in few array operations.

Two relations are kept apart: `sees`, where the closed segment lies in the closed polygon, and `diagonal`,
where the open segment lies in the open interior. They differ where views graze vertices or run along straight
edges. Coordinates are rounded, so a segment that passes a vertex by less than `ROUNDING` is no diagonal.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Flags, Floats, Indices
from starskel.cells import Cells, cells_of
from starskel.points import Points, doubtful_area
from starskel.predicates import ROUNDING
from starskel.rings import blocks, ranges
from starskel.task import UNWATCHED, Task
from starskel.triangulation import Triangulation

BLOCK = 1 << 17
"""Pairs of a viewer and a vertex that are worked on at a time: what fits a processor's cache."""


@dataclass(frozen=True, eq=False)
class Visibility:
    """Which viewers see which vertices.

    Attributes
    ----------
    sees : (k, n) array of bool
        The closed segment lies in the closed polygon.
    diagonal : (k, n) array of bool
        The open segment lies in the open interior, clear of all vertices.
    """

    sees: Flags
    diagonal: Flags


def visibility(ground: Triangulation, task: Task = UNWATCHED) -> Visibility:
    """Tell for all pairs of vertices whether they see each other in their ring.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    ValueError
        If the triangles have corners inside the ring.
    """
    n = len(ground.rings.rows)
    cells = cells_of(ground)
    scene = _Scene.of(ground, cells, ground.points, ground.rings.rows)
    walks = _Walks(cells.corner[cells.first], cells.first + 1, cells.size[cells.first] - 1)
    seen = Visibility(np.eye(n, dtype=bool), np.zeros((n, n), dtype=bool))
    _look(scene, walks, seen, task)
    ring = np.arange(n)
    for beside in (ground.rings.preceding, ground.rings.following):  # edges of the ring are no diagonals
        seen.diagonal[ring, beside] = False
    return Visibility(seen.sees, seen.diagonal & seen.diagonal.T)


def visibility_from(
    ground: Triangulation, places: Floats, triangles: Indices, task: Task = UNWATCHED
) -> Visibility:
    """Tell which vertices of a ring are seen from (k, 2) places, each given with the triangle it lies in.

    From a place that is not strictly inside its triangle nothing is seen.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    ValueError
        If the triangles have corners inside the ring.
    """
    n, k = len(ground.rings.rows), len(places)
    rows = len(ground.points.coordinates) + np.arange(k)
    points = ground.points.with_free(places)
    corners = ground.rings.rows[ground.triangles[triangles]]
    turns = points.orientation(rows[:, None], corners, np.roll(corners, -1, axis=1))
    viewer = np.flatnonzero((turns > 0).all(axis=1))
    cells = cells_of(ground)
    start = cells.of_triangle[triangles[viewer]]
    seen = Visibility(np.zeros((k, n), dtype=bool), np.zeros((k, n), dtype=bool))
    _look(_Scene.of(ground, cells, points, rows), _Walks(viewer, start, cells.size[start]), seen, task)
    return seen


@dataclass(frozen=True, eq=False)
class _Walks:
    """Walks of viewers round their own cells: where they start and how many corners they pass.

    A viewer on a corner passes all others; one inside a cell passes every corner.
    """

    viewer: Indices
    start: Indices
    count: Indices

    def part(self, some: slice) -> "_Walks":
        """Give some of the walks."""
        return _Walks(self.viewer[some], self.start[some], self.count[some])


@dataclass(frozen=True, eq=False)
class _Views:
    """Views of viewers into cells, each between a right and a left limit (all arrays of int).

    A view enters its cell over the side that ends where the walk along all the other sides starts.
    """

    viewer: Indices
    start: Indices
    right: Indices
    left: Indices

    def part(self, some: slice | Indices) -> "_Views":
        """Give some of the views."""
        return _Views(self.viewer[some], self.start[some], self.right[some], self.left[some])


@dataclass(frozen=True, eq=False)
class _Scene:
    """Where the viewers and the ring's vertices are, and the cells between them.

    Attributes
    ----------
    cells : Cells
    points : Points
    ring, rows : (n,) and (k,) arrays of int
        The rows of the vertices and of the viewers.
    vertices, viewers : (n,) and (k,) complex arrays
        Their coordinates.
    slack : float
        What two coordinates may be off by rounding, together.
    doubtful : float
        Up to which doubled area of a triangle rounding might turn its sign.
    """

    cells: Cells
    points: Points
    ring: Indices
    rows: Indices
    vertices: Complex
    viewers: Complex
    slack: float
    doubtful: float

    @classmethod
    def of(cls, ground: Triangulation, cells: Cells, points: Points, rows: Indices) -> "_Scene":
        places = points.coordinates.view(np.complex128)[:, 0]
        slack = 2 * ROUNDING * float(np.abs(ground.vertices).max())
        doubtful = doubtful_area(ground.vertices)
        return cls(
            cells, points, ground.rings.rows, rows, places[ground.rings.rows], places[rows], slack, doubtful
        )

    def turns(
        self, viewer: Indices, first: Indices, second: Indices, doubled: Floats
    ) -> tuple[Floats, Flags]:
        """Tell how viewers turn to look from one vertex to another: left (1), right (-1) or not (0), exactly.

        Tell, too, whether the line to either vertex passes the other by no more than rounding. Doubled are
        the areas of the triangles that the three form, rounded.
        """
        at = self.viewers[viewer]
        reach = self.slack * (np.abs(self.vertices[first] - at) + np.abs(self.vertices[second] - at))
        signs = np.sign(doubled)
        close = np.flatnonzero(np.abs(doubled) <= 4 * reach)
        if len(close):
            rows = self.rows[viewer[close]], self.ring[first[close]], self.ring[second[close]]
            signs[close] = self.points.orientation(*rows)
        return signs, np.abs(doubled) <= reach


def _look(scene: _Scene, walks: _Walks, seen: Visibility, task: Task) -> None:
    """Note what viewers see on walks round their own cells, and in the cells behind these."""
    around = []
    for part in blocks(walks.count, BLOCK):
        task.reach(0)
        around.append(_look_around(scene, walks.part(part), seen))
    for views in around:  # once all are noted: two cells of a viewer share the ends of a side
        _forget_hidden(scene, views, seen)
    waiting = [views.part(np.flatnonzero(views.start >= 0)) for views in around]
    while waiting:
        views = waiting.pop()
        for part in blocks(scene.cells.size[views.start], BLOCK):
            task.reach(0)
            waiting.append(_advance(scene, views.part(part), seen))


def _look_around(scene: _Scene, walks: _Walks, seen: Visibility) -> _Views:
    """Note the corners on the walks, and give the views through all sides but those that end at a viewer."""
    cells, count = scene.cells, walks.count
    walk, place = ranges(walks.start, count)
    viewer = walks.viewer[walk]
    seen.sees[viewer, cells.corner[place]] = True
    seen.diagonal[viewer, cells.corner[place]] = True
    away = np.ones(len(place), dtype=bool)
    away[np.cumsum(count)[count < cells.size[walks.start]] - 1] = False
    viewer, place = viewer[away], place[away]
    return _Views(viewer, cells.behind[place], cells.corner[place], cells.corner[place + 1])


def _forget_hidden(scene: _Scene, views: _Views, seen: Visibility) -> None:
    """Let no diagonal pass the nearer end of a side that is seen edge-on."""
    at = scene.viewers[views.viewer]
    right, left = scene.vertices[views.right] - at, scene.vertices[views.left] - at
    along = np.abs((right.conj() * left).imag) <= scene.slack * (np.abs(right) + np.abs(left))
    farther = np.where(np.abs(right) > np.abs(left), views.right, views.left)[along]
    seen.diagonal[views.viewer[along], farther] = False


def _advance(scene: _Scene, views: _Views, seen: Visibility) -> _Views:
    """Note which corners are seen in the cells that views enter, and give the views onward."""
    cells = scene.cells
    count = cells.size[views.start] - 1
    walk, place = ranges(views.start, count)
    corner = cells.corner.take(place)
    ends = np.cumsum(count)
    left_of_right, right_of_left, grazing = _between(scene, views, walk, corner, ends - count)
    seen_here = np.flatnonzero(left_of_right & right_of_left)
    keys = views.viewer.take(walk.take(seen_here)) * len(scene.ring) + corner.take(seen_here)
    seen.sees.ravel()[keys] = True
    seen.diagonal.ravel()[keys] = True
    seen.diagonal[views.viewer[walk[grazing]], corner[grazing]] = False
    end_left_of_right = _of_next(left_of_right, ends, True)
    end_right_of_left = _of_next(right_of_left, ends, False)
    onward = np.flatnonzero(right_of_left & end_left_of_right)
    onward = onward[cells.behind.take(place.take(onward)) >= 0]
    walk, place = walk[onward], place[onward]
    return _Views(
        views.viewer[walk],
        cells.behind[place],
        np.where(left_of_right[onward], corner[onward], views.right[walk]),
        np.where(end_right_of_left[onward], cells.corner[place + 1], views.left[walk]),
    )


def _of_next(flags: Flags, ends: Indices, last: bool) -> Flags:
    """Give each step of the walks the flag of the next one, and the last ones the same."""
    following = np.empty_like(flags)
    following[:-1] = flags[1:]
    following[ends - 1] = last
    return following


def _between(
    scene: _Scene, views: _Views, walk: Indices, corner: Indices, begun: Indices
) -> tuple[Flags, Flags, Indices]:
    """Tell which corners lie at or left of right limits, at or right of left ones, and which graze either.

    Where walks have begun stand the right ends of the sides that are looked through.
    """
    at = scene.viewers[views.viewer]
    towards = scene.vertices.take(corner)
    towards -= at.take(walk)
    flags, grazing = [], []
    for limit, side in ((views.right, 1.0), (views.left, -1.0)):
        turned = (side * (scene.vertices[limit] - at).conj()).take(walk)
        turned *= towards
        inwards = turned.imag
        inwards[begun] = -side * np.inf
        inside = inwards > scene.doubtful
        if np.count_nonzero(inside) + np.count_nonzero(inwards < -scene.doubtful) < len(walk):
            doubt = np.flatnonzero(np.abs(inwards) <= scene.doubtful)
            view = walk[doubt]
            doubled = side * inwards[doubt]
            signs, grazes = scene.turns(views.viewer[view], limit[view], corner[doubt], doubled)
            inside[doubt] = side * signs >= 0
            grazing.append(doubt[grazes])
        flags.append(inside)
    return flags[0], flags[1], np.concatenate([*grazing, begun[:0]])
