"""Following the frames that are wanted as far as that is possible without touching.

From one end of a stretch of time, a frame is pulled towards the wanted frame of one moment after the other,
and pushed apart where it comes near to itself: a few Gauss-Newton steps for each moment. Every step that is
taken is a safe link.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from starskel.blending.certified.barrier import Barrier
from starskel.blending.certified.energy import Energy
from starskel.blending.certified.keys import Linked, farthest
from starskel.blending.certified.metric import Metric
from starskel.blending.certified.room import Room
from starskel.blending.certified.track import Track
from starskel.certificate import safe
from starskel.polar import as_complex, as_points
from starskel.predicates import Complex, Floats
from starskel.task import Task

Accepted = Callable[[Floats], bool]
"""Tells whether a frame is good to go to."""

STEPS = 4
"""The most steps for one moment."""

HALVINGS = 5
"""How often a step is halved before it counts as stuck."""

SETTLED = 1e-3
"""A step shorter than this part of the size, at every vertex, ends a moment."""

CAREFUL = 0.5
"""The part of a step that is taken where both sides of a frame are linked: its neighbours have to follow."""

LAID_OUT = 100
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
    metric : Metric
    met : tuple of (n,) complex arrays
        Frames where nothing pushes.
    room : Room, optional
        What is to be kept; without, steps are to be safe, no more.
    allowance : Allowance
        What all tracks together may cost; without, they stay where they are.
    """

    metric: Metric
    met: tuple[Complex, ...]
    room: Room | None
    allowance: Allowance

    @property
    def linked(self) -> Linked:
        """What is asked of every step."""
        return self.room.links if self.room else safe

    def track(self, wanted: Floats, task: Task) -> Track:
        """Follow (k, n, 2) frames from the first on."""
        frames, arrivals = [wanted[0]], [0]
        for at, goal in enumerate(wanted[1:]):
            frames += self._towards(frames[-1], goal, task.part(at / len(wanted), 1))
            arrivals.append(len(frames) - 1)
        return Track(frames, np.array(arrivals))

    def between(self, before: Floats, now: Floats, after: Floats, goal: Floats, task: Task) -> Floats:
        """Give a frame nearer to a goal, still well linked to those before and after, if there is one."""
        energy = self._energy(now, goal)
        step = CAREFUL * energy.step(as_complex(now))

        def accepted(there: Floats) -> bool:
            return self.linked(before, there) and self.linked(there, after)

        taken = _taken(now, step, energy, accepted, task)
        return now if taken is None else taken

    def meeting(self, frames: tuple[Complex, ...]) -> "Pull":
        """Give the same where nothing pushes in these frames, either."""
        return replace(self, met=(*self.met, *frames))

    def _towards(self, now: Floats, goal: Floats, task: Task) -> Iterator[Floats]:
        """Give frames ever nearer to a goal, or as near as the barrier and the allowance let them."""
        if self.allowance.left <= 0:
            return
        energy = self._energy(now, goal)
        for _ in range(STEPS):
            if not self.allowance.take(len(now)):
                return
            after = _taken(now, energy.step(as_complex(now)), energy, partial(self.linked, now), task)
            if after is None:
                return
            moved = farthest(after - now)
            now = after
            yield now
            if moved < SETTLED * self.metric.size:
                return

    def _energy(self, now: Floats, goal: Floats) -> Energy:
        barrier = Barrier.near(as_complex(now), self.met, self.metric.size, self.room)
        return Energy(self.metric, barrier, as_complex(goal))


def _taken(now: Floats, step: Complex, energy: Energy, accepted: Accepted, task: Task) -> Floats | None:
    """Give the frame after as much of a step as lessens the energy and is good; None if hardly any is."""
    row = as_complex(now)
    most = energy.of(row)
    for _ in range(HALVINGS):
        task.reach(0)
        there = row + step
        if energy.of(there) < most and accepted(as_points(there)):
            return as_points(there)
        step = step / 2
    return None
