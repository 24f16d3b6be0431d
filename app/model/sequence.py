"""Sequence: key shapes in order, and for each step from one to the next its marks and its duration."""

from collections.abc import Sequence as Order
from dataclasses import dataclass, replace
from itertools import accumulate, pairwise

from app.model import marks as pins
from app.model.marks import Marks
from starskel.correspondence.marks import checked_marks
from starskel.errors import InvalidMarks, StarskelError, told
from starskel.files.picture import Picture
from starskel.polygon import Polygon

USUAL = 1.0
"""The duration of a step until the user sets another; durations count in steps of usual length."""

SHORTEST = 0.05
"""No step is shorter."""


@dataclass(frozen=True)
class Sequence:
    """Key shapes in order; step k leads from shape k to shape k + 1.

    Attributes
    ----------
    shapes : tuple of Polygon or None
        At least two, None where nothing has been drawn yet.
    marks : tuple of tuples of (int, int)
        For each step a vertex of its source, a vertex of its target.
    durations : tuple of float
        For each step how long it takes.
    pictures : tuple of Picture or None
        For each shape what is behind it; given empty, there is none at all.
    """

    shapes: tuple[Polygon | None, ...] = (None, None)
    marks: tuple[Marks, ...] = ((),)
    durations: tuple[float, ...] = (USUAL,)
    pictures: tuple[Picture | None, ...] = ()

    def __post_init__(self) -> None:
        if len(self.shapes) < 2:
            raise StarskelError(
                told("one shape alone has nothing to become"), told("keep two shapes at least")
            )
        if not self.pictures:
            object.__setattr__(self, "pictures", (None,) * len(self.shapes))
        for step, (source, target) in enumerate(pairwise(self.shapes)):
            check_step(source, target, self.marks[step])

    @property
    def steps(self) -> int:
        """How many steps there are, one fewer than shapes."""
        return len(self.shapes) - 1

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

    def marks_between(self, first: int, second: int) -> Marks:
        """Give the marks that lead from any shape to any other, by way of those between them.

        A shape and its copy correspond where it is marked at all.
        """
        if first > second:
            return pins.reversed_marks(self.marks_between(second, first))
        if first == second:
            before = [pins.end(mark, "target") for mark in self.marks[first - 1]] if first else []
            after = [pins.end(mark, "source") for mark in self.marks[first]] if first < self.steps else []
            return tuple((vertex, vertex) for vertex in dict.fromkeys(before + after))
        found = self.marks[first]
        for step in range(first + 1, second):
            found = pins.composed(found, self.marks[step])
        return found

    def arranged(self, order: Order[int | None], durations: Order[float]) -> "Sequence":
        """Put the shapes into another order; a shape may be left out or come again, None is an empty one.

        Neighbours that were none before get the marks that lead from one to the other by way of the shapes
        that lay between them.
        """
        shapes = tuple(None if k is None else self.shapes[k] for k in order)
        marks = tuple(() if a is None or b is None else self.marks_between(a, b) for a, b in pairwise(order))
        pictures = tuple(None if k is None else self.pictures[k] for k in order)
        return Sequence(shapes, marks, tuple(durations), pictures)

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
        return replace(self, durations=(*self.durations[:step], duration, *self.durations[step + 1 :]))

    def _longer(self, after: int, shape: int | None) -> "Sequence":
        order: list[int | None] = list(range(len(self.shapes)))
        order.insert(after + 1, shape)
        return self.arranged(order, (*self.durations[:after], USUAL, *self.durations[after:]))


def check_step(source: Polygon | None, target: Polygon | None, marks: Marks) -> None:
    """Raise InvalidMarks where the marks do not fit the shapes of their step."""
    if source is not None and target is not None:
        checked_marks(source, target, marks)
    elif marks:
        raise InvalidMarks(
            told("there are marks, but not both shapes"), told("draw both shapes first"), marks
        )
