"""The room that vertices and edges are to keep: more than not to touch, where the shapes allow it."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.certificate import meet, near_pairs, seen_ends
from starskel.clearance import nearer_pairs, stay_clear
from starskel.polar import as_complex

KEPT = 1e-3
"""The distance to be kept, as a part of the size."""

SHARE = 0.25
"""It is no more than this part of the pair's distance in the source and in the target."""


class Contact(NamedTuple):
    """Of vertices and edges: distances, directions (edge to vertex), how far along the edge is nearest."""

    distance: Floats
    direction: Complex
    share: Floats


@dataclass(frozen=True, eq=False)
class Room:
    """What is asked of a link.

    Attributes
    ----------
    ends : tuple of (n,) complex arrays
        The source and the target.
    kept : float
        The distance to be kept, in the shapes' units.
    """

    ends: tuple[Complex, ...]
    kept: float

    def links(self, before: Floats, after: Floats) -> bool:
        """Tell whether an even motion from one frame to another is safe, with room."""
        first, second = as_complex(before), as_complex(after)
        for near in near_pairs(first, second, self.kept):
            vertex, edge = nearer_pairs(first, second, *near, self.kept)
            clear = stay_clear(first, second, vertex, edge, self.floors(vertex, edge))
            if not clear or meet(before, after, vertex, edge):
                return False
        return True

    def floors(self, vertex: Indices, edge: Indices) -> Floats:
        """Give the distances that pairs are to keep."""
        floors = np.full(len(vertex), self.kept)
        for end in self.ends:
            floors = np.minimum(floors, SHARE * contacts(end, vertex, edge).distance)
        return floors


def contacts(frame: Complex, vertex: Indices, edge: Indices) -> Contact:
    """Measure pairs of a vertex and an edge."""
    p, q = seen_ends(frame, vertex, edge)
    along = q - p
    squared = along.real**2 + along.imag**2
    share = np.clip(-(p.real * along.real + p.imag * along.imag) / np.where(squared > 0, squared, 1.0), 0, 1)
    away = -(p + share * along)
    distance = np.maximum(np.abs(away), np.finfo(np.float64).tiny)
    return Contact(distance, away / distance, share)
