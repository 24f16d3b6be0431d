"""Proving a decomposition from outside, without the code that made it.

Every piece is a simple counter-clockwise ring, and the pieces' edges cancel in pairs but for those of the
polygon. Then the winding numbers of the pieces add up to that of the polygon, 1 inside and 0 outside, and as
each of them is 0 or 1 the pieces tile the polygon without overlap. It remains to see that each origin sees
its piece.
"""

from collections import Counter

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.crossings import crossing_edges
from starskel.decomposition.pieces import Decomposition, edges_of
from starskel.outline import signed_areas
from starskel.points import Points, points_of
from starskel.predicates import ROUNDING


def faults(decomposition: Decomposition) -> list[str]:
    """Say what is wrong with a decomposition; an empty list is the proof that nothing is."""
    found = _edge_faults(decomposition)
    sides = (
        ("source", decomposition.pair.source, decomposition.source, decomposition.source_origins),
        ("target", decomposition.pair.target, decomposition.target, decomposition.target_origins),
    )
    for side, ring, vertices, origins in sides:
        if not np.array_equal(vertices[: len(ring)], ring):
            found.append(f"{side}: the first vertices are not those of the polygon")
        if len(origins) != len(decomposition.pieces):
            found.append(f"{side}: {len(origins)} origins for {len(decomposition.pieces)} pieces")
            continue
        points = points_of(ring, decomposition.pair.starts).with_free(vertices[len(ring) :])
        for at, piece in enumerate(decomposition.pieces):
            fault = _piece_fault(points, np.array(piece), origins[at])
            if fault:
                found.append(f"{side}: piece {at} {fault}")
    return found


def _edge_faults(decomposition: Decomposition) -> list[str]:
    edges = Counter(edge for piece in decomposition.pieces for edge in edges_of(piece))
    ring = set(enumerate(decomposition.pair.following.tolist()))
    found = [f"edge {a}-{b} stands {k} times in one direction" for (a, b), k in edges.items() if k > 1]
    found += [f"edge {a}-{b} of the polygon is in no piece" for a, b in sorted(ring - edges.keys())]
    lonely = sorted((a, b) for a, b in edges if ((b, a) not in edges) != ((a, b) in ring))
    return found + [f"edge {a}-{b} has no partner" for a, b in lonely]


def _piece_fault(points: Points, piece: Indices, origin: Floats) -> str:
    if len(piece) < 3:
        return "has fewer than 3 vertices"
    if not points.orientation(np.roll(piece, 1), piece, np.roll(piece, -1)).any():
        return "has no area"
    ring = points.coordinates[piece]
    if len(crossing_edges(ring)):
        return "is not simple"
    if not signed_areas(ring) > 0:
        return "is not counter-clockwise"
    if not _sees_whole(ring, origin):
        return "is not seen whole from its origin"
    return ""


def _sees_whole(ring: Floats, place: Floats) -> bool:
    """Tell whether a place, known up to rounding, sees the whole of a simple ring, its boundary included."""
    points = points_of(ring)
    turns = points.orientation(*(np.roll(np.arange(len(ring)), step) for step in (1, 0, -1)))
    start = ring[np.flatnonzero(turns)]
    edge = np.roll(start, -1, axis=0) - start
    normal = np.stack([-edge[:, 1], edge[:, 0]], axis=1) / np.hypot(*edge.T)[:, None]
    inward = (normal * (place - start)).sum(axis=1)
    return bool((inward >= -ROUNDING * np.abs(ring).max()).all())
