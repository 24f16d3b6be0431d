"""From source to target: by the wanted frames where they are simple, by the least repair elsewhere."""

from enum import StrEnum
from itertools import pairwise

from starskel.blending.certified.energies.energy import Field
from starskel.blending.certified.energies.metric import metric_of
from starskel.blending.certified.energies.room import KEPT, Room
from starskel.blending.certified.gaps import narrowed
from starskel.blending.certified.keys import Chain, Guide, Key, extent, filled
from starskel.blending.certified.morphing.morph import MARGINS as MORPHED_MARGINS
from starskel.blending.certified.morphing.morph import Morphing
from starskel.blending.certified.relaxing import Relaxing
from starskel.blending.certified.repair import MARGINS, Following
from starskel.blending.certified.tracking import Allowance, Pull
from starskel.certificate import safe
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError, told
from starskel.polar import as_complex
from starskel.task import Task

WORK, MORE_WORK = 330_000, 140_000
"""What following may cost with room kept, and then without, before morphing; in vertices of frames."""

AMPLE_ROOM = 5e-3
"""Repairs are widened where they keep less room than this, as a part of the size."""


class Way(StrEnum):
    """How a certified blend came about."""

    AS_IT_IS = "as stitched"
    REPAIRED = "repaired"
    CONVEX = "convex morph"


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
    source, target = decomposition.pair.source, decomposition.pair.target
    ends, size = (as_complex(source), as_complex(target)), extent(source, target)
    chains, way, field = [[Key(0.0, source)], [Key(1.0, target)]], Way.AS_IT_IS, None
    resisted: set[tuple[float, float]] = set()
    roomy = Room.of(ends, KEPT * size)
    for room, work, part in (
        (roomy, WORK, task.part(0.05, 0.3)),
        (None, MORE_WORK, task.part(0.3, 0.55)),
    ):
        chains = filled(chains, guide, room.links if room else safe, part.part(0, 0.2))
        if len(chains) > 1:
            field = field or Field.of(metric_of(decomposition, size, part.part(0.2, 0.2)), ends)
            pull = Pull(field, room, Allowance(work))
            narrower = narrowed(chains, Following(guide, pull), MARGINS, part.part(0.2, 1), resisted)
            way = way if len(narrower) == len(chains) else Way.REPAIRED
            chains = narrower
        if len(chains) == 1 and proven(chains[0], part.part(1, 1)):
            break
    else:
        way = Way.CONVEX
        field = field or Field.of(metric_of(decomposition, size, task.part(0.55, 0.55)), ends)
        morphing = Morphing(decomposition, guide, field, roomy)
        chains = narrowed(chains, morphing, MORPHED_MARGINS, task.part(0.55, 0.9))
    keys = chains[0]
    if field and way is Way.REPAIRED and len(chains) == 1:  # where only a morph leads, nothing widens
        ample = Room.of(ends, AMPLE_ROOM * size)
        keys = Relaxing(guide, field, ample, ample)(keys, task.part(0.9, 1))
    if len(chains) > 1 or not proven(keys, task.part(1, 1)):
        raise StarskelError(
            told("no blend without crossings was found: a shape is all but as narrow as rounding"),
            told("widen its narrowest parts, or add marks"),
        )
    return keys, way


def proven(keys: Chain, task: Task) -> bool:
    """Tell whether all links are safe: the one certificate, whatever led to these keys."""
    for before, after in pairwise(keys):
        task.reach(0)
        if not safe(before.frame, after.frame):
            return False
    return True
