"""Paths between two vertices inside a polygon: few links, and a large clearance.

Bends may lie at sampled places: some in each triangle of a triangulation, and in the middle of each diagonal
between triangles. Level by level, as in every graph, the paths over these places with fewest links are found;
the one among them that keeps farthest away from the polygon is taken. So bends and ends see no others of
their path but those next to them.

Paths in many polygons are found together, each as it is alone.
"""

from dataclasses import dataclass

import numpy as np
import shapely

from starskel.arrays import Flags, Floats, Indices
from starskel.crossings import crossing_edges, meeting_places
from starskel.decomposition.transfer.clearances import (
    are_diagonals,
    place_clearances,
    reflex_vertices,
    rounding,
    segment_clearances,
)
from starskel.decomposition.transfer.sightlines import Places, sightlines
from starskel.points import Points
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import Triangulation, delaunay

WITHIN = np.array([(64, 17, 15), (16, 65, 15), (17, 16, 63)]) / 96
"""Weights of the corners of a triangle for places in it: uneven, to stand in no line by chance."""

MANY = 250
"""Beyond so many vertices there are enough places in the middle of edges: the pairs grow with the square."""


@dataclass(frozen=True, eq=False)
class _Ways:
    """Where paths may run.

    Attributes
    ----------
    at : (m, 2) array
        The k starts, the k ends, and all places where there may be bends.
    ring : (m,) array of int
        In which ring they lie.
    sees : (m, m) array of bool
        Between which of them a path may run straight on.
    clearance : (m,) array
        The distances of the places from their polygons, infinite for starts and ends.
    reflex, corners : Rings and (r, 2) array
        The reflex vertices of each polygon without start and end, and where these are.
    slack : (k,) array
        What comes closer than this to a polygon may touch it.
    """

    at: Floats
    ring: Indices
    sees: Flags
    clearance: Floats
    reflex: Rings
    corners: Floats
    slack: Floats


