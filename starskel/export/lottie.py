"""Lottie out: an animation for apps and the web, as JSON (Lottie Animation Community, specification 1.0).

Each stretch of the film is a layer of shapes whose vertices move evenly from key to key. Texts are left out,
since they would need a face that is at hand wherever the file is played.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import msgspec
import numpy as np

from starskel.arrays import Floats
from starskel.export.film import Film
from starskel.export.keys import Stretch, stretches
from starskel.sheet.drawing import Area, Colour, Disc, Group, Item, Line, Stroke, channels
from starskel.task import Task

_VERSION = "5.5.2"
"""The oldest version of players that understands all that is written."""

_EVENLY = {"i": {"x": [1], "y": [1]}, "o": {"x": [0], "y": [0]}}
_STILL = {
    "ty": "tr",
    "p": {"a": 0, "k": [0, 0]},
    "a": {"a": 0, "k": [0, 0]},
    "s": {"a": 0, "k": [100, 100]},
} | {
    "r": {"a": 0, "k": 0},
    "o": {"a": 0, "k": 100},
}


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give the film as one file."""
    parts, wanted = stretches(film, task), film.settings
    frames = wanted.rate * wanted.duration * (2 if wanted.returning else 1)
    first = parts[0].drawings[0]
    document = {
        "v": _VERSION,
        "nm": film.title,
        "fr": wanted.rate,
        "ip": 0,
        "op": _number(frames),
        "w": _number(first.width),
        "h": _number(first.height),
        "ddd": 0,
        "assets": [],
        "layers": [_layer(number, part, frames) for number, part in enumerate(parts, 1)],
    }
    yield msgspec.json.encode(document) + b"\n"


def _layer(number: int, stretch: Stretch, frames: float) -> dict[str, Any]:
    times = [_number(time * frames) for time in stretch.times]
    height = stretch.drawings[0].height
    states = list(zip(*(drawing.items for drawing in stretch.drawings), strict=True))
    still = {name: value for name, value in _STILL.items() if name != "ty"}
    return {
        "ty": 4,
        "nm": f"way {number}",
        "ind": number,
        "ip": times[0],
        "op": times[-1],
        "st": 0,
        "ks": still,
        "shapes": _shapes(states, times, height),
    }


def _shapes(states: Sequence[Sequence[Item]], times: list[float], height: float) -> list[dict[str, Any]]:
    """Give items, each in all its states; what is drawn last comes first here."""
    shapes = (_shape(own, times, height) for own in states)
    return [shape for shape in shapes if shape is not None][::-1]


def _shape(states: Sequence[Any], times: list[float], height: float) -> dict[str, Any] | None:
    match states[0]:
        case Group(name, _):
            inner = list(zip(*(state.items for state in states), strict=True))
            return _group(name, _shapes(inner, times, height))
        case Area(_, _, stroke, holes):
            rings = [
                _ring([(state.ring, *state.holes)[k] for state in states], times, height, closed=True)
                for k in range(1 + len(holes))
            ]
            return _group("area", [*rings, *_paint([state.fill for state in states], stroke, times)])
        case Line(_, stroke):
            path = _ring([state.points for state in states], times, height, closed=False)
            return _group("line", [path, *_paint([None] * len(states), stroke, times)])
        case Disc(_, radius, _, stroke):
            places = [[_number(state.centre[0]), _number(height - state.centre[1])] for state in states]
            size = {"a": 0, "k": [_number(2 * radius)] * 2}
            disc = {"ty": "el", "d": 1, "p": _animated(places, times), "s": size}
            return _group("disc", [disc, *_paint([state.fill for state in states], stroke, times)])
    return None


def _group(name: str, shapes: list[dict[str, Any]]) -> dict[str, Any]:
    return {"ty": "gr", "nm": name, "it": [*shapes, _STILL]}


def _ring(rings: Sequence[Floats], times: list[float], height: float, *, closed: bool) -> dict[str, Any]:
    still = [[0, 0]] * len(rings[0])
    down = [np.column_stack([ring[:, 0], height - ring[:, 1]]).round(6) + 0.0 for ring in rings]
    values = [{"c": closed, "v": points.tolist(), "i": still, "o": still} for points in down]
    return {"ty": "sh", "ks": _animated(values, times)}


def _paint(
    fills: Sequence[Colour | None], stroke: Stroke | None, times: list[float]
) -> Iterator[dict[str, Any]]:
    opaque = {"a": 0, "k": 100}
    if stroke is not None:
        colour, width = {"a": 0, "k": _colour(stroke.colour)}, {"a": 0, "k": _number(stroke.width)}
        yield {"ty": "st", "c": colour, "o": opaque, "w": width, "lc": 2, "lj": 2}
    colours = [_colour(fill) for fill in fills if fill is not None]
    if colours:
        yield {"ty": "fl", "c": _animated(colours, times), "o": opaque, "r": 2}


def _animated(values: Sequence[Any], times: list[float]) -> dict[str, Any]:
    """Give what has these values at the times; what stands still has but one."""
    if all(value == values[0] for value in values):
        return {"a": 0, "k": values[0]}
    wrapped = [value if isinstance(value, list) else [value] for value in values]
    *before, last = zip(times, wrapped, strict=True)
    return {
        "a": 1,
        "k": [{"t": t, "s": value, **_EVENLY} for t, value in before] + [{"t": last[0], "s": last[1]}],
    }


def _colour(colour: Colour) -> list[float]:
    return [_number(channel / 255) for channel in channels(colour)]


def _number(value: float) -> float:
    return round(value, 6) + 0.0
