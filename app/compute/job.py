"""A request being worked off: what its methods share is computed once."""

import traceback
from collections.abc import Callable
from functools import partial

import numpy as np

from app.compute.request import Failure, Request, Result
from app.model.document import Point
from starskel import Blend, Correspondence, Decomposition, blend, decompose, match, measure
from starskel.errors import Cancelled, StarskelError
from starskel.task import ShouldStop

SAMPLES = np.linspace(0, 1, 41)
"""The moments of the frames that a result keeps."""


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
            report = measure(made, should_stop=self._is_old)
            return Result(method, made, report, made.frames(SAMPLES))
        except Cancelled:
            raise
        except Exception as error:  # whatever it is, the window shows it; the thread lives on
            if not isinstance(error, StarskelError):
                traceback.print_exception(error)
            return Failure(method, error)

    def _blend(self, method: str) -> Blend:
        motion = self._request.subject.of(method).motion
        made = blend(
            self._matched(),
            method=method,
            decomposition=self._decomposition,
            root=None if motion.root is None else self._piece_at(motion.root),
            turns=motion.turns,
            progress=partial(self._report, method),
            should_stop=self._is_old,
        )
        self._decomposition = made.decomposition or self._decomposition
        return made

    def _matched(self) -> Correspondence:
        if self._pair is None:
            subject = self._request.subject
            self._pair = match(subject.source, subject.target, subject.marks, should_stop=self._is_old)
        return self._pair

    def _piece_at(self, place: Point) -> int:
        if self._decomposition is None:
            self._decomposition = decompose(self._matched(), should_stop=self._is_old)
        ways = self._decomposition.source_origins - place
        return int(np.hypot(*ways.T).argmin())

    def _report(self, method: str, fraction: float) -> None:
        """Report whole percents of the request; the library may call far more often."""
        if self._is_old():
            raise Cancelled
        methods = self._request.methods
        percent = int(100 * (methods.index(method) + fraction) / len(methods))
        if percent != self._percent:
            self._percent = percent
            self._say(method, percent / 100)