def bends_between(
    points: Points, rings: Rings, starts: Indices, ends: Indices, task: Task
) -> list[Floats | None]:
    """Give for each of k simple rings the bends of a path with few links between two of its vertices.

    Parameters
    ----------
    points : Points
    rings : Rings
        Counter-clockwise.
    starts, ends : (k,) arrays of int
        Vertices of the rings, not next to each other.
    task : Task

    Returns
    -------
    list of (b, 2) arrays, or of None where the ring is too narrow for floats to name a path.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    straight = are_diagonals(points, rings, starts, ends, task)
    bends: list[Floats | None] = [np.empty((0, 2))] * len(straight)
    bent = np.flatnonzero(~straight)
    if len(bent):
        chosen = Rings.of([rings.rows[rings.first[k] : rings.last[k] + 1] for k in bent])
        moved = chosen.first - rings.first[bent]
        found = _bent(points, chosen, starts[bent] + moved, ends[bent] + moved, task)
        for k, path in zip(bent.tolist(), found, strict=True):
            bends[k] = path
    return bends


def _bent(points: Points, rings: Rings, starts: Indices, ends: Indices, task: Task) -> list[Floats | None]:
    ground = delaunay(points, rings)
    places = _places(ground, np.concatenate([starts, ends]))
    at = places.points.coordinates[places.rows]
    k = len(starts)
    sees = sightlines(ground, places, task)
    sees[np.arange(k), k + np.arange(k)] = sees[k + np.arange(k), np.arange(k)] = False
    ring = np.empty(len(at), dtype=np.intp)
    ring[places.place] = ground.owner[places.triangle]
    wide = np.concatenate(
        [np.full(2 * k, np.inf), place_clearances(at[2 * k :], ring[2 * k :], points, rings, task)]
    )
    slack = rounding(points, rings)
    tight = wide <= slack[ring]
    sees[tight] = sees[:, tight] = False
    reflex = reflex_vertices(points, rings, np.concatenate([starts, ends]))
    return _widest(_Ways(at, ring, sees, wide, reflex, points.coordinates[reflex.rows], slack), task)


def _places(ground: Triangulation, ends: Indices) -> Places:
    """Give some vertices, then places within all triangles, then the middles of the edges between them.

    Through the middles of edges alone a path leads from everywhere to everywhere.
    """
    weights = WITHIN if len(ground.vertices) <= MANY else WITHIN[:0]
    within = np.repeat(np.arange(len(ground.triangles)), len(weights))
    inner = np.flatnonzero(ground.twins > np.arange(len(ground.twins)))
    free = np.einsum("ps,fsx->fpx", weights, ground.vertices[ground.triangles]).reshape(-1, 2)
    a, b = ground.starts, ground.ends
    rows = ground.rings.rows
    points = ground.points.with_free(free).with_on_chords(
        rows[a[inner]], rows[b[inner]], np.full(len(inner), 0.5)
    )
    added = np.arange(len(ground.points.start), len(points.start))
    number = np.full(len(rows), -1)
    number[ends] = np.arange(len(ends))
    homes, corners = np.nonzero(number[ground.triangles] >= 0)
    triangle = np.concatenate([homes, within, inner // 3, ground.twins[inner] // 3])
    new = len(ends) + np.arange(len(added))
    place = np.concatenate([number[ground.triangles[homes, corners]], new, new[len(free) :]])
    order = np.argsort(triangle, kind="stable")
    return Places(points, np.concatenate([rows[ends], added]), place[order], triangle[order])


def _widest(ways: _Ways, task: Task) -> list[Floats | None]:
    """Give for each ring the bends of that path with fewest links which keeps farthest away from the ring.

    Links that all but touch the ring are struck from what `ways` allows, and the search begins again.
    """
    k = len(ways.reflex.counts)
    bends: list[Floats | None] = [None] * k
    searched = np.arange(k)
    while len(searched):
        ahead = _levels(ways.sees, searched)
        searched = searched[ahead[k + searched] > 0]
        width, before = _widths(ways, searched, ahead, task)
        found = width[k + searched] > 0
        rings = searched[found].tolist()
        paths = [ways.at[_trace(before, ring, k + ring)] for ring in rings]
        for ring, path, simple in zip(rings, paths, _are_simple(paths), strict=True):
            bends[ring] = (path if simple else _without_loops(path))[1:-1]
        searched = searched[~found]
    return bends


def _widths(ways: _Ways, searched: Indices, ahead: Indices, task: Task) -> tuple[Floats, Indices]:
    """Give how wide the ways are to places on paths with fewest links, and where these come from."""
    k = len(ways.reflex.counts)
    links = np.full(k, -1)
    links[searched] = ahead[k + searched]
    left = _levels(ways.sees, k + searched)
    on_path = np.flatnonzero((ahead >= 0) & (ahead + left == links[ways.ring]))
    level = ahead[on_path]
    order = np.argsort(level, kind="stable")
    on_path, level = on_path[order], level[order]
    clearance = _clearances_between(ways, on_path, level, task)
    width, before = np.zeros(len(ways.at)), np.zeros(len(ways.at), dtype=np.intp)
    width[searched] = np.inf
    ends = np.searchsorted(level, np.arange(level.max(initial=0) + 2))
    for first, last, end in zip(ends, ends[1:], ends[2:], strict=False):
        front, found = on_path[first:last], on_path[last:end]
        reach = np.minimum(width[front][:, None], clearance[first:last, last:end])
        before[found] = front[reach.argmax(axis=0)]
        width[found] = np.minimum(reach.max(axis=0), ways.clearance[found])
    return width, before


def _levels(sees: Flags, starts: Indices) -> Indices:
    """Give the number of links from the start in its ring to each place; -1 where none lead there."""
    levels = np.full(len(sees), -1)
    front = starts
    level = 0
    while len(front):
        levels[front] = level
        front = np.flatnonzero(sees[front].any(axis=0) & (levels < 0))
        level += 1
    return levels


def _trace(before: Indices, start: int, end: int) -> list[int]:
    """Give the places on the way from a start to an end."""
    way = [end]
    while way[-1] != start:
        way.append(int(before[way[-1]]))
    return way[::-1]


def _are_simple(paths: list[Floats]) -> Flags:
    if not paths:
        return np.empty(0, dtype=bool)
    owner = np.repeat(np.arange(len(paths)), list(map(len, paths)))
    simple: Flags = shapely.is_simple(shapely.linestrings(np.concatenate(paths), indices=owner))
    return simple


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


def _clearances_between(ways: _Ways, places: Indices, level: Indices, task: Task) -> Floats:
    """Give the clearances of all links from places to those at the next level; 0 where no path may run."""
    sees = ways.sees[np.ix_(places, places)] & (level[:, None] + 1 == level)
    a, b = np.nonzero(sees)
    ends = places[np.stack([a, b])]
    wide = segment_clearances(ways.at[ends.T], ways.ring[ends[0]], ways.corners, ways.reflex, task)
    free = wide > ways.slack[ways.ring[ends[0]]]
    reach = np.zeros(sees.shape)
    reach[a[free], b[free]] = wide[free]
    a, b = ends[:, ~free]
    ways.sees[a, b] = ways.sees[b, a] = False
    return reach
