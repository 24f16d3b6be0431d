"""From source to target: by the wanted frames where they are simple, by the least repair elsewhere."""

from dataclasses import dataclass, field
from enum import StrEnum
from itertools import pairwise

from starskel.blending.certified.convex_combination import convex_combination_of
from starskel.blending.certified.keys import Chain, Guide, Key, chains_between, filled
from starskel.blending.certified.metric import Metric, metric_of
from starskel.blending.certified.repair import bridged
from starskel.blending.certified.room import KEPT, Room
from starskel.blending.certified.smoothing import smoothed, thinned
from starskel.blending.certified.surroundings import surroundings_of
from starskel.blending.certified.tracking import Allowance, Pull
from starskel.certificate import safe
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError, told
from starskel.polar import as_complex
from starskel.task import Task

MARGINS = (1 / 32, 1 / 8, 1 / 3, 1.0)
"""By how much a gap is widened, in time, where it resists as it is; at last it is the whole."""

WORK = 150_000
"""What following may cost before the next way is tried, in vertices of frames."""


class Way(StrEnum):
    """How a certified blend came about."""

    AS_IT_IS = "as stitched"
    REPAIRED = "repaired"
    CONVEX = "convex morph"


def proven(keys: Chain, task: Task) -> bool:
    """Tell whether all links are safe: the one certificate, whatever led to these keys."""
    for before, after in pairwise(keys):
        task.reach(0)
        if not safe(before.frame, after.frame):
            return False
    return True


@dataclass(frozen=True, eq=False)
class Repair:
    """What bridges gaps.

    Attributes
    ----------
    guide : Guide
        The frames to stay near to.
    pull : Pull
        What keeps them simple.
    resisted : set of tuples
        From when to when no bridge was found.
    """

    guide: Guide
    pull: Pull
    resisted: set[tuple[float, float]] = field(default_factory=set)

    def narrowed(self, chains: list[Chain], task: Task) -> list[Chain]:
        """Bridge gaps, with ever wider margins; those that resist stay."""
        for number, margin in enumerate(MARGINS):
            chains = self._narrowed(
                chains, margin, task.part(number / len(MARGINS), (number + 1) / len(MARGINS))
            )
            if len(chains) == 1:
                break
        return chains

    def _narrowed(self, chains: list[Chain], margin: float, task: Task) -> list[Chain]:
        """Bridge gaps, each widened by a margin; those that resist stay."""
        long = [chain for chain in chains[1:-1] if chain[-1].t - chain[0].t > 2 * margin]
        chains = [chains[0], *long, chains[-1]]  # what is shorter lies within the margins of two gaps
        done, share = [chains[0]], 1 / (len(chains) - 1)
        for at, chain in enumerate(chains[1:]):
            left = [key for key in done[-1] if key.t <= done[-1][-1].t - margin] or done[-1][:1]
            right = [key for key in chain if key.t >= chain[0].t + margin] or chain[-1:]
            span = left[-1].t, right[0].t
            bridge = None
            if span not in self.resisted:
                bridge = self._bridge(left[-1], right[0], task.part(at * share, (at + 1) * share))
            if bridge is None:
                self.resisted.add(span)
                done.append(chain)
            else:
                done[-1] = [*left[:-1], *bridge, *right[1:]]
        return done

    def _bridge(self, before: Key, after: Key, task: Task) -> Chain | None:
        pull = self.pull.meeting((as_complex(before.frame), as_complex(after.frame)))
        bridge = bridged(before, after, self.guide, pull, task.part(0, 0.9))
        if bridge is None:
            return None
        few = thinned(bridge, pull.metric.size, pull.linked, task.part(0.9, 0.9))
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
    chains = [[Key(0.0, source)], [Key(1.0, target)]]
    way = Way.AS_IT_IS
    for kept, part in ((room, task.part(0.05, 0.4)), (None, task.part(0.4, 0.7))):
        pull = Pull(metric, ends, kept, Allowance(WORK))
        chains = filled(chains, guide, pull.linked, part.part(0, 0.2))
        if len(chains) > 1:
            narrower = Repair(guide, pull).narrowed(chains, part.part(0.2, 1))
            way = way if len(narrower) == len(chains) else Way.REPAIRED
            chains = narrower
        if len(chains) == 1 and proven(chains[0], part.part(1, 1)):
            return chains[0], way
    return _by_convex_combination(decomposition, metric, task.part(0.8, 1)), Way.CONVEX


def _by_convex_combination(decomposition: Decomposition, metric: Metric, task: Task) -> Chain:
    """Take the frames of a morph that never crosses itself, so densely that all links are safe."""
    pair = decomposition.pair
    morph = convex_combination_of(surroundings_of(decomposition, task.part(0, 0.5)), len(pair))
    ends = Key(0.0, pair.source), Key(1.0, pair.target)
    chains = chains_between(*ends, morph.frames, safe, task.part(0.5, 0.8))
    if len(chains) == 1:
        return chains[0]
    pull = Pull(metric, (as_complex(pair.source), as_complex(pair.target)), None, Allowance(WORK))
    chains = Repair(morph.frames, pull).narrowed(chains, task.part(0.8, 1))
    if len(chains) > 1 or not proven(chains[0], task.part(1, 1)):
        raise StarskelError(
            told("no blend without crossings was found: a shape is all but as narrow as rounding"),
            told("widen its narrowest parts, or add marks"),
        )
    return chains[0]
