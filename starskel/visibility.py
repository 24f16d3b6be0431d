"""Who sees whom: all pairs at once, by expansion through the triangles of a triangulation.

A window is an edge of a triangle through which a viewer looks, together with the two vertices that limit the
view to the right and to the left. Every window looks into the triangle behind it, may see its apex, and goes
on through one or both of its far edges. All windows of all viewers advance together, so that the work, which
grows with the number of visible pairs, is done in few array operations.

Two relations are kept apart: `sees`, where the closed segment lies in the closed polygon, and `diagonal`,
where the open segment lies in the open interior. They differ where views graze vertices or run along straight
edges. Coordinates are rounded, so a segment that passes a vertex by less than `ROUNDING` is no diagonal.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from starskel.points import Indices, Points
from starskel.predicates import ROUNDING, Floats, Signs
from starskel.task import UNWATCHED, Task
from starskel.triangulation import Triangulation

Relation = NDArray[np.bool_]
Complex = NDArray[np.complex128]


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

    sees: Relation
    diagonal: Relation


def visibility(ground: Triangulation, task: Task = UNWATCHED) -> Visibility:
    """Tell for all pairs of a ring's vertices whether they see each other, in O(visible pairs) entries.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    n = len(ground.ring)
    scene = _Scene.of(ground, ground.points, ground.ring)
    edges = np.arange(3 * len(ground.triangles))
    opposite = edges - edges % 3 + (edges + 1) % 3
    seen = Visibility(np.eye(n, dtype=bool), np.zeros((n, n), dtype=bool))
    _look(scene, _Windows.at(ground, ground.triangles.ravel(), opposite), seen, task)
    ring = np.arange(n)
    for step in (1, -1):  # edges of the ring are no diagonals
        seen.diagonal[ring, (ring + step) % n] = False
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
    """
    n, k = len(ground.ring), len(places)
    rows = len(ground.points.coordinates) + np.arange(k)
    points = ground.points.with_free(places)
    corners = ground.ring[ground.triangles[triangles]]
    turns = points.orientation(rows[:, None], corners, np.roll(corners, -1, axis=1))
    viewers = np.repeat(np.flatnonzero((turns > 0).all(axis=1)), 3)
    windows = _Windows.at(ground, viewers, 3 * triangles[viewers] + np.arange(len(viewers)) % 3)
    seen = Visibility(np.zeros((k, n), dtype=bool), np.zeros((k, n), dtype=bool))
    _look(_Scene.of(ground, points, rows), windows, seen, task)
    return seen


@dataclass(frozen=True, eq=False)
class _Windows:
    """Views of viewers through half-edges, each between a right and a left limit (all arrays of int)."""

    viewer: Indices
    edge: Indices
    right: Indices
    left: Indices

    @classmethod
    def at(cls, ground: Triangulation, viewer: Indices, edge: Indices) -> "_Windows":
        """Give the windows that half-edges are to viewers in their triangle."""
        starts, ends = ground.triangles.ravel(), np.roll(ground.triangles, -1, axis=1).ravel()
        return cls(viewer, edge, starts[edge], ends[edge])

    def keep(self, chosen: Relation) -> "_Windows":
        """Give some of the windows."""
        return _Windows(self.viewer[chosen], self.edge[chosen], self.right[chosen], self.left[chosen])

    def join(self, other: "_Windows") -> "_Windows":
        """Give these windows and others."""
        return _Windows(
            np.concatenate([self.viewer, other.viewer]),
            np.concatenate([self.edge, other.edge]),
            np.concatenate([self.right, other.right]),
            np.concatenate([self.left, other.left]),
        )


@dataclass(frozen=True, eq=False)
class _Scene:
    """Where the viewers and the ring's vertices are; what lies behind each half-edge.

    Attributes
    ----------
    points : Points
    ring, rows : (n,) and (k,) arrays of int
        The rows of the vertices and of the viewers.
    vertices, viewers : (n,) and (k,) complex arrays
        Their coordinates.
    apex : (h,) array of int
        The corner of the triangle behind each half-edge that is not an end of it; -1 on the ring.
    onward : (h,) arrays of int, two
        The half-edges from that triangle on: to the right and to the left of its apex.
    slack : float
        What two coordinates may be off by rounding, together.
    """

    points: Points
    ring: Indices
    rows: Indices
    vertices: Complex
    viewers: Complex
    apex: Indices
    onward: tuple[Indices, Indices]
    slack: float

    @classmethod
    def of(cls, ground: Triangulation, points: Points, rows: Indices) -> "_Scene":
        twins = ground.twins
        following, last = (twins - twins % 3 + (twins + step) % 3 for step in (1, 2))
        apex = np.where(twins < 0, -1, ground.triangles.ravel()[last])
        places = points.coordinates.view(np.complex128)[:, 0]
        slack = 2 * ROUNDING * float(np.abs(ground.vertices).max())
        vertices, viewers = places[ground.ring], places[rows]
        return cls(points, ground.ring, rows, vertices, viewers, apex, (following, last), slack)

    def turn(self, viewer: Indices, first: Indices, second: Indices) -> tuple[Signs, Relation]:
        """Tell how viewers turn to look from one vertex to another: left (1), right (-1) or not (0).

        Tell, too, whether the line to either vertex passes the other by more than rounding.
        """
        at = self.viewers[viewer]
        a, b = self.vertices[first] - at, self.vertices[second] - at
        doubled = a.real * b.imag - a.imag * b.real
        reach = self.slack * (np.abs(a) + np.abs(b))
        signs = np.sign(doubled).astype(np.int8)
        close = np.flatnonzero(np.abs(doubled) <= 4 * reach)
        if len(close):
            turned = self.points.orientation(
                self.rows[viewer[close]], self.ring[first[close]], self.ring[second[close]]
            )
            signs[close] = turned
        return signs, np.abs(doubled) > reach


def _look(scene: _Scene, windows: _Windows, seen: Visibility, task: Task) -> None:
    """Note what viewers see of their own triangles, then advance windows until all have met the ring."""
    _, clear = scene.turn(windows.viewer, windows.right, windows.left)
    for end in (windows.right, windows.left):
        seen.sees[windows.viewer, end] = True
        seen.diagonal[windows.viewer, end] = True
    for end in (windows.right, windows.left):
        seen.diagonal[windows.viewer[~clear], end[~clear]] = False
    while len(windows.viewer):
        task.reach(0)
        windows = _advance(scene, windows.keep(scene.apex[windows.edge] >= 0), seen)


def _advance(scene: _Scene, windows: _Windows, seen: Visibility) -> _Windows:
    """Note which apexes are seen behind windows, and give the windows onward."""
    viewer, apex = windows.viewer, scene.apex[windows.edge]
    from_right, clear_right = scene.turn(viewer, windows.right, apex)
    from_left, clear_left = scene.turn(viewer, apex, windows.left)
    right_of_left, left_of_right = from_left >= 0, from_right >= 0
    within = right_of_left & left_of_right
    seen.sees[viewer[within], apex[within]] = True
    strictly = within & clear_right & clear_left
    seen.diagonal[viewer[strictly], apex[strictly]] = True
    onward = [edges[windows.edge] for edges in scene.onward]
    left = np.where(right_of_left, apex, windows.left)
    right = np.where(left_of_right, apex, windows.right)
    rightward = _Windows(viewer, onward[0], windows.right, left).keep(left_of_right)
    return rightward.join(_Windows(viewer, onward[1], right, windows.left).keep(right_of_left))
