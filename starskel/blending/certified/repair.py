"""Bridging a gap between safe chains: followed from both sides, met where the way is shortest.

One of the two followers often gets stuck on the wrong side of an obstacle, seldom both.
"""

import numpy as np

from starskel.blending.certified.keys import Chain, Guide, Key, Linked, frames_at
from starskel.blending.certified.tracking import Pull, Track
from starskel.predicates import Floats
from starskel.task import Task

MOMENTS = 64
"""How many moments are followed over the whole time."""

LEAST_MOMENTS = 24
"""The least number of moments over any stretch of it."""

DETOUR = 1.1
"""A way that is longer than that wanted by no more than this factor is not compared with others."""


def bridged(before: Key, after: Key, guide: Guide, pull: Pull, task: Task) -> Chain | None:
    """Give a chain of safe links from one key to another, near a guide's frames; None if none is found."""
    count = max(LEAST_MOMENTS, int(np.ceil(MOMENTS * (after.t - before.t))))
    times = np.linspace(before.t, after.t, count + 1)
    wanted = frames_at(times, guide, len(before.frame), task)
    wanted[0], wanted[-1] = before.frame, after.frame
    ahead = pull.track(wanted, task.part(0, 0.5))
    if ahead.ways[-1] < DETOUR * _way(wanted) and pull.linked(ahead.places[-1], after.frame):
        return _retimed([*ahead.frames, after.frame], times[[*ahead.moments(count), count]])
    back = pull.track(wanted[::-1], task.part(0.5, 1))
    meeting = _meeting(ahead, back, pull.linked, task.part(1, 1))
    if meeting is None:
        return None
    there, rest = ahead.until(meeting), back.until(count - meeting)
    moments = [*times[ahead.moments(meeting)], *times[count - back.moments(count - meeting)[::-1]]]
    return _retimed([*there, *rest[::-1]], np.array(moments))


def _meeting(ahead: Track, back: Track, linked: Linked, task: Task) -> int | None:
    """Give the moment at which changing over makes the way shortest, of those where the link is good."""
    across = [np.sqrt(((f - b) ** 2).mean()) for f, b in zip(ahead.places, back.places[::-1], strict=True)]
    whole = ahead.ways + across + back.ways[::-1]
    for k in np.argsort(whole, kind="stable"):
        task.reach(0)
        if linked(ahead.places[k], back.places[-1 - k]):
            return int(k)
    return None


def _way(frames: Floats) -> float:
    return float(np.sqrt((np.diff(frames, axis=0) ** 2).mean(axis=(1, 2))).sum())


def _retimed(frames: list[Floats], moments: Floats) -> Chain:
    """Time keys half by their moments and half by the way; drop those that stand still."""
    steps = np.sqrt((np.diff(np.stack(frames), axis=0) ** 2).mean(axis=(1, 2)))
    ways = np.concatenate([[0.0], np.cumsum(steps)])
    start, end = moments[0], moments[-1]
    times = (moments + start + (end - start) * ways / ways[-1]) / 2
    times[-1] = end
    moving = np.concatenate([[True], np.diff(times) > 0])
    return [Key(float(times[k]), frames[k]) for k in np.flatnonzero(moving)]
