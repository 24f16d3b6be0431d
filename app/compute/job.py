"""A request being worked off: what its methods share is computed once."""

import traceback
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.compute.request import Failure, Request, Result
from starskel import Blend, Correspondence, Decomposition, blend, match, measure
from starskel.errors import Cancelled, StarskelError
from starskel.predicates import Floats
from starskel.task import ShouldStop

AT_ONCE = 1 << 15
"""So many points of frames are computed between two questions whether to stop."""

SAMPLES = np.linspace(0, 1, 21)
"""The moments that count for the box of a blend."""


class Job:
    """Blends and measures, method by method.

    Parameters
    ----------
    request : Request
    is_old : callable
        Answers True where a newer request has come.
    report : callable
        Called with the method under way and the fraction of the request that is done.
    """

    def __init__(self, request: Request, is_old: ShouldStop, report: Callable[[str, float], None]) -> None:
        self._request = request
        self._is_old = is_old
        self._say = report
        self._pair: Correspondence | None = None
        self._decomposition: Decomposition | None = None
        self._percent = -1

    def outcome(self, method: str) -> Result | Failure:
        """Blend by one method, and measure.

        Raises
        ------
        Cancelled
            If a newer request has come.
        """
        try:
            self._report(method, 0.0)
            made = self._blend(method)
            self._report(method, 1.0)
            watched = Watched(made, self._go_on)
            return Result(method, made, measure(watched), _box(watched))
        except Cancelled:
            raise
        except Exception as error:  # whatever it is, the window shows it; the thread lives on
            if not isinstance(error, StarskelError):
                traceback.print_exception(error)
            return Failure(method, error)

    def _blend(self, method: str) -> Blend:
        if self._pair is None:
            subject = self._request.subject
            self._pair = match(subject.source, subject.target, subject.marks, should_stop=self._is_old)
        made = blend(
            self._pair,
            method=method,
            decomposition=self._decomposition,
            progress=partial(self._report, method),
            should_stop=self._is_old,
        )
        self._decomposition = made.decomposition or self._decomposition
        return made

    def _go_on(self) -> None:
        if self._is_old():
            raise Cancelled

    def _report(self, method: str, fraction: float) -> None:
        """Report whole percents of the request; the library may call far more often."""
        self._go_on()
        methods = self._request.methods
        percent = int(100 * (methods.index(method) + fraction) / len(methods))
        if percent != self._percent:
            self._percent = percent
            self._say(method, percent / 100)


class Watched(Blend):
    """A blend whose frames come a few at a time, so that whoever measures it can be stopped.

    `go_on` is called between them and raises where it should not go on.
    """

    def __init__(self, whole: Blend, go_on: Callable[[], None]) -> None:
        super().__init__(whole.pair)
        self._whole = whole
        self._go_on = go_on

    def negative_lengths(self, ts: ArrayLike) -> NDArray[np.bool_]:
        return self._whole.negative_lengths(ts)

    def _frames(self, ts: Floats) -> Floats:
        step = max(1, AT_ONCE // len(self.pair))
        return np.concatenate([self._some(ts[k : k + step]) for k in range(0, len(ts), step)])

    def _some(self, ts: Floats) -> Floats:
        self._go_on()
        return self._whole.frames(ts)


def _box(blended: Blend) -> Floats:
    points = blended.frames(SAMPLES).reshape(-1, 2)
    return np.array([points.min(axis=0), points.max(axis=0)])
