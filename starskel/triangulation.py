"""Triangulating a ring: the ground that visibility expands over."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely

from starskel.errors import InvalidPolygon
from starskel.points import Indices, Points, points_of
from starskel.predicates import Floats

Triangle = tuple[int, int, int]


@dataclass(frozen=True, eq=False)
class Triangulation:
    """Triangles without area zero that tile a ring, every vertex of the ring among their corners.

    Attributes
    ----------
    points : Points
        The vertices of the ring.
    triangles : (n - 2, 3) array of int
        Corners, counter-clockwise. Half-edge 3 f + s runs from corner s of triangle f to the next.
    twins : (3 n - 6,) array of int
        For each half-edge the one on its other side, or -1 on the ring.
    """

    points: Points
    triangles: Indices
    twins: Indices


def triangulate(ring: Floats) -> Triangulation:
    """Triangulate a simple (n, 2) ring, exactly right also where vertices lie on straight runs."""
    points = points_of(ring)
    corners = np.flatnonzero(~points.straight)
    triangles = _delaunay(points, corners)
    if triangles is None:
        triangles = _cut_ears(points, corners)
    triangles = np.array(_split_runs(triangles, _runs(points)))
    return Triangulation(points, triangles, _twins(triangles))


def _delaunay(points: Points, corners: Indices) -> Indices | None:
    """Let GEOS triangulate; believe it only if every triangle and every edge proves right."""
    ring = points.coordinates[corners]
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(shapely.Polygon(ring)))
    found = shapely.get_coordinates(parts).reshape(-1, 4, 2)[:, :3]
    row = {(x, y): i for i, (x, y) in zip(corners.tolist(), ring.tolist(), strict=True)}
    named = [row.get((x, y), -1) for x, y in found.reshape(-1, 2).tolist()]
    triangles = np.array(named, dtype=np.intp).reshape(-1, 3)
    if len(triangles) != len(corners) - 2 or triangles.min() < 0:
        return None
    turns = points.orientation(*triangles.T)
    triangles[turns < 0] = triangles[turns < 0][:, ::-1]
    return triangles if (turns != 0).all() and _tiles(triangles, corners) else None


def _tiles(triangles: Indices, corners: Indices) -> bool:
    """Tell whether counter-clockwise triangles fit together along their edges and end at the ring."""
    edges = {(a, b) for t in triangles.tolist() for a, b in zip(t, (*t[1:], t[0]), strict=True)}
    outer = {(a, b) for a, b in edges if (b, a) not in edges}
    ring = corners.tolist()
    return len(edges) == 3 * len(triangles) and outer == set(zip(ring, (*ring[1:], ring[0]), strict=True))


def _cut_ears(points: Points, corners: Indices) -> Indices:
    """Triangulate by cutting ears; O(n^2), for rings too nearly degenerate for floating point."""
    left = corners.tolist()
    ears: list[Triangle] = []
    at = tried = 0
    while len(left) > 3:
        ear = left[at - 1], left[at], left[(at + 1) % len(left)]
        if _is_ear(points, ear, np.array(left)):
            ears.append(ear)
            left.pop(at)
            tried = 0
        elif (tried := tried + 1) > len(left):
            x, y = points.coordinates[ear[1]]
            raise InvalidPolygon(
                f"the polygon all but touches itself near vertex {ear[1]}, at ({x:g}, {y:g})",
                "move this vertex, or those next to it, apart",
                vertices=(ear[1],),
                place=(float(x), float(y)),
            )
        else:
            at += 1
        at %= len(left)
    return np.array([*ears, left])


def _is_ear(points: Points, ear: Triangle, left: Indices) -> bool:
    a, b, c = (np.array([v]) for v in ear)
    if points.orientation(a, b, c)[0] <= 0:
        return False
    others = left[~np.isin(left, ear)]
    outside = (
        (points.orientation(a, b, others) < 0)
        | (points.orientation(b, c, others) < 0)
        | (points.orientation(c, a, others) < 0)
    )
    return bool(outside.all())


def _runs(points: Points) -> dict[tuple[int, int], list[int]]:
    """Give for each edge between corners the straight vertices on it, in order."""
    runs: dict[tuple[int, int], list[int]] = {}
    straight = np.flatnonzero(points.straight)
    for v in straight[np.argsort(points.share[straight], kind="stable")].tolist():
        runs.setdefault((int(points.start[v]), int(points.end[v])), []).append(v)
    return runs


def _split_runs(triangles: Indices, runs: dict[tuple[int, int], list[int]]) -> list[Triangle]:
    """Split triangles at straight vertices into fans from the opposite corner."""
    done: list[Triangle] = []
    waiting: list[Triangle] = [(a, b, c) for a, b, c in triangles.tolist()]
    while waiting:
        a, b, c = waiting.pop()
        for p, q, apex in ((a, b, c), (b, c, a), (c, a, b)):
            if (p, q) in runs:
                waiting += [(v, w, apex) for v, w in pairwise([p, *runs.pop((p, q)), q])]
                break
        else:
            done.append((a, b, c))
    return done


def _twins(triangles: Indices) -> Indices:
    starts = triangles.ravel()
    ends = np.roll(triangles, -1, axis=1).ravel()
    half_edge = {edge: h for h, edge in enumerate(zip(starts.tolist(), ends.tolist(), strict=True))}
    twins = [half_edge.get(edge, -1) for edge in zip(ends.tolist(), starts.tolist(), strict=True)]
    return np.array(twins, dtype=np.intp)
