"""Fewer vertices on a ring, or more."""

from collections.abc import Collection
from heapq import heapify, heapreplace

import numpy as np
import shapely

from starskel.arrays import Floats, Indices


def kept_vertices(ring: Floats, tolerance: float, pinned: Collection[int] = ()) -> Indices:
    """Give the vertices that are left where a ring is simplified, so that no two edges come to cross.

    Vertex 0 stays, and so do the pinned ones and enough others for a triangle. The rest is Douglas and
    Peucker's rule as shapely has it, on all stretches between them at once, so that they respect each other.

    Parameters
    ----------
    ring : (n, 2) array
        A simple polygon.
    tolerance : float
        How far a vertex that goes may be from the edge that takes its place.
    pinned : collection of int
        Vertices that stay.
    """
    stops = sorted({0, *_widest_triangle(ring), *pinned})
    ends = [*stops[1:], len(ring)]
    stretches = [np.arange(a, b + 1) % len(ring) for a, b in zip(stops, ends, strict=True)]
    lines = shapely.multilinestrings([shapely.linestrings(ring[stretch]) for stretch in stretches])
    left = {(x, y) for x, y in shapely.get_coordinates(shapely.simplify(lines, tolerance)).tolist()}
    return np.flatnonzero([(x, y) in left for x, y in ring.tolist()])


def refined(ring: Floats, count: int, edges: Collection[int] | None = None) -> tuple[Floats, Indices]:
    """Add vertices evenly: each divides the edge whose parts are longest so far into one part more.

    Parameters
    ----------
    ring : (n, 2) array
        The vertices.
    count : int
        How many vertices to add.
    edges : collection of int, optional
        Which edges may be divided, by their first vertices; all of them by default.

    Returns
    -------
    (n + count, 2) array, (n,) array
        The ring, and where its former vertices are in it.
    """
    lengths = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
    parts = np.ones(len(ring), dtype=np.intp)
    longest = [(-float(lengths[edge]), edge) for edge in (range(len(ring)) if edges is None else edges)]
    heapify(longest)
    for _ in range(count if longest else 0):
        edge = longest[0][1]
        parts[edge] += 1
        heapreplace(longest, (-float(lengths[edge] / parts[edge]), edge))
    return _divided(ring, parts), np.concatenate([[0], np.cumsum(parts)[:-1]])


def _divided(ring: Floats, parts: Indices) -> Floats:
    starts, ends = (np.repeat(r, parts, axis=0) for r in (ring, np.roll(ring, -1, axis=0)))
    step = np.concatenate([np.arange(k) for k in parts])
    share = (step / np.repeat(parts, parts))[:, None]
    divided: Floats = np.where(share > 0, (1 - share) * starts + share * ends, starts)
    return divided


def _widest_triangle(ring: Floats) -> tuple[int, int]:
    """Give the vertex farthest from vertex 0, and the one farthest from the line between them."""
    away = ring - ring[0]
    far = int(np.hypot(*away.T).argmax())
    aside = np.abs(away[:, 0] * away[far, 1] - away[:, 1] * away[far, 0])
    return far, int(aside.argmax())
