"""Who sees whom: all pairs at once, by expansion through the triangles of a triangulation.

A window is an edge of a triangle through which a viewer looks, together with the two vertices that limit the
view to the right and to the left. Every window looks into the triangle behind it, may see its apex, and goes
on through one or both of its far edges. All windows of all viewers advance together, so that the work, which
grows with the number of visible pairs, is done in few array operations.

Two relations are kept apart: `sees`, where the closed segment lies in the closed polygon, and `diagonal`,
where the open segment lies in the open interior. They differ where views graze vertices or run along straight
edges.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from starskel.points import Indices, Points
from starskel.predicates import Floats
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
        The open segment lies in the open interior.
    """

    sees: Relation
    diagonal: Relation


@dataclass(frozen=True, eq=False)
class _Windows:
    """Views of viewers through half-edges, each between a right and a left limit (all arrays of int)."""

    viewer: Indices
    edge: Indices
    right: Indices
    left: Indices

    def keep(self, chosen: Relation) -> "_Windows":
        return _Windows(self.viewer[chosen], self.edge[chosen], self.right[chosen], self.left[chosen])


def visibility(ground: Triangulation) -> Visibility:
    """Tell for all pairs of a ring's vertices whether they see each other, in O(visible pairs) entries."""
    n = len(ground.points.coordinates)
    viewers = ground.triangles.ravel()
    edges = np.arange(len(viewers))
    opposite = edges - edges % 3 + (edges + 1) % 3
    first = _open(ground, viewers, opposite)
    seen = Visibility(np.eye(n, dtype=bool), np.zeros((n, n), dtype=bool))
    for limit in (first.right, first.left):
        seen.sees[first.viewer, limit] = True
        seen.diagonal[first.viewer, limit] = True
    ring = np.arange(n)
    for step in (1, -1):  # edges of the ring are no diagonals
        seen.diagonal[ring, (ring + step) % n] = False
    _expand(ground.points, ground, first, seen, ring)
    return seen


def visibility_from(ground: Triangulation, places: Floats) -> Visibility:
    """Tell which vertices of a ring are seen from (k, 2) places that are no vertices; from outside none."""
    n, k = len(ground.points.coordinates), len(places)
    points = ground.points.with_free(places)
    seen = Visibility(np.zeros((k, n), dtype=bool), np.zeros((k, n), dtype=bool))
    viewers, triangles, ahead = _locate(points, ground, n + np.arange(k))
    for corner in ground.triangles[triangles].T:
        seen.sees[viewers - n, corner] = True
        seen.diagonal[viewers - n, corner] = True
    inside = np.repeat(viewers, 3)[ahead.ravel()]
    edges = (3 * triangles[:, None] + np.arange(3))[ahead]
    rows = np.concatenate([np.zeros(n, dtype=np.intp), np.arange(k)])
    _expand(points, ground, _open(ground, inside, edges), seen, rows)
    return seen


def _locate(points: Points, ground: Triangulation, viewers: Indices) -> tuple[Indices, Indices, Relation]:
    """Find the closed triangles round each viewer, and which of their edges lie ahead of it."""
    a = ground.triangles
    b = np.roll(a, -1, axis=1)
    turns = points.orientation(viewers[:, None, None], a[None], b[None])
    at, triangles = np.nonzero((turns >= 0).all(axis=2))
    return viewers[at], triangles, turns[at, triangles] > 0


def _open(ground: Triangulation, viewers: Indices, edges: Indices) -> _Windows:
    starts = ground.triangles.ravel()[edges]
    ends = np.roll(ground.triangles, -1, axis=1).ravel()[edges]
    return _Windows(viewers, edges, starts, ends)


def _expand(
    points: Points, ground: Triangulation, windows: _Windows, seen: Visibility, rows: Indices
) -> None:
    """Advance windows until all have met the ring; `rows` gives each viewer's row in what is seen."""
    corners = ground.triangles.ravel()
    while len(windows.viewer):
        behind = ground.twins[windows.edge]
        windows, behind = windows.keep(behind >= 0), behind[behind >= 0]
        after = behind - behind % 3 + (behind + 1) % 3  # from the window's right end to the apex
        last = behind - behind % 3 + (behind + 2) % 3  # from the apex to its left end
        apex = corners[last]
        from_right = points.orientation(windows.viewer, windows.right, apex)
        from_left = points.orientation(windows.viewer, apex, windows.left)
        row = rows[windows.viewer]
        within = (from_right >= 0) & (from_left >= 0)
        seen.sees[row[within], apex[within]] = True
        strictly = (from_right > 0) & (from_left > 0)
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
