"""Paths between two vertices inside a polygon: few links, and a wide berth of everything.

Bends may be the middles of triangles and of the diagonals between them. With these places as vertices the
triangulation is refined, and expansion through it tells which of them see each other. Level by level, as in
every graph, the paths with fewest links are found; the one among them that keeps farthest away from the
polygon is taken. So no bend sees another one but those next to it, and neither does a vertex at the ends.
"""

from dataclasses import dataclass

import numpy as np

from starskel.points import Indices, Points
from starskel.predicates import ROUNDING, Floats
from starskel.task import Task
from starskel.triangulation import Triangulation, triangulate
from starskel.visibility import visibility


@dataclass(frozen=True, eq=False)
class _Ways:
    """Between which places a path may run straight on.

    Attributes
    ----------
    at : (m, 2) array
        The start, the end, and all places where there may be bends.
    room : (m,) array
        The distance of each from the polygon; infinite for start and end.
    berth : (m, m) array
        The least distance from the polygon on the way between two; 0 where they do not see each other.
    """

    at: Floats
    room: Floats
    berth: Floats


def bends_between(points: Points, ring: Indices, start: int, end: int, task: Task) -> Floats | None:
    """Give the bends of a path with few links between two vertices of a simple ring.

    Parameters
    ----------
    points : Points
    ring : (n,) array of int
        The rows of the ring's vertices among the points, counter-clockwise.
    start, end : int
        Places in the ring, not next to each other.
    task : Task

    Returns
    -------
    (k, 2) array, or None where the ring is too narrow for floats to name a path.
    """
    ground = triangulate(points, ring)
    refined = _refine(ground)
    if refined is None:
        return None
    ways = _ways(ground, refined, [start, end], task)
    bends = _widest(ways, ROUNDING * float(np.abs(ground.vertices).max()))
    return None if bends is None else ways.at[bends]


def _refine(ground: Triangulation) -> Triangulation | None:
    """Cut each triangle into a fan round its middle; None where one is too thin for that."""
    n, count = len(ground.ring), len(ground.triangles)
    diagonals = _diagonals(ground)
    vertices = ground.vertices
    middles = [vertices[ground.triangles].mean(axis=1), vertices[diagonals].mean(axis=1)]
    points = ground.points.with_free(np.concatenate(middles))
    ring = np.concatenate([ground.ring, np.arange(len(ground.points.start), len(points.start))])
    between = {(a, b): at for at, (a, b) in enumerate(diagonals.tolist(), n + count)}
    triangles: list[tuple[int, int, int]] = []
    for centre, (a, b, c) in enumerate(ground.triangles.tolist(), n):
        for u, v in ((a, b), (b, c), (c, a)):
            middle = between.get((min(u, v), max(u, v)))
            triangles += [(u, v, centre)] if middle is None else [(u, middle, centre), (middle, v, centre)]
    refined = np.array(triangles)
    if not (points.orientation(*ring[refined].T) > 0).all():
        return None
    return Triangulation(points, ring, refined, _twins(refined, len(ring)))


def _diagonals(ground: Triangulation) -> Indices:
    a, b = ground.triangles.ravel(), np.roll(ground.triangles, -1, axis=1).ravel()
    inner = (ground.twins >= 0) & (a < b)
    return np.stack([a[inner], b[inner]], axis=1)


def _twins(triangles: Indices, n: int) -> Indices:
    a, b = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    order = np.argsort(a * n + b)
    found = np.searchsorted(a * n + b, b * n + a, sorter=order)
    twin = order[np.minimum(found, len(order) - 1)]
    return np.where((a[twin] == b) & (b[twin] == a), twin, -1)


def _ways(ground: Triangulation, refined: Triangulation, ends: list[int], task: Task) -> _Ways:
    rows = np.array([*ends, *range(len(ground.ring), len(refined.ring))])
    at, vertices = refined.vertices[rows], ground.vertices
    room = np.full(len(rows), np.inf)
    for edge in zip(vertices, np.roll(vertices, -1, axis=0), strict=True):
        room[2:] = np.minimum(room[2:], _distance(at[2:], *edge))
    sees = visibility(refined, task).sees[np.ix_(rows, rows)]
    first, second = np.nonzero(np.triu(sees, 1))
    berth = np.zeros(sees.shape)
    berth[first, second] = _berths(at[first], at[second], vertices[_reflex(ground, ends)], task)
    return _Ways(at, room, np.maximum(berth, berth.T))


def _reflex(ground: Triangulation, ends: list[int]) -> Indices:
    """Give the reflex vertices without the ends: nothing else comes nearest to an inner segment's middle."""
    ring = ground.ring
    turns = ground.points.orientation(np.roll(ring, 1), ring, np.roll(ring, -1))
    return np.setdiff1d(np.flatnonzero(turns < 0), ends)


def _berths(a: Floats, b: Floats, corners: Floats, task: Task) -> Floats:
    """Give the distance of each segment ab from the nearest corner."""
    berths = np.full(len(a), np.inf)
    for corner in corners:
        task.reach(0)
        np.minimum(berths, _distance(corner, a, b), out=berths)
    return berths


def _distance(places: Floats, a: Floats, b: Floats) -> Floats:
    """Give the distances of places from segments ab; the shapes broadcast."""
    way = b - a
    share = ((places - a) * way).sum(axis=-1) / (way * way).sum(axis=-1)
    off = a + np.clip(share, 0, 1)[..., None] * way - places
    distance: Floats = np.hypot(off[..., 0], off[..., 1])
    return distance


def _widest(ways: _Ways, slack: float) -> list[int] | None:
    """Give the bends on the widest of the paths with fewest links from place 0 to place 1."""
    width = np.zeros(len(ways.at))
    before = np.zeros(len(ways.at), dtype=np.intp)
    width[0] = np.inf
    front = np.array([0])
    while len(front) and not width[1]:
        reach = np.minimum(width[front, None], ways.berth[front])
        best = np.minimum(reach.max(axis=0), ways.room)
        found = np.flatnonzero((best > slack) & (width == 0))
        width[found] = best[found]
        before[found] = front[reach[:, found].argmax(axis=0)]
        front = found
    if not width[1]:
        return None
    bends = [int(before[1])]
    while bends[-1]:
        bends.append(int(before[bends[-1]]))
    return bends[-2::-1]
