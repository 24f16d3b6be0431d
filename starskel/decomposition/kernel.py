"""Kernels: from where a ring is seen whole."""

from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from starskel.points import Points, points_of
from starskel.predicates import ROUNDING, Complex, Floats, Indices, Relation
from starskel.rings import Rings, ranges
from starskel.task import UNWATCHED, Task

Entry = TypeVar("Entry", bound=np.generic)

_AT_ONCE = 64
"""Edges that cells are cut along between two questions whether to stop."""

_FIRST_EDGES = 8
"""Edges that vertices are held against at first; each time those left are held against twice as many."""


def star_vertices(sides: Sequence[Points], rings: Rings, task: Task = UNWATCHED) -> Relation:
    """Tell for each vertex of many simple rings whether it lies in the kernels of its ring, exactly.

    The rings are the same over all sides. A few edges leave few vertices to be held against the others.
    """
    ends = rings.rows[rings.following]
    star = np.arange(len(rings.rows))
    most = int(rings.counts.max(initial=0))
    for points in sides:
        done, step = 0, _FIRST_EDGES
        while done < most and len(star):
            task.reach(0)
            owner = rings.owner[star]
            held, edge = ranges(rings.first[owner] + done, (rings.counts[owner] - done).clip(0, step))
            right = points.orientation(rings.rows[edge], ends[edge], rings.rows[star[held]]) < 0
            star = star[np.bincount(held[right], minlength=len(star)) == 0]
            done, step = done + step, 2 * step
    stars = np.zeros(len(rings.rows), dtype=bool)
    stars[star] = True
    return stars


def star_point(points: Points, ring: Indices, task: Task = UNWATCHED) -> Floats | None:
    """Give a point strictly inside the kernel: the kernel's centroid; None where the kernel has no inside."""
    places, areas = star_points(points, Rings.of([ring]), task)
    return places[0] if areas[0] > 0 else None


def star_points(points: Points, rings: Rings, task: Task = UNWATCHED) -> tuple[Floats, Floats]:
    """Give for many rings over points the centroids of their kernels, and the kernels' areas.

    Exact predicates prove that the centroid is strictly to the left of all edges, and that the ring goes
    round it once. So the ring is simple, counter-clockwise and seen whole from there. Where that cannot be
    proven the area is 0, also where a kernel is too thin for floats to name a point in it.

    Returns
    -------
    (k, 2) and (k,) arrays
    """
    if not len(rings.counts):
        return np.empty((0, 2)), np.empty(0)
    vertices, owner, after = rings.rows, rings.owner, rings.following
    corner = (
        points.orientation(vertices[rings.preceding], vertices, vertices[after]) != 0
    )  # others bound nothing
    places, areas = _kernels(
        points.coordinates[vertices[corner]], np.bincount(owner[corner], minlength=len(rings.counts)), task
    )
    placed = points.with_free(places)
    sides = placed.orientation(vertices, vertices[after], len(points.coordinates) + owner)
    above = points.coordinates[vertices, 1] > places[owner, 1]
    turns = np.bincount(owner[above[after] & ~above], minlength=len(rings.counts))
    proven = np.logical_and.reduceat(sides > 0, rings.first) & (turns == 1)
    return places, np.where(proven, areas, 0.0)


def is_star_point(ring: Floats, place: Floats) -> bool:
    """Tell whether a place, known up to rounding, sees the whole of a simple ring, its boundary included."""
    points = points_of(ring)
    turns = points.orientation(*(np.roll(np.arange(len(ring)), step) for step in (1, 0, -1)))
    start = ring[np.flatnonzero(turns)]
    edge = np.roll(start, -1, axis=0) - start
    normal = np.stack([-edge[:, 1], edge[:, 0]], axis=1) / np.hypot(*edge.T)[:, None]
    inward = (normal * (place - start)).sum(axis=1)
    return bool((inward >= -ROUNDING * np.abs(ring).max()).all())


def _kernels(corners: Floats, counts: Indices, task: Task) -> tuple[Floats, Floats]:
    """Cut the boxes of rings to the left sides of all edges: centroids and areas of what is left."""
    centroids, areas = np.zeros(len(counts), dtype=np.complex128), np.zeros(len(counts))
    alive = np.flatnonzero(counts > 2)
    at = corners[np.repeat(counts > 2, counts)].view(np.complex128)[:, 0]
    counts = counts[alive]
    first = np.cumsum(counts) - counts
    cells, size = _boxes(at, first), np.full(len(alive), 4)
    step = 0
    while len(alive):
        cells, size = _clip(cells, size, at[first + step], at[first + (step + 1) % counts])
        step += 1
        if step % _AT_ONCE == 0:
            task.reach(0)
        done = counts == step
        if done.any():
            owner = np.repeat(done, size)
            whole = done & (size > 0)
            centroids[alive[whole]], areas[alive[whole]] = _centroids(cells[owner], size[whole])
            cells, size = cells[~owner], np.where(done, 0, size)
        left = size > 0
        alive, first, counts, size = alive[left], first[left], counts[left], size[left]
    return centroids[:, None].view(np.float64), areas


def _boxes(corners: Complex, first: Indices) -> Complex:
    """Give the corners of the boxes of rings that follow each other, counter-clockwise, box by box."""
    if not len(first):
        return np.empty(0, dtype=np.complex128)
    left, right = np.minimum.reduceat(corners.real, first), np.maximum.reduceat(corners.real, first)
    low, high = np.minimum.reduceat(corners.imag, first), np.maximum.reduceat(corners.imag, first)
    return np.stack([left, low, right, low, right, high, left, high], axis=1).ravel().view(np.complex128)


def _clip(cells: Complex, size: Indices, start: Complex, end: Complex) -> tuple[Complex, Indices]:
    """Keep the parts of convex cells to the left of lines.

    The cells, of so many corners each, follow each other; nothing stays of one that has nothing to the left.
    """
    off = cells - start.repeat(size)
    side = ((end - start).conj().repeat(size) * off).imag
    inside = side >= 0
    if inside.all():
        return cells, size
    last = np.cumsum(size) - 1
    first = last - size + 1
    following, beyond = _next(cells, first, last), _next(side, first, last)
    crossing = side * beyond < 0
    share = np.divide(side, side - beyond, out=np.zeros_like(side), where=crossing)
    corners = np.stack([cells, cells + share * (following - cells)], axis=1).ravel()
    inside &= (np.maximum.reduceat(side, first) > 0).repeat(size)
    kept = np.stack([inside, crossing], axis=1)
    return corners[kept.ravel()], np.add.reduceat(kept.sum(axis=1), first)


def _next(entries: NDArray[Entry], first: Indices, last: Indices) -> NDArray[Entry]:
    """Give for each entry the next one of its cell, for the last one the first."""
    following = np.empty_like(entries)
    following[:-1] = entries[1:]
    following[last] = entries[first]
    return following


def _centroids(cells: Complex, size: Indices) -> tuple[Complex, Floats]:
    """Give the centroids and the areas of convex cells of so many corners each."""
    last = np.cumsum(size) - 1
    first = last - size + 1
    base = cells[first]
    a = cells - base.repeat(size)
    b = _next(a, first, last)
    doubled = (a.conj() * b).imag
    areas = np.add.reduceat(doubled, first) / 2
    weighted = np.add.reduceat(doubled * (a + b), first)
    offset = np.divide(weighted, 6 * areas, out=np.zeros_like(weighted), where=areas > 0)
    return base + offset, np.maximum(areas, 0.0)
