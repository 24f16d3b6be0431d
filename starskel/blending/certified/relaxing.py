"""Relaxing keys: pulled towards the frames that are wanted, and apart where there is little room."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.arrays import Floats
from starskel.blending.certified.energies.energy import Field
from starskel.blending.certified.energies.room import Room
from starskel.blending.certified.keys import Chain, Guide, Key, Linked, frames_at
from starskel.blending.certified.tracking import Allowance
from starskel.certificate import safe
from starskel.polar import as_complex, as_points
from starskel.task import Task

PUSH = 0.3
"""The weight of the energy that keeps pairs apart beside the strain."""

SWEEPS = 3
"""How often all keys are moved, at most."""

SHARES = (1.0, 0.5, 0.2, 0.1, 0.01, 1e-3)
"""Shares of the room that links may keep."""

WORK = 330_000
"""What moving keys may cost, as following does; in vertices of frames."""

CAREFUL = 0.5
"""The part of a step that is taken: the keys on both sides have to follow."""


@dataclass(frozen=True, eq=False)
class Relaxing:
    """Moves inner keys, so that links stay safe and, where they keep room, keep it.

    Attributes
    ----------
    guide : Guide
        The frames to come near to.
    field : Field
    room : Room
        What links are to keep that do so already; others keep a smaller share of it, if they do.
    ample : Room, optional
        Keys between two links that keep so much stay where they are.
    turning : bool
        Whether only the shape of the guide's frames counts: parts may be turned as they are in the keys.
    """

    guide: Guide
    field: Field
    room: Room
    ample: Room | None = None
    turning: bool = False

    def __call__(self, keys: Chain, task: Task) -> Chain:
        """Give better keys, at the same times; those given have safe links."""
        frames, times = [key.frame for key in keys], np.array([key.t for key in keys])
        goals = frames_at(times, self.guide, len(frames[0]), task)
        asked = [self._asked(*link, task) for link in pairwise(frames)]
        enough, allowance = _keep(frames, self.ample, task), Allowance(WORK)
        for sweep in range(SWEEPS):
            for first in (1, 2):  # every other key, so that it does not matter where the sweep begins
                for k in range(first, len(keys) - 1, 2):
                    part = task.part(sweep / SWEEPS, 1)
                    part.reach(0)
                    if (enough[k - 1] and enough[k]) or not allowance.take(len(goals[k])):
                        continue
                    around, links = frames[k - 1 : k + 2], slice(k - 1, k + 1)
                    frames[k] = self._better(around, asked[links], goals[k], part)
                    if frames[k] is not around[1]:
                        enough[links] = _keep(frames[k - 1 : k + 2], self.ample, part)
        return [Key(key.t, frame) for key, frame in zip(keys, frames, strict=True)]

    def _asked(self, before: Floats, after: Floats, task: Task) -> Linked:
        """Give what is asked of a link: the room, or as small a part of it as it keeps."""
        for share in SHARES:
            task.quiet.reach(0)
            room = self.room.part(share)
            if room.links(before, after):
                return room.links
        return safe

    def _better(self, around: list[Floats], asked: Sequence[Linked], goal: Floats, task: Task) -> Floats:
        """Give a better frame for the middle one of three, or the same."""
        before, now, after = around

        def accepted(there: Floats) -> bool:
            return asked[0](before, there) and asked[1](there, after)

        if self.turning:
            goal = as_points(self.field.metric.turned(as_complex(goal), as_complex(now)))
        there = self.field.energy(now, goal, PUSH, None).lessened(now, CAREFUL, accepted, task)
        return now if there is None else there


def _keep(frames: list[Floats], room: Room | None, task: Task) -> list[bool]:
    """Tell for each link whether it keeps some room; none does where none is named."""
    answers = []
    for before, after in pairwise(frames):
        task.quiet.reach(0)
        answers.append(room is not None and room.links(before, after))
    return answers
