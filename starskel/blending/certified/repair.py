"""Bridging a gap between safe chains: followed from both sides, met where the way is shortest.

One of the two followers often gets stuck on the wrong side of an obstacle, seldom both.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats
from starskel.blending.certified.keys import Chain, Guide, Key, Linked, frames_at
from starskel.blending.certified.smoothing import retimed, smoothed, thinned
from starskel.blending.certified.tracked_frames import TrackedFrames
from starskel.blending.certified.tracking import Pull
from starskel.outline import cross_themselves
from starskel.task import Task

MOMENTS = 64
"""How many moments are followed over the whole time."""

LEAST_MOMENTS = 24
"""The least number of moments over any stretch of it."""

DETOUR = 1.1
"""A way that is longer than that wanted by no more than this factor is not compared with others."""


MARGINS = (1 / 32, 1 / 8, 1 / 3, 1.0)
"""By how much a gap is widened, in time, where it resists as it is; at last it is the whole."""


@dataclass(frozen=True, eq=False)
class Following:
    """Bridges near a guide's frames.

    Attributes
    ----------
    guide : Guide
        The frames to stay near to.
    pull : Pull
        What keeps them simple.
    """

    guide: Guide
    pull: Pull

    def __call__(self, before: Key, after: Key, task: Task) -> Chain | None:
        """Give a chain of good links from one key to another; None if none is found."""
        pull = self.pull.meeting(before.frame, after.frame)
        found = _bridged(before, after, self.guide, pull, task.part(0, 0.9))
        if found is None:
            return None
        few = thinned(found, pull.field.metric.size, pull.linked, task.part(0.9, 0.9))
        return smoothed(few, self.guide, pull.linked, task.part(0.9, 1))


def _bridged(before: Key, after: Key, guide: Guide, pull: Pull, task: Task) -> Chain | None:
    count = max(LEAST_MOMENTS, int(np.ceil(MOMENTS * (after.t - before.t))))
    times = np.linspace(before.t, after.t, count + 1)
    wanted = frames_at(times, guide, len(before.frame), task)
    wanted[0], wanted[-1] = before.frame, after.frame
    ahead = pull.track(wanted, task.part(0, 0.5))
    if ahead.ways[-1] < DETOUR * _way(wanted) and pull.linked(ahead.places[-1], after.frame):
        return retimed([*ahead.frames, after.frame], times[[*ahead.moments(count), count]])
    back = pull.track(wanted[::-1], task.part(0.5, 1))
    meeting = _meeting(ahead, back, pull.linked, task.part(1, 1))
    if meeting is None:
        return None
    there, rest = ahead.until(meeting), back.until(count - meeting)
    moments = [*times[ahead.moments(meeting)], *times[count - back.moments(count - meeting)[::-1]]]
    return retimed([*there, *rest[::-1]], np.array(moments))


def _meeting(ahead: TrackedFrames, back: TrackedFrames, linked: Linked, task: Task) -> int | None:
    """Give the moment at which changing over makes the way shortest, of those where the link is good."""
    here, there = ahead.places, back.places[::-1]
    across = np.sqrt(((here - there) ** 2).mean(axis=(1, 2)))
    whole, halfway = ahead.ways + across + back.ways[::-1], (here + there) / 2
    for k in np.argsort(whole, kind="stable"):
        task.reach(0)
        if not cross_themselves(halfway[k : k + 1])[0] and linked(here[k], there[k]):
            return int(k)
    return None


def _way(frames: Floats) -> float:
    return float(np.sqrt((np.diff(frames, axis=0) ** 2).mean(axis=(1, 2))).sum())
