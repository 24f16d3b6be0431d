"""Kernels: from where a ring is seen whole."""

from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from starskel.points import Points, points_of
from starskel.predicates import ROUNDING, Floats, Indices, Relation
from starskel.task import UNWATCHED, Task

Entry = TypeVar("Entry", bound=np.generic)

_AT_ONCE = 64


def star_vertices(points: Points, ring: Indices) -> Relation:
    """Give for each vertex of a simple ring over points whether it lies in the kernel, exactly."""
    stars = np.ones(len(ring), dtype=bool)
    ends = np.roll(ring, -1)
    for first in range(0, len(ring), _AT_ONCE):  # few edges leave few vertices to look at
        edges = slice(first, first + _AT_ONCE)
        sides = points.orientation(ring[edges][None], ends[edges][None], ring[stars, None])
        stars[stars] = (sides >= 0).all(axis=1)
    return stars


def star_point(points: Points, ring: Indices, task: Task = UNWATCHED) -> Floats | None:
    """Give a point strictly inside the kernel: the kernel's centroid; None where the kernel has no inside."""
    places, areas = star_points(points, [ring], task)
    return places[0] if areas[0] > 0 else None


def star_points(points: Points, rings: Sequence[Indices], task: Task = UNWATCHED) -> tuple[Floats, Floats]:
    """Give for many rings over points the centroids of their kernels, and the kernels' areas.

    Exact predicates prove that the centroid is strictly to the left of all edges, and that the ring goes
    round it once. So the ring is simple, counter-clockwise and seen whole from there. Where that cannot be
    proven the area is 0, also where a kernel is too thin for floats to name a point in it.

    Returns
    -------
    (k, 2) and (k,) arrays
    """
    if not len(rings):
        return np.empty((0, 2)), np.empty(0)
    counts = np.array([len(ring) for ring in rings])
    vertices = np.concatenate(rings)
    owner = np.repeat(np.arange(len(rings)), counts)
    first = np.cumsum(counts) - counts
    before, after = np.arange(len(vertices)) - 1, np.arange(len(vertices)) + 1
    before[first], after[first + counts - 1] = first + counts - 1, first
    corner = points.orientation(vertices[before], vertices, vertices[after]) != 0  # others bound nothing
    places, areas = _kernels(
        points.coordinates[vertices[corner]], np.bincount(owner[corner], minlength=len(rings)), task
    )
    placed = points.with_free(places)
    sides = placed.orientation(vertices, vertices[after], len(points.coordinates) + owner)
    above = points.coordinates[vertices, 1] > places[owner, 1]
    turns = np.bincount(owner[above[after] & ~above], minlength=len(rings))
    proven = np.logical_and.reduceat(sides > 0, first) & (turns == 1)
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
    centroids, areas = np.zeros((len(counts), 2)), np.zeros(len(counts))
    alive = np.flatnonzero(counts > 2)
    corners = corners[np.repeat(counts > 2, counts)]
    first = np.zeros(len(counts), dtype=np.intp)
    first[alive] = np.cumsum(counts[alive]) - counts[alive]
    cells = _boxes(corners, first[alive])
    step = 0
    while len(alive):
        at, after = first[alive] + step, first[alive] + (step + 1) % counts[alive]
        cells, left = _clip(cells, corners[at], corners[after])
        alive = alive[left]
        step += 1
        if step % _AT_ONCE == 0:
            task.reach(0)
        done = counts[alive] == step
        if done.any():
            centroids[alive[done]], areas[alive[done]] = _centroids(cells[done])
            cells, alive = cells[~done], alive[~done]
    return centroids, areas


def _boxes(corners: Floats, first: Indices) -> Floats:
    """Give the (k, 4, 2) boxes of rings that follow each other, counter-clockwise."""
    if not len(first):
        return np.empty((0, 4, 2))
    (left, low), (right, high) = np.minimum.reduceat(corners, first).T, np.maximum.reduceat(corners, first).T
    return np.stack([left, low, right, low, right, high, left, high], axis=1).reshape(-1, 4, 2)


def _clip(cells: Floats, start: Floats, end: Floats) -> tuple[Floats, Relation]:
    """Keep the parts of convex cells to the left of lines; tell from which cells anything is left."""
    way = (end - start)[:, None]
    off = cells - start[:, None]
    side = way[..., 0] * off[..., 1] - way[..., 1] * off[..., 0]
    if (side >= 0).all():
        return cells, np.ones(len(cells), dtype=bool)
    left = side.max(axis=1) > 0
    if not left.any():
        return cells[left], left
    cells, side = cells[left], side[left]
    following, beyond = np.roll(cells, -1, axis=1), np.roll(side, -1, axis=1)
    crossing = side * beyond < 0
    share = np.divide(side, side - beyond, out=np.zeros_like(side), where=crossing)
    corners = _interleaved(cells, cells + share[..., None] * (following - cells))
    kept = _interleaved(side >= 0, crossing)
    count = kept.sum(axis=1)
    order = np.argsort(~kept, axis=1, kind="stable")
    slots = np.minimum(np.arange(count.max()), count[:, None] - 1)
    return np.take_along_axis(corners, np.take_along_axis(order, slots, axis=1)[..., None], axis=1), left


def _interleaved(first: NDArray[Entry], second: NDArray[Entry]) -> NDArray[Entry]:
    """Give the entries of two arrays in turn, along axis 1."""
    k, m, *rest = first.shape
    return np.stack([first, second], axis=2).reshape(k, 2 * m, *rest)


def _centroids(cells: Floats) -> tuple[Floats, Floats]:
    """Give the centroids and the areas of convex cells."""
    base = cells[:, :1]
    a, b = cells[:, 1:-1] - base, cells[:, 2:] - base
    doubled = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    areas = doubled.sum(axis=1) / 2
    weighted = (doubled[..., None] * (a + b)).sum(axis=1)
    offset = np.divide(weighted, 6 * areas[:, None], out=np.zeros_like(weighted), where=areas[:, None] > 0)
    return base[:, 0] + offset, np.maximum(areas, 0.0)
