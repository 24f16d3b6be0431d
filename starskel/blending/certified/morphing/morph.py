"""Bridging a gap that resists: by a convex combination morph, pulled towards the wanted frames.

First towards their places, then towards their shapes: parts that have to go another way keep their form.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats
from starskel.blending.certified.energies.energy import Field
from starskel.blending.certified.energies.room import Room
from starskel.blending.certified.gaps import narrowed
from starskel.blending.certified.keys import Chain, Guide, Key, chains_between
from starskel.blending.certified.morphing.convex_combination import convex_combination_of
from starskel.blending.certified.morphing.surroundings import surroundings_of
from starskel.blending.certified.relaxing import Relaxing
from starskel.blending.certified.repair import MARGINS as FOLLOWING_MARGINS
from starskel.blending.certified.repair import Following
from starskel.blending.certified.smoothing import retimed
from starskel.blending.certified.tracking import Allowance, Pull
from starskel.certificate import safe
from starskel.correspondence import Correspondence
from starskel.decomposition import decompose_quickly
from starskel.decomposition.pieces import Decomposition
from starskel.errors import InvalidPolygon
from starskel.task import Task

MARGINS = (1 / 32, 1.0)
"""By how much a gap is widened, in time, before it is bridged; else it is the whole."""

LINKS = (32, 32)
"""How many links a morph has at first, over the whole time: it need not be followed evenly."""

WORK = 330_000
"""What following a morph may cost where it is too narrow for floating point, in vertices of frames."""


@dataclass(frozen=True, eq=False)
class Morphing:
    """Bridges by morphs that never cross themselves, taken so densely that all links are safe.

    Attributes
    ----------
    decomposition : Decomposition
        That of the pair, for a gap that is the whole.
    guide : Guide
        The frames to come near to.
    field : Field
    room : Room
        What is to be kept where there is so much.
    """

    decomposition: Decomposition
    guide: Guide
    field: Field
    room: Room

    def __call__(self, before: Key, after: Key, task: Task) -> Chain | None:
        """Give a chain of safe links from one key to another; None if they are too narrow for rounding."""
        try:
            inside = self._inside(before, after, task.part(0, 0.2))
            morph = convex_combination_of(surroundings_of(inside, task.part(0.2, 0.5)), len(inside.pair))
        except InvalidPolygon:
            return None

        def guide(ts: Floats) -> Floats:
            return morph.frames((ts - before.t) / (after.t - before.t), task)

        field = self.field.meeting(before.frame, after.frame)
        chains = chains_between((before, after), guide, safe, task.part(0.5, 0.7), LINKS)
        if len(chains) > 1:
            pull = Pull(field, None, Allowance(WORK))
            chains = narrowed(chains, Following(guide, pull), FOLLOWING_MARGINS, task.part(0.7, 0.8))
        if len(chains) > 1:
            return None
        keys = Relaxing(self.guide, field, self.room)(chains[0], task.part(0.8, 0.9))
        keys = Relaxing(self.guide, field, self.room, turning=True)(keys, task.part(0.9, 1))
        return retimed([key.frame for key in keys], np.array([key.t for key in keys]))

    def _inside(self, before: Key, after: Key, task: Task) -> Decomposition:
        if before.t == 0 and after.t == 1:
            return self.decomposition
        own = np.arange(len(before.frame))
        return decompose_quickly(Correspondence(before.frame, after.frame, (), own, own), task)
