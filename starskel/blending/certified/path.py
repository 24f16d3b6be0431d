"""From source to target: by the wanted frames where they are simple, by the least repair elsewhere."""

from dataclasses import dataclass
from enum import StrEnum

from starskel.blending.certified.convex_combination import convex_combination_of
from starskel.blending.certified.keys import Chain, Guide, Key, chains_of
from starskel.blending.certified.metric import Metric, metric_of
from starskel.blending.certified.repair import bridged
from starskel.blending.certified.room import KEPT, Room
from starskel.blending.certified.smoothing import smoothed, thinned
from starskel.blending.certified.surroundings import surroundings_of
from starskel.blending.certified.tracking import Pull
from starskel.certificate import safe
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError, told
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

    def bridged(self, chains: list[Chain], task: Task) -> Chain | None:
        """Bridge all gaps, with ever wider margins, and at last the whole time; None if one resists."""
        for number, margin in enumerate(MARGINS):
            chains = self._narrowed(chains, margin, task.part(number / 4, (number + 1) / 4))
            if len(chains) == 1:
                return chains[0]
        return self._bridge(chains[0][0], chains[-1][-1], task.part(3 / 4, 1))

    def _narrowed(self, chains: list[Chain], margin: float, task: Task) -> list[Chain]:
        """Bridge gaps, each widened by a margin; those that resist stay."""
        long = [chain for chain in chains[1:-1] if chain[-1].t - chain[0].t > 2 * margin]
        chains = [chains[0], *long, chains[-1]]  # what is shorter lies within the margins of two gaps
        done, share = [chains[0]], 1 / (len(chains) - 1)
        for at, chain in enumerate(chains[1:]):
            left = [key for key in done[-1] if key.t <= done[-1][-1].t - margin] or done[-1][:1]
            right = [key for key in chain if key.t >= chain[0].t + margin] or chain[-1:]
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
    StarskelError
        If the shapes are too narrow somewhere for floating point.
    """
    metric = metric_of(decomposition, task)
    source, target = decomposition.pair.source, decomposition.pair.target
    ends = as_complex(source), as_complex(target)
    room = Room(ends, KEPT * metric.size)
    chains = chains_of(source, target, guide, room.links, task.part(0, 0.1))
    if len(chains) == 1:
        return chains[0], Way.AS_IT_IS
    keys = Repair(guide, Pull(metric, ends, room.links)).bridged(chains, task.part(0.1, 0.7))
    if keys is not None:
        return keys, Way.REPAIRED
    chains = chains_of(source, target, guide, safe, task.part(0.7, 0.8))
    if len(chains) == 1:
        return chains[0], Way.AS_IT_IS
    return _by_convex_combination(decomposition, metric, task.part(0.8, 1)), Way.CONVEX


def _by_convex_combination(decomposition: Decomposition, metric: Metric, task: Task) -> Chain:
    """Take the frames of a morph that never crosses itself, so densely that all links are safe."""
    pair = decomposition.pair
    morph = convex_combination_of(surroundings_of(decomposition, task.part(0, 0.5)), len(pair))
    chains = chains_of(pair.source, pair.target, morph.frames, safe, task.part(0.5, 0.8))
    if len(chains) == 1:
        return chains[0]
    ends = as_complex(pair.source), as_complex(pair.target)
    keys = Repair(morph.frames, Pull(metric, ends, safe)).bridged(chains, task.part(0.8, 1))
    if keys is None:
        raise StarskelError(
            told("no blend without crossings was found: a shape is all but as narrow as rounding"),
            told("widen its narrowest parts, or add marks"),
        )
    return keys
