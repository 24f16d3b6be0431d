"""Keys of an animation: as few moments as will do, so that everything moves evenly and straight between them.

Between two keys formats move every vertex evenly on a straight line. A stretch is cut at the moment where a
vertex strays farthest, until none strays farther than the tolerance (Douglas and Peucker 1973, over time).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from starskel.arrays import Floats
from starskel.errors import StarskelError, told
from starskel.export.animation import Animation, Shot
from starskel.export.film import Film
from starskel.sheet.drawing import Area, Disc, Drawing, Group, Item, Label, Line, channels
from starskel.task import Task

_LOOKS = 129
"""So many moments are looked at first; twice as many, again and again, where a look in between shows more."""

_MOST_LOOKS = 1 << 13

_SHADES = 2.0
"""A colour may stray by so many of its 255 shades."""


@dataclass(frozen=True)
class Stretch:
    """A part of an animation in which the same items move.

    Attributes
    ----------
    times : (k,) tuple of float
        When the keys are, as shares of the whole animation; it is seen from the first to the last of them.
    drawings : (k,) tuple of Drawing
        The keys, all of the same items.
    """

    times: tuple[float, ...]
    drawings: tuple[Drawing, ...]

    @property
    def start(self) -> float:
        """When it begins."""
        return self.times[0]

    @property
    def end(self) -> float:
        """When it ends."""
        return self.times[-1]


def stretches(film: Film, task: Task) -> tuple[Stretch, ...]:
    """Give the parts of an animation one after another; one that returns comes back through all."""
    there, shots = [], Animation(film).shots
    for number, shot in enumerate(shots):
        shares, drawings = keys(shot, task.part(number / len(shots), (number + 1) / len(shots)))
        times = [shot.start + share * (shot.end - shot.start) for share in shares]
        there.append(Stretch(tuple(times), drawings))
    if not film.settings.returning:
        return tuple(there)
    out = [replace(stretch, times=tuple(t / 2 for t in stretch.times)) for stretch in there]
    *back, turn = [
        Stretch(tuple(1 - t for t in reversed(stretch.times)), stretch.drawings[::-1]) for stretch in out
    ]
    last = Stretch(out[-1].times + turn.times[1:], out[-1].drawings + turn.drawings[1:])
    return (*out[:-1], last, *reversed(back))


def keys(shot: Shot, task: Task) -> tuple[list[float], tuple[Drawing, ...]]:
    """Give the keys of a part of an animation: their shares of its time, from 0 to 1, and what is drawn then.

    Raises
    ------
    StarskelError
        If something jumps, so that no number of keys keeps the tolerance.
    Cancelled
        If the task is to stop.
    """
    tolerance = shot.animation.film.settings.tolerance * shot.animation.stage.longer_side
    looks = _LOOKS
    times, drawings, paths = _looked_at(shot, looks, tolerance)
    while True:
        task.reach(0)
        chosen = list(_chosen(times, paths, tolerance))
        finer = _looked_at(shot, 2 * looks - 1, tolerance)
        if _strays(finer[0], finer[2], [2 * k for k in chosen]).max() <= tolerance:
            return [float(times[k]) for k in chosen], tuple(drawings[k] for k in chosen)
        if looks > _MOST_LOOKS:
            raise StarskelError(told("the blend jumps"), told("take a larger tolerance, or another method"))
        times, drawings, paths = finer
        looks = 2 * looks - 1


def _looked_at(shot: Shot, count: int, tolerance: float) -> tuple[Floats, tuple[Drawing, ...], Floats]:
    times = np.linspace(0, 1, count)
    drawings = shot.drawings(times.tolist())
    return times, drawings, np.array([_places(drawing, tolerance) for drawing in drawings])


def _places(drawing: Drawing, tolerance: float) -> Floats:
    """Give all that moves as (k, 2) points; colours as points that may stray as far as the tolerance."""
    return np.concatenate([np.empty((0, 2)), *_points(drawing.items, tolerance)])


def _points(items: Sequence[Item], tolerance: float) -> Iterator[Floats]:
    for item in items:
        match item:
            case Group(_, inner):
                yield from _points(inner, tolerance)
            case Area(ring, fill, _, holes):
                yield from (ring, *holes)
                if fill is not None:
                    yield np.array([[shade, 0.0] for shade in channels(fill)]) * (tolerance / _SHADES)
            case Line(points, _):
                yield points
            case Disc(centre):
                yield np.array([centre])
            case Label():
                yield np.array([item.place])


def _chosen(times: Floats, paths: Floats, tolerance: float) -> Iterator[int]:
    """Give the numbers of moments to be keys, in order."""
    yield 0
    pending = [(0, len(times) - 1)]
    while pending:
        first, last = pending.pop()
        strays = _strays(times[first : last + 1], paths[first : last + 1], [0, last - first])
        worst = int(strays.argmax())
        if strays[worst] <= tolerance:
            yield last
        else:
            pending += [(first + worst, last), (first, first + worst)]


def _strays(times: Floats, paths: Floats, chosen: Sequence[int]) -> Floats:
    """Give how far some point is, at each of the times, from where it would be between the chosen keys."""
    own = np.asarray(chosen)
    before = np.clip(np.searchsorted(own, np.arange(len(times)), side="right") - 1, 0, len(own) - 2)
    first, last = own[before], own[before + 1]
    share = ((times - times[first]) / (times[last] - times[first]))[:, None, None]
    away = paths - (1 - share) * paths[first] - share * paths[last]
    return np.asarray(np.hypot(away[..., 0], away[..., 1]).max(axis=1, initial=0.0))
