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
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from starskel.points import Indices, Points
from starskel.predicates import ROUNDING, Floats, Signs
from starskel.triangulation import Triangulation

Relation = NDArray[np.bool_]


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

    def open(self, windows: "_Windows", viewers: "_Viewers") -> None:
        """Note what viewers see of their own triangle: both ends of the edge opposite."""
        for end, other in ((windows.right, windows.left), (windows.left, windows.right)):
            self.sees[windows.viewer, end] = True
            clear = viewers.clear(windows.viewer, end, other)
            self.diagonal[windows.viewer[~clear], end[~clear]] = False


@dataclass(frozen=True, eq=False)
class _Windows:
    """Views of viewers through half-edges, each between a right and a left limit (all arrays of int)."""

    viewer: Indices
    edge: Indices
    right: Indices
    left: Indices

    def keep(self, chosen: Relation) -> "_Windows":
        return _Windows(self.viewer[chosen], self.edge[chosen], self.right[chosen], self.left[chosen])


@dataclass(frozen=True, eq=False)
class _Viewers:
    """Where the viewers and the vertices of the ring stand among the points."""

    points: Points
    ring: Indices
    rows: Indices

    @cached_property
    def slack(self) -> float:
        """What two coordinates may be off by rounding, together."""
        return 2 * ROUNDING * float(np.abs(self.points.coordinates[self.ring]).max())

    def turn(self, viewer: Indices, first: Indices, second: Indices) -> Signs:
        """Tell whether a viewer turns left (1) or right (-1) to look from one vertex to another."""
        return self.points.orientation(self.rows[viewer], self.ring[first], self.ring[second])

    def clear(self, viewer: Indices, seen: Indices, passed: Indices) -> Relation:
        """Tell whether the line from a viewer to the vertex seen passes another one by more than rounding."""
        places = self.points.coordinates
        line = places[self.ring[seen]] - places[self.rows[viewer]]
        beside = places[self.ring[passed]] - places[self.rows[viewer]]
        doubled = np.abs(line[:, 0] * beside[:, 1] - line[:, 1] * beside[:, 0])
        clear: Relation = doubled > self.slack * np.hypot(*line.T)
        return clear


def visibility(ground: Triangulation) -> Visibility:
    """Tell for all pairs of a ring's vertices whether they see each other, in O(visible pairs) entries."""
    n = len(ground.ring)
    viewers = ground.triangles.ravel()
    edges = np.arange(len(viewers))
    opposite = edges - edges % 3 + (edges + 1) % 3
    first = _open(ground, viewers, opposite)
    seen = Visibility(np.eye(n, dtype=bool), np.zeros((n, n), dtype=bool))
    seen.diagonal[first.viewer, first.right] = True
    seen.diagonal[first.viewer, first.left] = True
    _expand(ground, _Viewers(ground.points, ground.ring, ground.ring), first, seen)
    ring = np.arange(n)
    for step in (1, -1):  # edges of the ring are no diagonals
        seen.diagonal[ring, (ring + step) % n] = False
    return Visibility(seen.sees, seen.diagonal & seen.diagonal.T)


def visibility_from(ground: Triangulation, places: Floats) -> Visibility:
    """Tell which vertices of a ring are seen from (k, 2) places that are no vertices; from outside none."""
    n, k = len(ground.ring), len(places)
    seen = Visibility(np.zeros((k, n), dtype=bool), np.zeros((k, n), dtype=bool))
    free = len(ground.points.coordinates) + np.arange(k)
    viewers = _Viewers(ground.points.with_free(places), ground.ring, free)
    at, triangles, ahead = _locate(ground, viewers)
    for corner in ground.triangles[triangles].T:
        seen.diagonal[at, corner] = True
    edges = (3 * triangles[:, None] + np.arange(3))[ahead]
    _expand(ground, viewers, _open(ground, np.repeat(at, 3)[ahead.ravel()], edges), seen)
    return seen


def _locate(ground: Triangulation, viewers: _Viewers) -> tuple[Indices, Indices, Relation]:
    """Find the closed triangles round each viewer, and which of their edges lie ahead of it."""
    a = ground.ring[ground.triangles]
    b = np.roll(a, -1, axis=1)
    turns = viewers.points.orientation(viewers.rows[:, None, None], a[None], b[None])
    at, triangles = np.nonzero((turns >= 0).all(axis=2))
    return at, triangles, turns[at, triangles] > 0


def _open(ground: Triangulation, viewers: Indices, edges: Indices) -> _Windows:
    starts = ground.triangles.ravel()[edges]
    ends = np.roll(ground.triangles, -1, axis=1).ravel()[edges]
    return _Windows(viewers, edges, starts, ends)


def _expand(ground: Triangulation, viewers: _Viewers, windows: _Windows, seen: Visibility) -> None:
    """Advance windows until all have met the ring."""
    seen.open(windows, viewers)
    corners = ground.triangles.ravel()
    while len(windows.viewer):
        behind = ground.twins[windows.edge]
        windows, behind = windows.keep(behind >= 0), behind[behind >= 0]
        after = behind - behind % 3 + (behind + 1) % 3  # from the window's right end to the apex
        last = behind - behind % 3 + (behind + 2) % 3  # from the apex to its left end
        apex = corners[last]
        from_right = viewers.turn(windows.viewer, windows.right, apex)
        from_left = viewers.turn(windows.viewer, apex, windows.left)
        row = windows.viewer
        within = (from_right >= 0) & (from_left >= 0)
        seen.sees[row[within], apex[within]] = True
        strictly = (from_right > 0) & (from_left > 0)
        strictly[strictly] &= viewers.clear(row[strictly], apex[strictly], windows.right[strictly])
        strictly[strictly] &= viewers.clear(row[strictly], apex[strictly], windows.left[strictly])
        seen.diagonal[row[strictly], apex[strictly]] = True
        left = np.where(from_left >= 0, apex, windows.left)
        right = np.where(from_right >= 0, apex, windows.right)
        rightward = _Windows(windows.viewer, after, windows.right, left).keep(from_right >= 0)
        leftward = _Windows(windows.viewer, last, right, windows.left).keep(from_left >= 0)
        windows = _join(rightward, leftward)


def _join(a: _Windows, b: _Windows) -> _Windows:
    return _Windows(
        np.concatenate([a.viewer, b.viewer]),
        np.concatenate([a.edge, b.edge]),
        np.concatenate([a.right, b.right]),
        np.concatenate([a.left, b.left]),
    )
