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
    search = _Search(decomposition, guide)
    roomy, plain = task.part(0.05, 0.3), task.part(0.3, 0.55)
    if not (search.follow(search.roomy, WORK, roomy) or search.follow(None, MORE_WORK, plain)):
        search.morph(task.part(0.55, 0.9))
    keys = search.widened(task.part(0.9, 1))
    if len(search.chains) > 1 or not proven(keys, task.part(1, 1)):
        raise StarskelError(
            told("no blend without crossings was found: a shape is all but as narrow as rounding"),
            told("widen its narrowest parts, or add marks"),
        )
    return keys, search.way


class _Search:
    """The chains of safe links that have been found, and how; one that leads all the way is what is sought.

    Attributes
    ----------
    chains : list of Chain
        There are gaps between one and the next.
    way : Way
    roomy : Room
        What is to be kept of the room that source and target have.
    """

    def __init__(self, decomposition: Decomposition, guide: Guide) -> None:
        self._decomposition, self._guide = decomposition, guide
        source, target = decomposition.pair.source, decomposition.pair.target
        self._ends, self._size = (as_complex(source), as_complex(target)), extent(source, target)
        self._field: Field | None = None
        self._resisted: set[tuple[float, float]] = set()
        self.chains: list[Chain] = [[Key(0.0, source)], [Key(1.0, target)]]
        self.way = Way.AS_IT_IS
        self.roomy = Room.of(self._ends, KEPT * self._size)

    def follow(self, room: Room | None, work: int, task: Task) -> bool:
        """Take wanted frames where they are safe, else follow them; tell whether that led all the way."""
        self.chains = filled(self.chains, self._guide, room.links if room else safe, task.part(0, 0.2))
        if len(self.chains) > 1:
            pull = Pull(self._field_of(task.part(0.2, 0.2)), room, Allowance(work))
            following = Following(self._guide, pull)
            narrower = narrowed(self.chains, following, MARGINS, task.part(0.2, 1), self._resisted)
            self.way = self.way if len(narrower) == len(self.chains) else Way.REPAIRED
            self.chains = narrower
        return len(self.chains) == 1 and proven(self.chains[0], task.part(1, 1))

    def morph(self, task: Task) -> None:
        """Bridge what gaps are left by convex combination morphs."""
        self.way = Way.CONVEX
        field = self._field_of(task.part(0, 0))
        morphing = Morphing(self._decomposition, self._guide, field, self.roomy)
        self.chains = narrowed(self.chains, morphing, MORPHED_MARGINS, task)

    def widened(self, task: Task) -> Chain:
        """Give the first chain, widened where it was repaired; where only a morph leads, nothing widens."""
        keys = self.chains[0]
        if self.way is not Way.REPAIRED or len(self.chains) > 1:
            return keys
        ample = Room.of(self._ends, AMPLE_ROOM * self._size)
        return Relaxing(self._guide, self._field_of(task), ample, ample)(keys, task)

    def _field_of(self, task: Task) -> Field:
        """Give what moves frames; it is prepared when it is first needed."""
        if self._field is None:
            metric = metric_of(self._decomposition, self._size, task)
            self._field = Field.of(metric, self._ends)
        return self._field


def proven(keys: Chain, task: Task) -> bool:
    """Tell whether all links are safe: the one certificate, whatever led to these keys."""
    for before, after in pairwise(keys):
        task.reach(0)
        if not safe(before.frame, after.frame):
            return False
    return True
