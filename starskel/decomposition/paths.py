"""Paths between two vertices inside a polygon: few links, and a wide berth of everything.

Bends may lie at sampled places: some in each triangle of a triangulation, and in the middle of each diagonal
between triangles. Level by level, as in every graph, the paths over these places with fewest links are found;
the one among them that keeps farthest away from the polygon is taken. So bends and ends see no others of
their path but those next to them.
"""

from dataclasses import dataclass

import numpy as np

from starskel.decomposition.sightlines import Places, sightlines
from starskel.points import Points
from starskel.polygon import crossing_edges, meeting_places
from starskel.predicates import ROUNDING, Floats, Indices, Relation
from starskel.task import Task
from starskel.triangulation import Triangulation, triangulate

WITHIN = np.array([(64, 17, 15), (16, 65, 15), (17, 16, 63)]) / 96
"""Weights of the corners of a triangle for places in it: uneven, to stand in no line by chance."""

MANY = 250
"""Beyond so many vertices there are enough places in the middle of edges: the pairs grow with the square."""


@dataclass(frozen=True, eq=False)
class _Ways:
    """Where a path may run.

    Attributes
    ----------
    at : (m, 2) array
        The start, the end, and all places where there may be bends.
    sees : (m, m) array of bool
        Between which of them it may run straight on.
    room : (m,) array
        The distances of the places from the polygon, infinite for start and end.
    reflex : (r, 2) array
        Its reflex vertices without start and end. A segment inside the polygon comes closest to it at an end
        or there.
    slack : float
        What comes closer than this to the polygon may touch it.
    """

    at: Floats
    sees: Relation
    room: Floats
    reflex: Floats
    slack: float


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

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    vertices = points.coordinates[ring]
    turns = points.orientation(np.roll(ring, 1), ring, np.roll(ring, -1))
    reflex = vertices[np.setdiff1d(np.flatnonzero(turns < 0), [start, end])]
    slack = ROUNDING * float(np.abs(vertices).max())
    straight = _berths(vertices[[start]], vertices[[end]], reflex, task)[0]
    if straight > slack and _is_diagonal(points, ring, start, end):
        return vertices[:0]
    ground = triangulate(points, ring)
    places = _places(ground, [start, end])
    at = places.points.coordinates[places.rows]
    sees = sightlines(ground, places, task)
    sees[[0, 1], [1, 0]] = False
    room = np.concatenate([[np.inf, np.inf], _room(at[2:], vertices)])
    sees[room <= slack] = sees[:, room <= slack] = False
    return _widest(_Ways(at, sees, room, reflex, slack), task)


def _is_diagonal(points: Points, ring: Indices, start: int, end: int) -> bool:
    """Tell whether the open segment between two vertices of a ring runs inside it, clear of all vertices."""
    a, b = ring[[start]], ring[[end]]
    before, after = ring[[start - 1]], ring[[(start + 1) % len(ring)]]
    left_of_next = points.orientation(a, after, b)[0] > 0
    left_of_last = points.orientation(before, a, b)[0] > 0
    reflex = points.orientation(before, a, after)[0] < 0
    if not (left_of_next or left_of_last if reflex else left_of_next and left_of_last):
        return False
    u, v = ring, np.roll(ring, -1)
    others = (u != a) & (u != b) & (v != a) & (v != b)
    u, v = u[others], v[others]
    sides = points.orientation(a, b, u), points.orientation(a, b, v)
    parts = (sides[0] * sides[1] <= 0) & (sides[0] != sides[1])  # of edges in line the next ones tell
    parts &= points.orientation(u, v, a) * points.orientation(u, v, b) <= 0
    return not parts.any()


