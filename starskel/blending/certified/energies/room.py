"""The room that vertices and edges are to keep: more than not to touch, where the shapes allow it."""

from dataclasses import dataclass, replace

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.blending.certified.energies.contacts import Distances
from starskel.certificate import meet, near_pairs
from starskel.clearance import Swept
from starskel.polar import as_complex
from starskel.predicates import UNIT

KEPT = 1e-3
"""The distance to be kept, as a part of the size."""

SHARE = 0.25
"""It is no more than this part of the pair's distance in the source and in the target."""

_ROUNDING = 128 * UNIT
"""Bounds the rounding of distances in motion, as a part of the largest coordinate: more is apart."""


@dataclass(frozen=True, eq=False)
class Room:
    """What is asked of a link.

    Attributes
    ----------
    ends : Distances
        Those in the source and in the target.
    kept : float
        The distance to be kept, in the shapes' units.
    """

    ends: Distances
    kept: float

    @classmethod
    def of(cls, ends: tuple[Complex, ...], kept: float) -> "Room":
        """Ask for so much, or what the source and the target leave."""
        return cls(Distances.of(ends, len(ends[0]), kept / SHARE), kept)

    def part(self, share: float) -> "Room":
        """Ask for a share of it."""
        return replace(self, kept=share * self.kept)

    def links(self, before: Floats, after: Floats) -> bool:
        """Tell whether an even motion from one frame to another is safe, with room."""
        first, second = as_complex(before), as_complex(after)
        rounding = _ROUNDING * float(max(np.abs(first).max(), np.abs(second).max()))
        for vertex, edge in near_pairs(first, second, self.kept):
            near = Swept.nearer(first, second, vertex, edge, self.kept)
            floors = self.floors(near.vertex, near.edge)
            if not near.keep(floors):
                return False
            thin = floors < rounding
            if thin.any() and meet(before, after, near.vertex[thin], near.edge[thin]):
                return False
        return True

    def floors(self, vertex: Indices, edge: Indices) -> Floats:
        """Give the distances that pairs are to keep."""
        return np.minimum(self.kept, SHARE * self.ends.at(vertex, edge))
