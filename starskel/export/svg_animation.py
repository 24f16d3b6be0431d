"""Animated SVG out: a drawing whose items move from key to key by themselves (SMIL), over and over.

What moves is written as values of an attribute at key times, between which browsers move it evenly. A program
that knows no animation shows the first frame.
"""

from collections.abc import Iterator, Sequence

from starskel.export.film import Film
from starskel.export.keys import Stretch, stretches
from starskel.export.svg import Element, document, elements
from starskel.files.decimals import decimal
from starskel.task import Task

_HIDDEN, _VISIBLE = "hidden", "visible"


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give the film as one file."""
    parts = stretches(film, task)
    wanted = film.settings
    seconds = decimal(wanted.duration * (2 if wanted.returning else 1)) + "s"
    inside = [element for part in parts for element in _stretch(part, seconds)]
    yield document(parts[0].drawings[0], inside).encode()


def _stretch(stretch: Stretch, seconds: str) -> Iterator[Element]:
    drawn = [elements(drawing) for drawing in stretch.drawings]
    # before and behind it stands still; there it is hidden
    before, behind = [0.0] * (stretch.start > 0), [1.0] * (stretch.end < 1)
    times = [*before, *stretch.times, *behind]
    frames = [*drawn[:1] * len(before), *drawn, *drawn[-1:] * len(behind)]
    moving = tuple(_moving(states, times, seconds) for states in zip(*frames, strict=True))
    if not (before or behind):
        yield from moving
        return
    seen = (
        [(0.0, _HIDDEN)] * len(before) + [(stretch.start, _VISIBLE)] + [(stretch.end, _HIDDEN)] * len(behind)
    )
    show = _animation(
        "visibility", [word for _, word in seen], [time for time, _ in seen], seconds, "discrete"
    )
    yield Element("g", {"visibility": seen[0][1]}, inner=(show, *moving))


def _moving(states: Sequence[Element], times: Sequence[float], seconds: str) -> Element:
    """Give an element that goes through these states."""
    first = states[0]
    series = {name: [state.attributes[name] for state in states] for name in first.attributes}
    animations = [
        _animation(name, values, times, seconds) for name, values in series.items() if len(set(values)) > 1
    ]
    inner = [_moving(own, times, seconds) for own in zip(*(state.inner for state in states), strict=True)]
    return Element(first.tag, first.attributes, first.text, (*animations, *inner))


def _animation(
    name: str, values: Sequence[str], times: Sequence[float], seconds: str, mode: str = "linear"
) -> Element:
    """Give the way of an attribute; a time in which it only waits is left out."""
    keys = list(zip(times, values, strict=True))
    needed = [
        key
        for k, key in enumerate(keys)
        if mode == "discrete" or not 0 < k < len(keys) - 1 or {keys[k - 1][1], keys[k + 1][1]} != {key[1]}
    ]
    attributes = {
        "attributeName": name,
        "dur": seconds,
        "repeatCount": "indefinite",
        "calcMode": mode,
        "keyTimes": ";".join(decimal(time) for time, _ in needed),
        "values": ";".join(value for _, value in needed),
    }
    return Element("animate", attributes)
