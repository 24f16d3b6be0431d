"""Clearances: how far places and segments inside rings keep away from these; for many rings together."""

from collections.abc import Callable

import numpy as np

from starskel.arrays import Complex, Flags, Floats, Indices
from starskel.points import Points
from starskel.predicates import ROUNDING
from starskel.rings import Rings, blocks, ranges
from starskel.task import Task

BLOCK = 1 << 16
"""Pairs of a place and an edge that are measured between two questions whether to stop."""


def rounding(points: Points, rings: Rings) -> Floats:
    """Give (k,) by how much the coordinates of rings may be off: what comes closer may touch them."""
    largest = np.abs(points.coordinates[rings.rows]).max(axis=1)
    slack: Floats = ROUNDING * np.maximum.reduceat(largest, rings.first)
    return slack


def reflex_vertices(points: Points, rings: Rings, left_out: Indices) -> Rings:
    """Give the reflex vertices of each ring, but for some.

    A segment inside the ring comes closest to it at an end or there.
    """
    rows = rings.rows
    reflex = points.orientation(rows[rings.preceding], rows, rows[rings.following]) < 0
    reflex[left_out] = False
    return Rings(rows[reflex], np.bincount(rings.owner[reflex], minlength=len(rings.counts)))


def are_diagonals(points: Points, rings: Rings, starts: Indices, ends: Indices, task: Task) -> Flags:
    """Tell for each of k rings whether the segment between two of its vertices is a clear diagonal."""
    rows = rings.rows
    a, b, u, v = rows[starts], rows[ends], rows, rows[rings.following]
    first, last = a[rings.owner], b[rings.owner]
    others = (u != first) & (u != last) & (v != first) & (v != last)
    first, last, u, v = first[others], last[others], u[others], v[others]
    sides = points.orientation(first, last, u), points.orientation(first, last, v)
    parts = (sides[0] * sides[1] <= 0) & (sides[0] != sides[1])  # of edges in line the next ones tell
    parts &= points.orientation(u, v, first) * points.orientation(u, v, last) <= 0
    clear = np.bincount(rings.owner[others][parts], minlength=len(starts)) == 0
    reflex = reflex_vertices(points, rings, np.concatenate([starts, ends]))
    at, own = points.coordinates, np.arange(len(starts))
    clearance = segment_clearances(at[np.stack([a, b], axis=1)], own, at[reflex.rows], reflex, task)
    inside: Flags = _lead_inside(points, rings, starts, b) & clear
    return inside & (clearance > rounding(points, rings))


def _lead_inside(points: Points, rings: Rings, starts: Indices, towards: Indices) -> Flags:
    """Tell whether the way from vertices towards other points begins inside their rings."""
    at, before, after = (rings.rows[v] for v in (starts, rings.preceding[starts], rings.following[starts]))
    left_of_next = points.orientation(at, after, towards) > 0
    left_of_last = points.orientation(before, at, towards) > 0
    reflex = points.orientation(before, at, after) < 0
    return np.asarray(np.where(reflex, left_of_next | left_of_last, left_of_next & left_of_last))


def place_clearances(places: Floats, owner: Indices, points: Points, rings: Rings, task: Task) -> Floats:
    """Give the distances of (m, 2) places from the rings that they lie in, their owners."""
    at, start = _complex(places), _complex(points.coordinates[rings.rows])
    end = start[rings.following]
    return _least(owner, rings, lambda place, edge: _distance(at[place], start[edge], end[edge]), task)


def segment_clearances(segments: Floats, owner: Indices, corners: Floats, rings: Rings, task: Task) -> Floats:
    """Give how far (m, 2, 2) segments are from the nearest corner of their ring; infinite without any."""
    (a, b), at = (_complex(ends) for ends in np.moveaxis(segments, 1, 0)), _complex(corners)
    return _least(owner, rings, lambda segment, corner: _distance(at[corner], a[segment], b[segment]), task)


def _least(
    owner: Indices, rings: Rings, distance: Callable[[Indices, Indices], Floats], task: Task
) -> Floats:
    """Give the least of the distances between things and all vertices of the rings that they belong to."""
    least = np.full(len(owner), np.inf)
    some = np.flatnonzero(rings.counts[owner])
    counts = rings.counts[owner[some]]
    for part in blocks(counts, BLOCK):
        task.reach(0)
        things, count = some[part], counts[part]
        thing, vertex = ranges(rings.first[owner[things]], count)
        least[things] = np.minimum.reduceat(distance(things[thing], vertex), np.cumsum(count) - count)
    return least


def _distance(places: Complex, a: Complex, b: Complex) -> Floats:
    """Give the distances of places from segments ab."""
    way, off = b - a, places - a
    share = (off * way.conj()).real / (way * way.conj()).real
    distance: Floats = np.abs(off - share.clip(0, 1) * way)
    return distance


def _complex(places: Floats) -> Complex:
    numbers: Complex = np.ascontiguousarray(places).view(np.complex128)[:, 0]
    return numbers
