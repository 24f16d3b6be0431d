"""Where edges of rings meet that should not: found through boxes, decided exactly."""

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from starskel.arrays import Floats, Indices
from starskel.predicates import folds_back, segments_meet

FEW = 64
"""So few edges are not counted before they are compared."""

CANDIDATES = 500_000
"""So many pairs of edges are looked at in one go: a tangle has as many as its edges squared."""


def crossing_edges(ring: Floats) -> Indices:
    """Give the pairs (i, j), i < j, of edges that meet though they should not, as a (k, 2) array.

    Edge i runs from vertex i to the next. Neighbouring edges meet wrongly where one folds back on the other.
    """
    return np.concatenate(list(_crossings(ring)))


def first_crossing(ring: Floats) -> tuple[int, int] | None:
    """Give the first of these pairs; None where the ring is simple. It stops looking where it finds one."""
    pairs = next((block for block in _crossings(ring) if len(block)), None)
    return None if pairs is None else (int(pairs[0, 0]), int(pairs[0, 1]))


def crossing_places(ring: Floats) -> Floats:
    """Give where edges of an (n, 2) ring meet that should not, as (k, 2) points."""
    return meeting_places(ring, crossing_edges(ring))


def meeting_places(ring: Floats, pairs: Indices) -> Floats:
    """Give where each of the (k, 2) pairs of edges meet, as (k, 2) points; of a common stretch its middle."""
    edges = shapely.linestrings(np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)[pairs])
    shared = shapely.intersection(edges[:, 0], edges[:, 1])
    places: Floats = ring[pairs[:, 1]]  # for those that meet, but not at a point that floats can name
    places[~shapely.is_empty(shared)] = shapely.get_coordinates(shapely.centroid(shared))
    return places


def rings_meet(rings: Sequence[Floats]) -> bool:
    """Tell whether edges of different rings cross or touch, exactly.

    Parameters
    ----------
    rings : sequence of (n, 2) arrays
    """
    if len(rings) < 2:
        return False
    starts, ends = edges_of_rings(rings)
    owner = np.repeat(np.arange(len(rings)), [len(ring) for ring in rings])
    for _, first, second in near_edges(starts, ends):
        others = owner[first] < owner[second]
        i, j = first[others], second[others]
        if segments_meet(starts[i], ends[i], starts[j], ends[j]).any():
            return True
    return False


def overlapping_edges(rings: Sequence[Floats], most: int) -> int:
    """Count the pairs of edges whose boxes overlap, neighbours left out, but not far beyond `most`.

    Of `FEW` edges none are counted: looking at them all is quicker.

    Parameters
    ----------
    rings : sequence of (n, 2) arrays
    most : int
    """
    starts, ends = edges_of_rings(rings)
    if len(starts) <= FEW:
        return 0
    twice = -3 * len(starts)  # each meets itself and two neighbours
    for _, i, _ in near_edges(starts, ends):
        twice += len(i)
        if twice > 2 * most:
            break
    return max(twice, 0) // 2


def edges_of_rings(rings: Sequence[Floats]) -> tuple[Floats, Floats]:
    """Give the starts and the ends of all edges of (n, 2) rings, ring after ring."""
    return np.concatenate(rings), np.concatenate([np.roll(ring, -1, axis=0) for ring in rings])


def near_edges(
    starts: Floats, ends: Floats, predicate: str | None = None
) -> Iterator[tuple[Indices, Indices, Indices]]:
    """Give pairs of edges whose boxes overlap, block by block: the edges of the block, and of each pair both.

    Each edge makes a pair with itself, and all pairs come from both their edges.

    Parameters
    ----------
    starts, ends : (n, 2) arrays
    predicate : str, optional
        What pairs have to fulfil besides, as in shapely's trees.
    """
    edges = shapely.linestrings(np.stack([starts, ends], axis=1))
    tree = shapely.STRtree(edges)
    for block in _blocks(starts, ends):
        i, j = tree.query(edges[block], predicate=predicate)
        yield block, block[i], j


def _crossings(ring: Floats) -> Iterator[Indices]:
    """Give the pairs of `crossing_edges` block by block, in order."""
    n = len(ring)
    ends = np.roll(ring, -1, axis=0)
    spikes = np.flatnonzero(folds_back(np.roll(ring, 1, axis=0), ring, ends))
    folded = np.sort(np.stack([(spikes - 1) % n, spikes], axis=1), axis=1)
    for block, first, second in near_edges(ring, ends):
        apart = (second - first > 1) & (second - first < n - 1)
        i, j = first[apart], second[apart]
        meet = segments_meet(ring[i], ends[i], ring[j], ends[j])
        own = folded[(block[0] <= folded[:, 0]) & (folded[:, 0] <= block[-1])]
        pairs: Indices = np.concatenate([own, np.stack([i[meet], j[meet]], axis=1)])
        yield pairs[np.lexsort(pairs.T[::-1])]


def _blocks(starts: Floats, ends: Floats) -> list[Indices]:
    """Cut the numbers of the edges where the pairs of overlapping boxes would become too many.

    They are counted from above: boxes that overlap do so in x and in y.
    """
    numbers = np.arange(len(starts))
    if len(starts) ** 2 <= CANDIDATES:
        return [numbers]
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    overlaps = np.min(
        [
            np.searchsorted(np.sort(low[:, axis]), high[:, axis], "right")
            - np.searchsorted(np.sort(high[:, axis]), low[:, axis], "left")
            for axis in (0, 1)
        ],
        axis=0,
    )
    return np.split(numbers, np.flatnonzero(np.diff(overlaps.cumsum() // CANDIDATES)) + 1)