def _places(ground: Triangulation, ends: list[int]) -> Places:
    """Give two vertices, then places within all triangles, then the middles of the edges between them.

    Through the middles of edges alone a path leads from everywhere to everywhere.
    """
    weights = WITHIN if len(ground.rings.rows) <= MANY else WITHIN[:0]
    within = np.repeat(np.arange(len(ground.triangles)), len(weights))
    inner = np.flatnonzero(ground.twins > np.arange(len(ground.twins)))
    free = np.einsum("ps,fsx->fpx", weights, ground.vertices[ground.triangles]).reshape(-1, 2)
    a, b = ground.triangles.ravel(), np.roll(ground.triangles, -1, axis=1).ravel()
    middles = ground.rings.rows[a[inner]], ground.rings.rows[b[inner]]
    points = ground.points.with_free(free).with_on_chords(*middles, np.full(len(inner), 0.5))
    added = np.arange(len(ground.points.start), len(points.start))
    homes = [np.flatnonzero((ground.triangles == end).any(axis=1)) for end in ends]
    triangle = np.concatenate([*homes, within, inner // 3, ground.twins[inner] // 3])
    place = np.repeat(np.arange(2 + len(added)), [*map(len, homes), *[1] * len(added)])
    place = np.concatenate([place, np.arange(2 + len(free), 2 + len(added))])
    order = np.argsort(triangle, kind="stable")
    return Places(points, np.concatenate([ground.rings.rows[ends], added]), place[order], triangle[order])


def _widest(ways: _Ways, task: Task) -> Floats | None:
    """Give the bends of that path with fewest links which keeps farthest away from the polygon.

    Links that all but touch the polygon are struck from what `ways` allows.
    """
    while (ahead := _levels(ways.sees, 0))[1] > 0:
        width, before = _widths(ways, ahead, task)
        if width[1] > 0:
            return _without_loops(ways.at[[0, *_trace(before), 1]])[1:-1]
    return None


def _widths(ways: _Ways, ahead: Indices, task: Task) -> tuple[Floats, Indices]:
    """Give how wide the ways are to places on paths with fewest links, and where these come from."""
    back = _levels(ways.sees, 1)
    width, before = np.zeros(len(ways.at)), np.zeros(len(ways.at), dtype=np.intp)
    front = np.array([0])
    width[0] = np.inf
    for level in range(1, ahead[1] + 1):
        found = np.flatnonzero((ahead == level) & (back == ahead[1] - level))
        reach = np.minimum(width[front][:, None], _berths_between(ways, front, found, task))
        before[found] = front[reach.argmax(axis=0)]
        width[found] = np.minimum(reach.max(axis=0), ways.room[found])
        front = found
    return width, before


def _levels(sees: Relation, start: int) -> Indices:
    """Give the number of links from one place to each; -1 where none lead there."""
    levels = np.full(len(sees), -1)
    front = np.array([start])
    level = 0
    while len(front):
        levels[front] = level
        front = np.flatnonzero(sees[front].any(axis=0) & (levels < 0))
        level += 1
    return levels


def _trace(before: Indices) -> list[int]:
    """Give the bends on the way from place 0 to place 1."""
    bends = [int(before[1])]
    while bends[-1]:
        bends.append(int(before[bends[-1]]))
    return bends[-2::-1]


def _without_loops(path: Floats) -> Floats:
    """Cut off the loops of a path: over given places the one with fewest links may still cross itself."""
    while len(path) > 3:
        pairs = crossing_edges(path)
        pairs = pairs[(pairs[:, 1] < len(path) - 1) & (np.diff(pairs, axis=1)[:, 0] > 1)]
        if not len(pairs):
            break
        first, last = pairs[pairs[:, 0] == pairs[0, 0]][-1]
        crossing = meeting_places(path, np.array([[first, last]]))
        path = np.concatenate([path[: first + 1], crossing, path[last + 1 :]])
    return path


def _berths_between(ways: _Ways, first: Indices, second: Indices, task: Task) -> Floats:
    """Give the berths of all segments from first to second places; 0 where no path may run."""
    sees = ways.sees[np.ix_(first, second)]
    a, b = np.nonzero(sees)
    berths = np.zeros(sees.shape)
    berths[a, b] = _berths(ways.at[first[a]], ways.at[second[b]], ways.reflex, task)
    a, b = np.nonzero(sees & (berths <= ways.slack))
    berths[a, b] = 0
    ways.sees[first[a], second[b]] = ways.sees[second[b], first[a]] = False
    return berths


def _berths(a: Floats, b: Floats, corners: Floats, task: Task) -> Floats:
    """Give the distance of each segment ab from the nearest corner."""
    berths = np.full(len(a), np.inf)
    for corner in corners:
        task.reach(0)
        np.minimum(berths, _distance(corner, a, b), out=berths)
    return berths


def _room(places: Floats, vertices: Floats) -> Floats:
    """Give the distance of each place from the polygon."""
    room = np.full(len(places), np.inf)
    for edge in zip(vertices, np.roll(vertices, -1, axis=0), strict=True):
        np.minimum(room, _distance(places, *edge), out=room)
    return room


def _distance(places: Floats, a: Floats, b: Floats) -> Floats:
    """Give the distances of places from segments ab; the shapes broadcast."""
    way = b - a
    share = ((places - a) * way).sum(axis=-1) / (way * way).sum(axis=-1)
    off = a + np.clip(share, 0, 1)[..., None] * way - places
    distance: Floats = np.hypot(off[..., 0], off[..., 1])
    return distance
