"""A request being worked off: what its methods share is computed once."""

import logging
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from time import monotonic

import numpy as np

from app.compute.request import Failure, Request, Result
from app.model.point import Point
from starskel import (
    Blend,
    Correspondence,
    Decomposition,
    Shape,
    ShapeBlend,
    ShapeCorrespondence,
    blend,
    decompose,
    match,
    measure,
)
from starskel.errors import Cancelled, StarskelError
from starskel.files.projects.step import Step
from starskel.task import ShouldStop

SAMPLES = np.linspace(0, 1, 41)
"""The moments of the frames that a result keeps."""

QUIET = 0.1
"""Seconds without a report of progress, at first and between two: for each the window paints at once."""


class BlendJob:
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
        self._shape_pair: ShapeCorrespondence | None = None
        self._decomposition: Decomposition | None = None
        self._unsettled: list[Result] = []
        self._percent, self._said = -1, monotonic()

    def outcome(self, method: str) -> Result | Failure:
        """Blend by one method as soon as can be, and measure.

        Raises
        ------
        Cancelled
            If a newer request has come.
        """
        try:
            make = self._blend if self._request.subject.single else self._blend_shapes
            result = self._measured(method, make(method, self._request.methods.index(method)))
        except Cancelled:
            raise
        except Exception as error:  # whatever it is, the window shows it; the thread lives on
            return _failure(method, error)
        if not result.settled:
            self._unsettled.append(result)
        return result

    def improvements(self) -> Iterator[Result | Failure]:
        """Give ever better blends by the methods that did not settle at once; of each the last is settled.

        Raises
        ------
        Cancelled
            If a newer request has come.
        """
        for step, result in enumerate(self._unsettled):
            yield from self._improved(result, len(self._request.methods) + step)

    def _improved(self, result: Result, step: int) -> Iterator[Result | Failure]:
        progress = partial(self._report, result.method, step)
        try:
            for made in result.blend.improvements(progress=progress, should_stop=self._is_old):
                result = self._measured(result.method, made, result)
                yield result
        except Cancelled:
            raise
        except Exception as error:  # as above
            yield _failure(result.method, error)

    def _measured(self, method: str, made: Blend | ShapeBlend, before: Result | None = None) -> Result:
        """Measure a blend, unless it only settles what was measured before."""
        samples = tuple(made.rings(SAMPLES))
        if before is not None and all(map(np.array_equal, samples, before.samples)):
            return replace(before, blend=made)
        return Result(method, made, measure(made, should_stop=self._is_old), samples)

    def _blend(self, method: str, step: int) -> Blend:
        self._report(method, step, 0.0)
        subject = self._request.subject.of(method)
        root = subject.links[0].root
        made = blend(
            self._matched(),
            method=method,
            decomposition=self._decomposition,
            root=None if root is None else self._piece_at(root),
            turns=subject.turns,
            settled=False,
            progress=partial(self._report, method, step),
            should_stop=self._is_old,
        )
        self._decomposition = made.decomposition or self._decomposition
        return made

    def _blend_shapes(self, method: str, step: int) -> ShapeBlend:
        self._report(method, step, 0.0)
        subject = self._request.subject.of(method)
        return blend(
            self._matched_shapes(),
            method=method,
            joined=subject.joined,
            roots=Step(subject.links).roots,
            turns=subject.turns,
            settled=False,
            progress=partial(self._report, method, step),
            should_stop=self._is_old,
        )

    def _matched(self) -> Correspondence:
        if self._pair is None:
            subject = self._request.subject
            (source,), (target,), (link,) = subject.source, subject.target, subject.links
            self._pair = match(source, target, link.marks, should_stop=self._is_old)
        return self._pair

    def _matched_shapes(self) -> ShapeCorrespondence:
        if self._shape_pair is None:
            subject = self._request.subject
            self._shape_pair = match(
                Shape(subject.source),
                Shape(subject.target),
                Step(subject.links).marks_by_part(len(subject.source)),
                pairing=[link.ends for link in subject.links],
                places={link.ends: link.place for link in subject.links if link.place is not None},
                should_stop=self._is_old,
            )
        return self._shape_pair

    def _piece_at(self, place: Point) -> int:
        if self._decomposition is None:
            self._decomposition = decompose(self._matched(), should_stop=self._is_old)
        return self._decomposition.piece_at(place)

    def _report(self, method: str, step: int, fraction: float) -> None:
        """Report whole percents of the request; the library may call far more often.

        Each method is a step, and after a gesture so is the improving of each that did not settle at once.
        """
        if self._is_old():
            raise Cancelled
        steps = len(self._request.methods) + max(1, len(self._unsettled)) * (not self._request.live)
        percent = int(100 * (step + fraction) / steps)
        if percent > self._percent and monotonic() - self._said > QUIET:
            self._percent, self._said = percent, monotonic()
            self._say(method, percent / 100)


def _failure(method: str, error: Exception) -> Failure:
    if not isinstance(error, StarskelError):
        logging.getLogger(__name__).error("blending by %s", method, exc_info=error)
    return Failure(method, error)
