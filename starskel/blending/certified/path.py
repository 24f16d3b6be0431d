"""The way from the source to the target: the wanted frames where they are simple, the least repair elsewhere."""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from starskel.blending.certified.keys import Chain, Guide, Key, chains_of
from starskel.blending.certified.metric import metric_of
from starskel.blending.certified.repair import bridged
from starskel.blending.certified.smoothing import smoothed, thinned
from starskel.blending.certified.room import KEPT, Room
from starskel.blending.certified.tracking import Pull
from starskel.decomposition.pieces import Decomposition
from starskel.polar import as_complex
from starskel.task import Task

MARGINS = (1 / 32, 1 / 8, 1 / 3)
"""By how much a gap is widened, in time, where no bridge is found over it as it is."""


class Way(StrEnum):
    """How a certified blend came about."""

    AS_IT_IS = "stitched as it is"
    REPAIRED = "repaired"
    CONVEX = "convex combination"


@dataclass(frozen=True, eq=False)
class Repair:
    """What bridges gaps.

    Attributes
    ----------
    guide : Guide
        The frames to stay near to.
    pull : Pull
        What keeps them simple.
    """

    guide: Guide
    pull: Pull

    def closed(self, chains: list[Chain], margin: float, task: Task) -> list[Chain]:
        """Bridge the gaps between chains, each widened by a margin; those that resist stay."""
        long = [chain for chain in chains[1:-1] if chain[-1].t - chain[0].t > 2 * margin]
        chains = [chains[0], *long, chains[-1]]  # what is shorter lies within the margins of two gaps
        done = [chains[0]]
        for at, chain in enumerate(chains[1:]):
            left = [key for key in done[-1] if key.t <= done[-1][-1].t - margin] or done[-1][:1]
            right = [key for key in chain if key.t >= chain[0].t + margin] or chain[-1:]
            share = 1 / (len(chains) - 1)
            bridge = self._bridge(left[-1], right[0], task.part(at * share, (at + 1) * share))
            if bridge is None:
                done.append(chain)
            else:
                done[-1] = [*left[:-1], *bridge, *right[1:]]
        return done

    def _bridge(self, before: Key, after: Key, task: Task) -> Chain | None:
        pull = self.pull.meeting((as_complex(before.frame), as_complex(after.frame)))
        bridge = bridged(before, after, self.guide, pull, task.part(0, 0.9))
        if bridge is None:
            return None
        few = thinned(bridge, pull.metric.size, pull.linked)
        return smoothed(few, self.guide, pull.linked, task.part(0.9, 1))


def path(decomposition: Decomposition, guide: Guide, task: Task) -> tuple[Chain, Way]:
    """Give keys from the source to the target, all links safe, and how they came about.

    Parameters
    ----------
    decomposition : Decomposition
    guide : Guide
        The frames to stay near to.
    task : Task

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    source, target = decomposition.pair.source, decomposition.pair.target
    ends = as_complex(source), as_complex(target)
    size = float(max(np.ptp(source, axis=0).max(), np.ptp(target, axis=0).max()))
    for kept in (KEPT * size, 0.0):
        room = Room(ends, kept)
        chains = chains_of(source, target, guide, room.links, task.part(0, 0.1))
        if len(chains) == 1:
            return chains[0], Way.AS_IT_IS
        repair = Repair(guide, Pull(metric_of(decomposition, task.part(0.1, 0.1)), ends, room.links))
        for margin in MARGINS:
            chains = repair.closed(chains, margin, task.part(0.1, 0.3))
            if len(chains) == 1:
                return chains[0], Way.REPAIRED
        whole = repair.closed([chains[0][:1], chains[-1][-1:]], 0, task.part(0.7, 0.9))
        if len(whole) == 1:
            return whole[0], Way.REPAIRED
    raise NotImplementedError
