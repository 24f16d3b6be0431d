"""What is asked of the worker, and what comes back."""

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from app.model.document import Point
from app.model.marks import Marks
from app.model.sequence import Sequence
from starskel.blending import STEERED
from starskel.polygon import Polygon
from starskel.predicates import Floats

if TYPE_CHECKING:  # what blends is loaded by the worker, so that the window opens sooner
    from starskel import Blend, Report


@dataclass(frozen=True)
class Subject:
    """What is to be blended.

    Attributes
    ----------
    source, target : Polygon
        The shapes.
    marks : tuple of (int, int)
        What corresponds.
    root : (float, float) or None
        The star origin of the source nearest to this place is to be the star-skeleton's root.
    turns : int
        Whole turns that the star-skeleton makes besides.
    """

    source: Polygon
    target: Polygon
    marks: Marks = ()
    root: Point | None = None
    turns: int = 0

    def of(self, method: str) -> "Subject":
        """Leave out what makes no difference to a method."""
        return self if method == STEERED else replace(self, root=None, turns=0)


def subjects_of(sequence: Sequence) -> tuple[Subject | None, ...]:
    """Give what is to be blended in each step, None where a shape is missing."""
    return tuple(
        None
        if source is None or target is None
        else Subject(source, target, step.marks, step.root, step.turns)
        for (source, target), step in zip(pairwise(sequence.shapes), sequence.steps, strict=True)
    )


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
    settled : bool
        Whether no better one will follow.
    """

    method: str
    blend: "Blend"
    report: "Report"
    samples: Floats
    settled: bool = True

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
    def settled(self) -> bool:
        """Whether no better result is to be expected."""
        return self.result is None or self.result.settled

    @property
    def fresh(self) -> Result | None:
        """The result, where it belongs to the shapes as they are now."""
        return None if self.stale else self.result

    def outdated(self) -> "MethodState":
        """Mark it stale; the last good blend stays."""
        return replace(self, error=None, stale=True)

    def after(self, outcome: Result | Failure, *, stale: bool = False) -> "MethodState":
        """Take in what the worker delivered, which may have been overtaken by the next change."""
        if isinstance(outcome, Result):
            return MethodState(outcome, stale=stale)
        return replace(self, error=outcome.error)
