"""Following the frames that are wanted as far as that is possible without touching.

From one end of a stretch of time, a frame is pulled towards the wanted frame of one moment after the other,
and pushed apart where it comes near to itself: a few Gauss-Newton steps for each moment. Every step that is
taken is a safe link.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from starskel.arrays import Floats
from starskel.blending.certified.energies.energy import Field
from starskel.blending.certified.energies.room import Room
from starskel.blending.certified.keys import Linked, farthest
from starskel.blending.certified.tracked_frames import TrackedFrames
from starskel.certificate import safe
from starskel.task import Task

PUSH = 1e-3
"""The weight of the energy that keeps pairs apart beside the strain."""

STEPS = 4
"""The most steps for one moment."""

SETTLED = 1e-3
"""A step shorter than this part of the size, at every vertex, ends a moment."""

LAID_OUT = 1000
"""What a step costs besides its vertices, in vertices."""


@dataclass
class Allowance:
    """Work that may still be done: counted, as time would make the outcome depend on the machine.

    Attributes
    ----------
    left : int
        Steps, each as many as its vertices and `LAID_OUT`.
    """

    left: int

    def take(self, n: int) -> bool:
        """Take what a step of n vertices costs; tell whether there was so much."""
        self.left -= n + LAID_OUT
        return self.left >= 0


@dataclass(frozen=True, eq=False)
class Pull:
    """What moves frames.

    Attributes
    ----------
    field : Field
    room : Room, optional
        What is to be kept; without, steps are to be safe, no more.
    allowance : Allowance
        What all tracks together may cost; without, they stay where they are.
    """

    field: Field
    room: Room | None
    allowance: Allowance

    @property
    def linked(self) -> Linked:
        """What is asked of every step."""
        return self.room.links if self.room else safe

    def track(self, wanted: Floats, task: Task) -> TrackedFrames:
        """Follow (k, n, 2) frames from the first on, until it is stuck: then it stays there."""
        frames, arrivals = [wanted[0]], [0]
        for at, goal in enumerate(wanted[1:]):
            steps = self._towards(frames[-1], goal, task.part(at / len(wanted), 1))
            if not steps and not self._is_there(frames[-1], goal):
                break
            frames += steps
            arrivals.append(len(frames) - 1)
        arrivals += [arrivals[-1]] * (len(wanted) - len(arrivals))
        return TrackedFrames(frames, np.array(arrivals))

    def meeting(self, *frames: Floats) -> "Pull":
        """Give the same where nothing pushes in these frames, either."""
        return replace(self, field=self.field.meeting(*frames))

    def _is_there(self, now: Floats, goal: Floats) -> bool:
        return farthest(goal - now) < SETTLED * self.field.metric.size

    def _towards(self, now: Floats, goal: Floats, task: Task) -> list[Floats]:
        """Give frames ever nearer to a goal; room is given up where there is no other way."""
        steps = list(self._steps(now, goal, self.room, task))
        return steps or (list(self._steps(now, goal, None, task)) if self.room else [])

    def _steps(self, now: Floats, goal: Floats, room: Room | None, task: Task) -> Iterator[Floats]:
        """Give frames ever nearer to a goal, or as near as the barrier and the allowance let them."""
        if self.allowance.left <= 0:
            return
        energy, linked = self.field.energy(now, goal, PUSH, room), room.links if room else safe
        for _ in range(STEPS):
            if not self.allowance.take(len(now)):
                return
            after = energy.lessened(now, 1, partial(linked, now), task)
            if after is None:
                return
            moved = farthest(after - now)
            now = after
            yield now
            if moved < SETTLED * self.field.metric.size:
                return
