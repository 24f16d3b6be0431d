"""Keyframes and the links between them; where the links of a blend are safe, and where they are not."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.outline import cross_themselves
from starskel.predicates import Floats
from starskel.task import Task

Guide = Callable[[Floats], Floats]
"""Gives the (k, n, 2) frames that are wanted at k times, if only they were simple."""

Linked = Callable[[Floats, Floats], bool]
"""Tells whether the even motion from one frame to another is good enough."""

LINKS = (32, 64, 128)
"""Numbers of links that are tried in turn, until the motion between the frames is even enough."""

EVEN = 2e-4
"""Frames half-way between keys differ by less from the guide's, at every vertex, as a part of the size."""

BISECTIONS = 6
"""How often a link that is not safe is halved before it counts as a gap."""


@dataclass(frozen=True, eq=False)
class Key:
    """A frame and its time."""

    t: float
    frame: Floats


Chain = list[Key]
"""Keys in the order of time, linked by even motions."""


def chains_of(source: Floats, target: Floats, guide: Guide, linked: Linked, task: Task) -> list[Chain]:
    """Give a guide's frames as chains of good links; there are gaps between one chain and the next.

    The first chain begins with the source and the last ends with the target, to the bit.
    """
    times, wanted = _even(guide)
    frames = [source, *wanted[1:-1], target]
    keys = [Key(float(t), frame) for t, frame in zip(times, frames, strict=True)]
    good = ~cross_themselves(np.stack(frames))
    for at in np.flatnonzero(good):
        task.reach(0)
        good[at] = linked(frames[at], frames[at])
    good[[0, -1]] = True  # polygons are simple, whatever rounding makes of vertices inserted on their edges
    chains = [[keys[0]]]
    for before, after in pairwise(np.flatnonzero(good)):
        search = _Search(guide, linked, task.part(keys[before].t, 1))
        pieces = [[keys[before]], [keys[after]]]
        _append(
            chains, pieces if after - before > 1 else search.chains(keys[before], keys[after], BISECTIONS)
        )
    return chains


def _even(guide: Guide) -> tuple[Floats, Floats]:
    """Give times so dense that a guide's frames move evenly between them, all but; and these frames."""
    for links in LINKS:
        times = np.linspace(0, 1, 2 * links + 1)
        frames = guide(times)
        off = farthest((frames[:-1:2] + frames[2::2]) / 2 - frames[1::2])
        if off < EVEN * 2 * farthest(frames[0] - frames[0].mean(axis=0)):
            break
    return times[::2], frames[::2]


def farthest(vectors: Floats) -> float:
    """Give the length of the longest of (..., 2) vectors."""
    return float(np.hypot(vectors[..., 0], vectors[..., 1]).max())


def _append(chains: list[Chain], found: list[Chain]) -> None:
    """Add chains that begin with the key at which the chains so far end."""
    chains[-1] += found[0][1:]
    chains += found[1:]


@dataclass(frozen=True)
class _Search:
    """Linking keys of a guide, by frames between them where that is needed and helps."""

    guide: Guide
    linked: Linked
    task: Task

    def chains(self, before: Key, after: Key, bisections: int) -> list[Chain]:
        self.task.reach(0)
        if self.linked(before.frame, after.frame):
            return [[before, after]]
        t = (before.t + after.t) / 2
        frame = self.guide(np.array([t]))
        if not bisections or cross_themselves(frame)[0] or not self.linked(frame[0], frame[0]):
            return [[before], [after]]
        middle = Key(t, frame[0])
        chains = self.chains(before, middle, bisections - 1)
        _append(chains, self.chains(middle, after, bisections - 1))
        return chains


def between(times: Floats, frames: Floats, ts: Floats) -> Floats:
    """Interpolate (m, n, 2) keyframes at rising times; at a key's time it is the key itself, to the bit."""
    before = np.clip(np.searchsorted(times, ts, side="right") - 1, 0, len(times) - 2)
    share = ((ts - times[before]) / (times[before + 1] - times[before]))[:, None, None]
    start, end = frames[before], frames[before + 1]
    near_end = share > 0.5
    moved = np.where(near_end, end - (1 - share) * (end - start), start + share * (end - start))
    return np.asarray(moved)
