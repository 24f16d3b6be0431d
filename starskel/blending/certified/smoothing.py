"""Fewer keys, and smoother ones: what jitter the search for safe links has left is taken out, safely.

What is smoothed is by how much keys differ from the frames that are wanted, not the keys themselves, so that
nothing is lost of the wanted motion.
"""

import numpy as np

from starskel.arrays import Floats
from starskel.blending.certified.keys import Chain, Guide, Key, Linked, farthest
from starskel.task import Task

SWEEPS = 4
"""How often all keys are smoothed."""

DEVIATION = 2e-3
"""Keys are left out where the way without them differs by less, at every vertex, as a part of the size."""


def thinned(keys: Chain, size: float, linked: Linked, task: Task) -> Chain:
    """Leave out keys that are not needed, all links still good (Ramer 1972, Douglas and Peucker 1973)."""
    kept, waiting = [keys[0]], [keys]
    while waiting:
        task.reach(0)
        part = waiting.pop()
        worst, deviation = _worst(part)
        if len(part) == 2 or (deviation < DEVIATION * size and linked(part[0].frame, part[-1].frame)):
            kept.append(part[-1])
        else:
            waiting += [part[worst:], part[: worst + 1]]
    return kept


def _worst(keys: Chain) -> tuple[int, float]:
    """Give the inner key that is farthest from the even motion between the ends, and how far it is."""
    if len(keys) < 3:
        return 0, 0.0
    times = np.array([key.t for key in keys])
    shares = ((times - times[0]) / (times[-1] - times[0]))[1:-1, None, None]
    even = (1 - shares) * keys[0].frame + shares * keys[-1].frame
    deviations = [farthest(key.frame - frame) for key, frame in zip(keys[1:-1], even, strict=True)]
    worst = int(np.argmax(deviations))
    return worst + 1, deviations[worst]


def retimed(frames: list[Floats], moments: Floats) -> Chain:
    """Time keys half by their moments and half by the way; drop those that stand still."""
    steps = np.sqrt((np.diff(np.stack(frames), axis=0) ** 2).mean(axis=(1, 2)))
    ways = np.concatenate([[0.0], np.cumsum(steps)])
    start, end = moments[0], moments[-1]
    times = (moments + start + (end - start) * ways / ways[-1]) / 2
    times[-1] = end
    moving = np.concatenate([[True], np.diff(times) > 0])
    return [Key(float(times[k]), frames[k]) for k in np.flatnonzero(moving)]


def smoothed(keys: Chain, guide: Guide, linked: Linked, task: Task) -> Chain:
    """Smooth by how much inner keys differ from the guide's frames; the ends stay."""
    times = np.array([key.t for key in keys])
    frames = np.stack([key.frame for key in keys])
    wanted = guide(times)
    for sweep in range(SWEEPS):
        for first in (1, 2):  # every other key, so that it does not matter where the sweep begins
            for k in range(first, len(keys) - 1, 2):
                task.reach(sweep / SWEEPS)
                share = (times[k] - times[k - 1]) / (times[k + 1] - times[k - 1])
                away = frames[k - 1 : k + 2] - wanted[k - 1 : k + 2]
                there = wanted[k] + (away[1] + (1 - share) * away[0] + share * away[2]) / 2
                if linked(frames[k - 1], there) and linked(there, frames[k + 1]):
                    frames[k] = there
    return [Key(key.t, frame) for key, frame in zip(keys, frames, strict=True)]
