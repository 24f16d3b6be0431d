"""What is asked of the worker, and what comes back."""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from app.model.sequence import Sequence
from starskel.arrays import Floats
from starskel.blending import STEERED
from starskel.files.projects.step import Link
from starskel.polygon import Polygon
from starskel.shapes.shape_blend import ShapeBlend

if TYPE_CHECKING:  # what blends is loaded by the worker, so that the window opens sooner
    from starskel import Blend, Correspondence, Report, ShapeReport


@dataclass(frozen=True)
class Subject:
    """What is to be blended.

    Attributes
    ----------
    source, target : tuples of Polygon
        The parts of the shapes.
    links : tuple of Link
        What becomes of the parts.
    joined : bool
        Whether parts move together.
    turns : int
        Whole turns besides: of the star-skeleton, or of several parts by all methods.
    """

    source: tuple[Polygon, ...]
    target: tuple[Polygon, ...]
    links: tuple[Link, ...]
    joined: bool = True
    turns: int = 0

    @property
    def single(self) -> bool:
        """Whether it is one part that becomes one part, the usual case."""
        return len(self.source) == len(self.target) == 1 and not self.links[0].alone

    @property
    def size(self) -> int:
        """How many vertices it has, of both shapes together."""
        return sum(map(len, (*self.source, *self.target)))

    def of(self, method: str) -> "Subject":
        """Leave out what makes no difference to a method."""
        links = tuple(replace(link, root=None) for link in self.links)
        steered = self if method == STEERED else replace(self, links=links)
        if not self.single:
            return steered
        return replace(steered, joined=True, turns=self.turns if method == STEERED else 0)


def subjects_of(sequence: Sequence) -> tuple[Subject | None, ...]:
    """Give what is to be blended in each step, None where a shape is missing."""
    return tuple(
        Subject(source.rings, target.rings, step.links, step.joined, step.turns)
        if source.parts and target.parts
        else None
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
class MarkWish:
    """So many suggested marks are wished for a link of a step, both counted from 0."""

    step: int
    link: int
    count: int


@dataclass(frozen=True)
class Proposal:
    """Two polygons for which marks are to be suggested, at most so many."""

    source: Polygon
    target: Polygon
    count: int
    generation: int = 0


@dataclass(frozen=True, eq=False)
class Result:
    """A blend and what was measured of it; of one part it is a `Blend`, of several a `ShapeBlend`.

    Attributes
    ----------
    method : str
    blend : Blend or ShapeBlend
    report : Report or ShapeReport
    samples : tuple of (k, n, 2) arrays
        For each link the rings at moments evenly spread over [0, 1].
    """

    method: str
    blend: "Blend | ShapeBlend"
    report: "Report | ShapeReport"
    samples: tuple[Floats, ...]

    @property
    def settled(self) -> bool:
        """Whether no better one will follow."""
        return self.blend.settled

    @cached_property
    def pairs(self) -> "tuple[Correspondence, ...]":
        """For each link the correspondence of its rings."""
        return self.blend.pair.ring_pairs

    def rings_at(self, t: float) -> list[Floats]:
        """Give for each link the ring at t."""
        return [ring[0] for ring in self.blend.rings([t])]

    @property
    def outer(self) -> tuple[int, ...]:
        """For each link the one whose ring its own is a hole of, -1 for outlines."""
        return self.blend.pair.outer

    @cached_property
    def box(self) -> Floats:
        """The lower left and the upper right corner of all frames, (2, 2)."""
        low = np.min([ring.min(axis=(0, 1)) for ring in self.samples], axis=0)
        high = np.max([ring.max(axis=(0, 1)) for ring in self.samples], axis=0)
        return np.array([low, high])


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
