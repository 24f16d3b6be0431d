"""Keyframes and the links between them; where the links of a blend are safe, and where they are not."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.arrays import Floats
from starskel.outline import cross_themselves
from starskel.task import Task

Guide = Callable[[Floats], Floats]
"""Gives the (k, n, 2) frames that are wanted at k times, if only they were simple."""

Linked = Callable[[Floats, Floats], bool]
"""Tells whether the even motion from one frame to another is good enough."""

Sound = Callable[[Floats], bool]
"""Tells whether a frame is one that may be linked."""

LINKS = (32, 128)
"""The least and the most links: they are halved until the motion between the frames is even enough."""

EVEN = 2e-4
"""Frames half-way between keys differ by less from the guide's, at every vertex, as a part of the size."""

BISECTIONS = 6
"""How often a link that is not safe is halved before it counts as a gap."""

BATCH = 8_000
"""So many vertices of frames are computed before asking again whether to stop."""


@dataclass(frozen=True, eq=False)
class Key:
    """A frame and its time."""

    t: float
    frame: Floats


Chain = list[Key]
"""Keys in the order of time, linked by even motions."""


def is_simple(ring: Floats) -> bool:
    """Tell whether an (n, 2) ring neither crosses nor touches itself."""
    return not cross_themselves(ring[None])[0]


def chains_between(  # noqa: PLR0913, PLR0917 -- the last two are for special cases
    ends: tuple[Key, Key],
    guide: Guide,
    linked: Linked,
    task: Task,
    links: tuple[int, int] = LINKS,
    sound: Sound = is_simple,
) -> list[Chain]:
    """Give a guide's frames as chains of good links; there are gaps between one chain and the next.

    The first chain begins with the first end and the last ends with the other, to the bit.
    """
    start, end = ends
    times, wanted = _even(ends, guide, links, task.part(0, 0.5))
    frames = [start.frame, *wanted[1:-1], end.frame]
    keys = [Key(float(t), frame) for t, frame in zip(times, frames, strict=True)]
    good = []
    for key in keys:
        task.reach(0.5)
        good.append(sound(key.frame) and linked(key.frame, key.frame))
    good[0] = good[-1] = True  # polygons are simple, whatever rounding makes of vertices on their edges
    chains = [[keys[0]]]
    for before, after in pairwise(np.flatnonzero(good)):
        if after - before > 1:
            chains.append([keys[after]])
        else:
            search = _Search(guide, linked, sound, task.part(0.5 + before / len(keys) / 2, 1))
            _append(chains, search.chains(keys[before], keys[after], BISECTIONS))
    return chains


def filled(chains: list[Chain], guide: Guide, linked: Linked, task: Task) -> list[Chain]:
    """Look in the gaps for more of a guide's frames, where less is asked of links than it was."""
    done, share = [chains[0]], 1 / len(chains)
    for at, chain in enumerate(chains[1:]):
        part = task.part(at * share, (at + 1) * share)
        _append(done, chains_between((done[-1][-1], chain[0]), guide, linked, part))
        done[-1] = [*done[-1], *chain[1:]]
    return done


def _even(ends: tuple[Key, Key], guide: Guide, links: tuple[int, int], task: Task) -> tuple[Floats, Floats]:
    """Give times so dense that a guide's frames move evenly between them, all but; and these frames."""
    start, end = ends
    span, size, n = end.t - start.t, extent(start.frame), len(start.frame)
    least, most = (max(1, int(np.ceil(span * number))) for number in links)
    times = np.linspace(start.t, end.t, least + 1)
    frames = frames_at(times, guide, n, task)
    while len(times) <= most:
        halfway = (times[:-1] + times[1:]) / 2
        middle = frames_at(halfway, guide, n, task)
        if farthest((frames[:-1] + frames[1:]) / 2 - middle) < EVEN * size:
            break
        places = np.arange(1, len(times))
        times, frames = np.insert(times, places, halfway), np.insert(frames, places, middle, axis=0)
    return times, frames


def frames_at(times: Floats, guide: Guide, n: int, task: Task) -> Floats:
    """Give a guide's (k, n, 2) frames at k times, not too many at a time."""
    parts, step = [], max(1, BATCH // n)
    for k in range(0, len(times), step):
        task.reach(0)
        parts.append(guide(times[k : k + step]))
    return np.concatenate(parts)


def farthest(vectors: Floats) -> float:
    """Give the length of the longest of (..., 2) vectors."""
    return float(np.hypot(vectors[..., 0], vectors[..., 1]).max())


def extent(*rings: Floats) -> float:
    """Give twice the largest distance of a vertex from the mean of its ring, of several rings."""
    return 2 * max(farthest(ring - ring.mean(axis=0)) for ring in rings)


def _append(chains: list[Chain], found: list[Chain]) -> None:
    """Add chains that begin with the key at which the chains so far end."""
    chains[-1] = [*chains[-1], *found[0][1:]]
    chains += found[1:]


@dataclass(frozen=True)
class _Search:
    """Linking keys of a guide, by frames between them where that is needed and helps.

    Where one of two halves resists, the whole is a gap: to narrow it further costs more than it is worth.
    """

    guide: Guide
    linked: Linked
    sound: Sound
    task: Task

    def chains(self, before: Key, after: Key, bisections: int) -> list[Chain]:
        self.task.reach(0)
        if self.linked(before.frame, after.frame):
            return [[before, after]]
        t = (before.t + after.t) / 2
        frame = self.guide(np.array([t]))[0]
        if not bisections or not self.sound(frame) or not self.linked(frame, frame):
            return [[before], [after]]
        middle = Key(t, frame)
        first = self.chains(before, middle, bisections - 1)
        if len(first) > 1:
            return [[before], [after]]
        rest = self.chains(middle, after, bisections - 1)
        return [[before], [after]] if len(rest) > 1 else [first[0] + rest[0][1:]]


def between(times: Floats, frames: Floats, ts: Floats) -> Floats:
    """Interpolate (m, n, 2) keyframes at rising times; at a key's time it is the key itself, to the bit."""
    before = np.clip(np.searchsorted(times, ts, side="right") - 1, 0, len(times) - 2)
    share = ((ts - times[before]) / (times[before + 1] - times[before]))[:, None, None]
    start, end = frames[before], frames[before + 1]
    near_end = share > 0.5
    moved = np.where(near_end, end - (1 - share) * (end - start), start + share * (end - start))
    return np.asarray(moved)
