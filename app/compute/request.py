"""What is asked of the worker, and what comes back."""

from dataclasses import dataclass, replace

import numpy as np

from app.model.marks import Marks
from starskel import Blend, Report
from starskel.polygon import Polygon
from starskel.predicates import Floats


@dataclass(frozen=True)
class Subject:
    """What is to be blended.

    Attributes
    ----------
    source, target : Polygon
        The shapes.
    marks : tuple of (int, int)
        What corresponds.
    """

    source: Polygon
    target: Polygon
    marks: Marks = ()


@dataclass(frozen=True)
class Request:
    """What is to be blended, and how.

    Attributes
    ----------
    subject : Subject
        The shapes, and what corresponds.
    methods : tuple of str
        The methods, in the order in which they are wanted.
    live : bool
        Whether it shows a gesture under way, so that a newer one will follow soon.
    generation : int
        Grows from request to request.
    """

    subject: Subject
    methods: tuple[str, ...]
    live: bool = False
    generation: int = 0


@dataclass(frozen=True)
class Proposal:
    """A wish for suggested marks, at most so many."""

    source: Polygon
    target: Polygon
    count: int
    generation: int = 0


@dataclass(frozen=True, eq=False)
class Result:
    """A blend and what was measured of it.

    Attributes
    ----------
    method : str
    blend : Blend
    report : Report
    samples : (k, n, 2) array
        Frames evenly spread over [0, 1].
    """

    method: str
    blend: Blend
    report: Report
    samples: Floats

    @property
    def box(self) -> Floats:
        """The lower left and the upper right corner of all frames, (2, 2)."""
        return np.array([self.samples.min(axis=(0, 1)), self.samples.max(axis=(0, 1))])


@dataclass(frozen=True, eq=False)
class Failure:
    """Why there is no blend by this method."""

    method: str
    error: Exception


@dataclass(frozen=True, eq=False)
class MethodState:
    """What there is to show of one method.

    Attributes
    ----------
    result : Result or None
        The last good one.
    error : Exception or None
        Why there is no newer one.
    stale : bool
        Whether it belongs to shapes that have changed since.
    """

    result: Result | None = None
    error: Exception | None = None
    stale: bool = True

    @property
    def wanted(self) -> bool:
        """Whether it is worth computing: what failed would fail again."""
        return self.stale and self.error is None

    def outdated(self) -> "MethodState":
        """Mark it stale; the last good blend stays."""
        return replace(self, error=None, stale=True)

    def after(self, outcome: Result | Failure, *, stale: bool = False) -> "MethodState":
        """Take in what the worker delivered, which may have been overtaken by the next change."""
        if isinstance(outcome, Result):
            return MethodState(outcome, stale=stale)
        return replace(self, error=outcome.error)
