"""Bridging a gap that resists: by a convex combination morph, pulled towards the wanted frames."""

from dataclasses import dataclass, replace

import numpy as np

from starskel.blending.certified.convex_combination import convex_combination_of
from starskel.blending.certified.gaps import narrowed
from starskel.blending.certified.keys import Chain, Guide, Key, chains_between, frames_at
from starskel.blending.certified.repair import MARGINS as FOLLOWING_MARGINS
from starskel.blending.certified.repair import Following
from starskel.blending.certified.smoothing import retimed
from starskel.blending.certified.surroundings import surroundings_of
from starskel.blending.certified.tracking import Pull
from starskel.certificate import safe
from starskel.correspondence import Correspondence
from starskel.decomposition import decompose_quickly
from starskel.decomposition.pieces import Decomposition
from starskel.errors import InvalidPolygon
from starskel.polar import as_complex
from starskel.predicates import Floats
from starskel.task import Task

MARGINS = (1 / 32, 1.0)
"""By how much a gap is widened, in time, before it is bridged; else it is the whole."""

LINKS = (32,)
"""How many links a morph has at first, over the whole time: it need not be followed evenly."""

SWEEPS = 4
"""How often all keys are pulled."""


@dataclass(frozen=True, eq=False)
class Morphing:
    """Bridges by morphs that never cross themselves, taken so densely that all links are safe.

    Attributes
    ----------
    decomposition : Decomposition
        That of the pair, for a gap that is the whole.
    guide : Guide
        The frames to come near to.
    pull : Pull
        What pulls there, and follows a morph where it is too narrow for floating point.
    """

    decomposition: Decomposition
    guide: Guide
    pull: Pull

    def __call__(self, before: Key, after: Key, task: Task) -> Chain | None:
        """Give a chain of safe links from one key to another; None if they are too narrow for rounding."""
        try:
            inside = self._inside(before, after, task.part(0, 0.2))
            morph = convex_combination_of(surroundings_of(inside, task.part(0.2, 0.5)), len(inside.pair))
        except InvalidPolygon:
            return None

        def guide(ts: Floats) -> Floats:
            return morph.frames((ts - before.t) / (after.t - before.t), task)

        pull = self.pull.meeting((as_complex(before.frame), as_complex(after.frame)))
        chains = chains_between((before, after), guide, safe, task.part(0.5, 0.7), LINKS)
        if len(chains) > 1:
            anyhow = replace(pull, room=None)
            chains = narrowed(chains, Following(guide, anyhow), FOLLOWING_MARGINS, task.part(0.7, 0.8))
        return _relaxed(chains[0], self.guide, pull, task.part(0.8, 1)) if len(chains) == 1 else None

    def _inside(self, before: Key, after: Key, task: Task) -> Decomposition:
        if before.t == 0 and after.t == 1:
            return self.decomposition
        own = np.arange(len(before.frame))
        return decompose_quickly(Correspondence(before.frame, after.frame, (), own, own), task)


def _relaxed(keys: Chain, guide: Guide, pull: Pull, task: Task) -> Chain:
    """Pull inner keys towards a guide's frames, as far as their links stay good."""
    frames, times = [key.frame for key in keys], np.array([key.t for key in keys])
    goals = frames_at(times, guide, len(frames[0]), task)
    for sweep in range(SWEEPS):
        for first in (1, 2):  # every other key, so that it does not matter where the sweep begins
            for k in range(first, len(keys) - 1, 2):
                part = task.part(sweep / SWEEPS, 1)
                frames[k] = pull.between(frames[k - 1], frames[k], frames[k + 1], goals[k], part)
    return retimed(frames, times)
