"""What can be known for every t, not only for the frames looked at."""

from starskel.arrays import Floats
from starskel.blending.frames import Blend
from starskel.certificate import first_unsafe, safe
from starskel.crossings import crossing_edges, crossing_places
from starskel.quality.layers import in_layers
from starskel.quality.report import Crossing
from starskel.task import Task

_BISECTIONS = 40
"""How often the stretch is halved in which an even motion meets itself first."""


def proof(blend: Blend, task: Task) -> tuple[bool, Crossing | None]:
    """Decide a blend that crosses itself in none of the frames looked at.

    Returns
    -------
    Whether it is decided for every t, and where the outline first meets itself; None where it never does.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    if blend.key_times is None:
        return False, None
    task.reach(0)
    keys = blend.frames(blend.key_times)
    link = first_unsafe(keys)
    if link is None:
        return True, None
    start, end = blend.key_times[link : link + 2].tolist()
    return True, _first_meeting(keys[link], keys[link + 1], start, end, task)


def _first_meeting(before: Floats, after: Floats, start: float, end: float, task: Task) -> Crossing:
    """Find the moment by bisection; where a frame soon after it crosses itself, that one shows the place."""
    low, high = 0.0, 1.0
    for _ in range(_BISECTIONS):
        task.reach(0)
        middle = (low + high) / 2
        frame = (1 - middle) * before + middle * after
        if safe(before, frame):
            low = middle
        else:
            high = middle
            if len(crossing_edges(frame)):
                break
    frame = (1 - high) * before + high * after
    return Crossing((1 - high) * start + high * end, None, crossing_places(frame), in_layers(frame, task))
