"""The room that vertices and edges are to keep: more than not to touch, where the shapes allow it."""

from dataclasses import dataclass

import numpy as np

from starskel.blending.certified.barrier import contacts
from starskel.certificate import near_pairs, safe
from starskel.clearance import nearer_pairs, stay_clear
from starskel.polar import as_complex
from starskel.predicates import Complex, Floats

KEPT = 1e-3
"""The distance to be kept, as a part of the size."""

SHARE = 0.25
"""It is no more than this part of the pair's distance in the source and in the target."""


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
        return self._roomy(as_complex(before), as_complex(after)) and safe(before, after)

    def _roomy(self, before: Complex, after: Complex) -> bool:
        for pairs in near_pairs(before, after, self.kept):
            vertex, edge = nearer_pairs(before, after, *pairs, self.kept)
            floors = np.full(len(vertex), self.kept)
            for end in self.ends:
                floors = np.minimum(floors, SHARE * contacts(end, vertex, edge).distance)
            if not stay_clear(before, after, vertex, edge, floors):
                return False
        return True
