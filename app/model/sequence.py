"""Sequence: key shapes in order, and the steps from one to the next."""

from collections.abc import Sequence as Order
from dataclasses import dataclass, replace
from itertools import accumulate, pairwise

from app.model import marks as pins
from app.model.marks import Marks, Place, Side
from starskel.correspondence.marks import checked_marks
from starskel.errors import InvalidMarks, StarskelError, told
from starskel.files.picture import Picture
from starskel.files.step import Step
from starskel.polygon import Polygon

USUAL = Step()
"""A step until the user sets something; durations count in steps of its length."""

SHORTEST = 0.05
"""No step is shorter."""


@dataclass(frozen=True)
class Sequence:
    """Key shapes in order; step k leads from shape k to shape k + 1.

    Attributes
    ----------
    shapes : tuple of Polygon or None
        At least two, None where nothing has been drawn yet.
    steps : tuple of Step
        From each shape to the next, one fewer than shapes.
    pictures : tuple of Picture or None
        For each shape what is behind it; given empty, there is none at all.
    """

    shapes: tuple[Polygon | None, ...] = (None, None)
    steps: tuple[Step, ...] = (USUAL,)
    pictures: tuple[Picture | None, ...] = ()

    def __post_init__(self) -> None:
        if len(self.shapes) < 2:
            raise StarskelError(
                told("one shape alone has nothing to become"), told("keep two shapes at least")
            )
        if not self.pictures:
            object.__setattr__(self, "pictures", (None,) * len(self.shapes))
        for step, (source, target) in zip(self.steps, pairwise(self.shapes), strict=True):
            _check(source, target, step.marks)

    @property
    def marks(self) -> tuple[Marks, ...]:
        """For each step a vertex of its source, a vertex of its target."""
        return tuple(step.marks for step in self.steps)

    @property
    def durations(self) -> tuple[float, ...]:
        """For each step how long it takes."""
        return tuple(step.duration for step in self.steps)

    @property
    def ends(self) -> list[tuple[tuple[Polygon | None, int], tuple[Polygon | None, int]]]:
        """For each mark of all steps its two ends: a shape, and a vertex of it."""
        steps = zip(pairwise(self.shapes), self.marks, strict=True)
        return [((a, i), (b, j)) for (a, b), marks in steps for i, j in marks]

    @property
    def marked(self) -> frozenset[tuple[Polygon | None, int]]:
        """The shapes that are marked, each with a vertex that is."""
        return frozenset(end for ends in self.ends for end in ends)

    @property
    def times(self) -> tuple[float, ...]:
        """When each shape is reached, from 0 to 1."""
        ends = tuple(accumulate(self.durations, initial=0.0))
        return tuple(end / ends[-1] for end in ends)

    @property
    def complete(self) -> bool:
        """Whether there is a step with both its shapes."""
        return any(None not in ends for ends in pairwise(self.shapes))

    def marks_between(self, first: int, second: int) -> Marks:
        """Give the marks that lead from any shape to any other, by way of those between them.

        A shape and its copy correspond where it is marked at all.
        """
        if first > second:
            return pins.reversed_marks(self.marks_between(second, first))
        if first == second:
            before = [pins.end(mark, "target") for mark in self.marks[first - 1]] if first else []
            after = [pins.end(m, "source") for m in self.marks[first]] if first < len(self.steps) else []
            return tuple((vertex, vertex) for vertex in dict.fromkeys(before + after))
        found = self.marks[first]
        for step in range(first + 1, second):
            found = pins.composed(found, self.marks[step])
        return found

    def step_between(self, first: int | None, second: int | None) -> Step:
        """Give the step from any shape to any other, None is an empty one.

        Neighbours keep their step, also backwards. Else it goes as the step did that began at the same shape,
        with the marks that lead from the one to the other by way of the shapes that lay between them.
        """
        if first is None or first == second:
            kept = USUAL
        elif second == first - 1:
            return self.steps[second].reversed
        else:
            kept = self.steps[first] if first < len(self.steps) else USUAL
        marks = () if first is None or second is None else self.marks_between(first, second)
        return replace(kept, marks=marks)

    def arranged(self, order: Order[int | None], durations: Order[float]) -> "Sequence":
        """Put the shapes into another order; a shape may be left out or come again, None is an empty one."""
        shapes = tuple(None if k is None else self.shapes[k] for k in order)
        steps = tuple(
            replace(self.step_between(*ends), duration=duration)
            for ends, duration in zip(pairwise(order), durations, strict=True)
        )
        pictures = tuple(None if k is None else self.pictures[k] for k in order)
        return Sequence(shapes, steps, pictures)

    def added(self, after: int) -> "Sequence":
        """Put an empty shape behind another; the step to it is of usual length."""
        return self._longer(after, None)

    def duplicated(self, shape: int) -> "Sequence":
        """Put a copy behind a shape; the step to it is of usual length."""
        return self._longer(shape, shape)

    def without(self, shape: int) -> "Sequence":
        """Leave a shape out, and the step that leads to it."""
        order = [k for k in range(len(self.shapes)) if k != shape]
        step = max(shape - 1, 0)
        return self.arranged(order, self.durations[:step] + self.durations[step + 1 :])

    def moved(self, shape: int, to: int) -> "Sequence":
        """Move a shape to another number; the times stay where they are."""
        order = [k for k in range(len(self.shapes)) if k != shape]
        return self.arranged([*order[:to], shape, *order[to:]], self.durations)

    def timed(self, step: int, duration: float) -> "Sequence":
        """Let a step take so long; what follows it comes sooner or later.

        Raises
        ------
        StarskelError
            If it is shorter than `SHORTEST`.
        """
        if duration < SHORTEST:
            raise StarskelError(told("a step this short cannot be seen"), told("let it last longer"))
        return self.put_step(step, replace(self.steps[step], duration=duration))

    def put_step(self, number: int, step: Step) -> "Sequence":
        """Replace a step."""
        return replace(self, steps=(*self.steps[:number], step, *self.steps[number + 1 :]))

    def put_shape(self, number: int, shape: Polygon | None, place: Place) -> "Sequence":
        """Replace a shape; `place` tells where each vertex of the former one is in it, None where it is gone.

        Raises
        ------
        InvalidMarks
            If marks of a step to or from it would cross.
        """
        ends: dict[int, Side] = {number - 1: "target", number: "source"}
        steps = tuple(
            replace(step, marks=pins.followed(step.marks, ends[k], place)) if k in ends else step
            for k, step in enumerate(self.steps)
        )
        return replace(self, shapes=(*self.shapes[:number], shape, *self.shapes[number + 1 :]), steps=steps)

    def put_picture(self, number: int, picture: Picture | None) -> "Sequence":
        """Put a picture behind a shape, or take it away."""
        return replace(self, pictures=(*self.pictures[:number], picture, *self.pictures[number + 1 :]))

    def _longer(self, after: int, shape: int | None) -> "Sequence":
        order: list[int | None] = list(range(len(self.shapes)))
        order.insert(after + 1, shape)
        return self.arranged(order, (*self.durations[:after], USUAL.duration, *self.durations[after:]))


def _check(source: Polygon | None, target: Polygon | None, marks: Marks) -> None:
    """Raise InvalidMarks where the marks do not fit the shapes of their step."""
    if source is not None and target is not None:
        checked_marks(source, target, marks)
    elif marks:
        raise InvalidMarks(
            told("there are marks, but not both shapes"), told("draw both shapes first"), marks
        )
