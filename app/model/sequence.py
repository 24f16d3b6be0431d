"""Sequence: key shapes in order, and the steps from one to the next."""

from collections.abc import Sequence as Order
from dataclasses import dataclass, replace
from itertools import accumulate, pairwise
from typing import Any

from app.model import pairing
from app.model.marks import Renumbering, Side
from app.model.pairing import Ends, Links, complete
from starskel.errors import StarskelError, told
from starskel.files.projects.key_shape import KeyShape, Part
from starskel.files.projects.picture import Picture
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon

USUAL = Step()
"""A step until the user sets something; durations count in steps of its length."""

SHORTEST_DURATION = 0.05
"""No step is shorter."""

Vertex = tuple[Polygon, int]
"""A vertex of a polygon, wherever that is."""


@dataclass(frozen=True)
class Sequence:
    """Key shapes in order; step k leads from shape k to shape k + 1.

    Attributes
    ----------
    shapes : tuple of KeyShape
        At least two, without parts where nothing has been drawn yet.
    steps : tuple of Step
        From each shape to the next, one fewer than shapes.

    Raises
    ------
    StarskelError
        If there are too few.
    InvalidMarks
        If the links or the marks of a step do not fit its shapes.
    """

    shapes: tuple[KeyShape, ...] = (KeyShape(), KeyShape())
    steps: tuple[Step, ...] = (USUAL,)

    def __post_init__(self) -> None:
        if len(self.shapes) < 2:
            raise StarskelError(
                told("one shape alone has nothing to become"), told("keep two shapes at least")
            )
        for step, ends in zip(self.steps, pairwise(self.shapes), strict=True):
            step.check(*ends)

    @property
    def durations(self) -> tuple[float, ...]:
        """For each step how long it takes."""
        return tuple(step.duration for step in self.steps)

    @property
    def ends(self) -> list[tuple[Vertex, Vertex]]:
        """For each mark of all steps its two ends."""
        return [
            ((a.rings[link.source], i), (b.rings[link.target], j))
            for (a, b), step in zip(pairwise(self.shapes), self.steps, strict=True)
            for link in step.links
            if link.source is not None and link.target is not None
            for i, j in link.marks
        ]

    @property
    def pairings(self) -> list[frozenset[Ends]]:
        """For each step which parts are linked."""
        return [frozenset(link.ends for link in step.links) for step in self.steps]

    @property
    def rings(self) -> frozenset[Polygon]:
        """All polygons."""
        return frozenset(ring for shape in self.shapes for ring in shape.rings)

    @property
    def times(self) -> tuple[float, ...]:
        """When each shape is reached, from 0 to 1."""
        ends = tuple(accumulate(self.durations, initial=0.0))
        return tuple(end / ends[-1] for end in ends)

    @property
    def drawn(self) -> tuple[bool, ...]:
        """For each step whether both of its shapes have been drawn."""
        return tuple(bool(a.parts and b.parts) for a, b in pairwise(self.shapes))

    def drawn_step(self, step: int) -> int:
        """Give a step, or where a shape of it is empty the nearest drawn one, before it if there is one."""
        places = [number for number, drawn in enumerate(self.drawn) if drawn]
        return min(places, key=lambda place: (place > step, abs(place - step)), default=step)

    @property
    def complete(self) -> bool:
        """Whether there is a step with both its shapes."""
        return any(one.parts and two.parts for one, two in pairwise(self.shapes))

    # the order of shapes

    def marked(self, shape: int, part: int) -> tuple[int, ...]:
        """Give the vertices of a part that are marked, in the step to its shape or in the one from it."""
        found: list[int] = []
        for step, side in self._steps_at(shape).items():
            found += pairing.marked(self.steps[step].links, side, part)
        return tuple(dict.fromkeys(found))

    def links_between(self, first: int, second: int) -> Links:
        """Give the links that lead from any shape to any other, by way of those between them.

        A shape and its copy correspond where it is marked at all.
        """
        if first > second:
            return tuple(link.reversed for link in self.links_between(second, first))
        if first == second:
            parts = range(len(self.shapes[first]))
            return tuple(Link(part, part, tuple((v, v) for v in self.marked(first, part))) for part in parts)
        found = self.steps[first].links
        for step in range(first + 1, second):
            found = pairing.composed(found, self.steps[step].links)
        return complete(found, len(self.shapes[first]), len(self.shapes[second]))

    def step_between(self, first: int | None, second: int | None) -> Step:
        """Give the step from any shape to any other, None is an empty one.

        Neighbours keep their step, also backwards. Else it goes as the step did that began at the same shape,
        with the links that lead from the one to the other by way of the shapes that lay between them.
        """
        if first is not None and second is not None and second == first - 1:
            return self.steps[second].reversed
        began = first is not None and first != second and first < len(self.steps)
        kept = self.steps[first] if began and first is not None else USUAL
        if first is None or second is None:
            parts = [0 if shape is None else len(self.shapes[shape]) for shape in (first, second)]
            return replace(kept, links=complete((), *parts))
        return replace(kept, links=self.links_between(first, second))

    def arranged(self, order: Order[int | None], durations: Order[float]) -> "Sequence":
        """Put the shapes into another order; a shape may be left out or come again, None is an empty one."""
        shapes = tuple(KeyShape() if k is None else self.shapes[k] for k in order)
        steps = tuple(
            replace(self.step_between(*ends), duration=duration)
            for ends, duration in zip(pairwise(order), durations, strict=True)
        )
        return Sequence(shapes, steps)

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

    def _longer(self, after: int, shape: int | None) -> "Sequence":
        order: list[int | None] = list(range(len(self.shapes)))
        order.insert(after + 1, shape)
        return self.arranged(order, (*self.durations[:after], USUAL.duration, *self.durations[after:]))

    # steps and shapes

    def timed(self, step: int, duration: float) -> "Sequence":
        """Let a step take so long; what follows it comes sooner or later.

        Raises
        ------
        StarskelError
            If it is shorter than `SHORTEST_DURATION`.
        """
        if duration < SHORTEST_DURATION:
            raise StarskelError(told("a step this short cannot be seen"), told("let it last longer"))
        return self.put_step(step, replace(self.steps[step], duration=duration))

    def put_step(self, number: int, step: Step) -> "Sequence":
        """Replace a step."""
        return replace(self, steps=(*self.steps[:number], step, *self.steps[number + 1 :]))

    def put_picture(self, number: int, picture: Picture | None) -> "Sequence":
        """Put a picture behind a shape, or take it away."""
        return self._with(number, replace(self.shapes[number], picture=picture), {})

    # parts

    def add_part(self, number: int, part: Part) -> "Sequence":
        """Add a part to a shape; it has no partner yet."""
        shape = self.shapes[number]
        return self._with(number, shape.put(len(shape), part), {})

    def remove_part(self, number: int, part: int) -> "Sequence":
        """Take a part out of a shape; its partners are alone."""
        links = {
            step: pairing.without_part(self.steps[step].links, side, part)
            for step, side in self._steps_at(number).items()
        }
        return self._with(number, self.shapes[number].without(part), links)

    def put_ring(self, number: int, part: int, ring: Polygon, renumbered: Renumbering) -> "Sequence":
        """Give a part another ring; each vertex of the former one has another number in it, if any.

        Raises
        ------
        InvalidPolygon
            If the parts then form no shape.
        InvalidMarks
            If marks of a step to or from it would cross.
        """
        links = {
            step: pairing.followed(self.steps[step].links, side, part, renumbered)
            for step, side in self._steps_at(number).items()
        }
        shape = self.shapes[number]
        return self._with(number, shape.put(part, replace(shape.parts[part], ring=ring)), links)

    def style(self, number: int, part: int, **changes: Any) -> "Sequence":
        """Change the name, the colour or the visibility of a part, as `Part` has them."""
        shape = self.shapes[number]
        return self._with(number, shape.put(part, replace(shape.parts[part], **changes)), {})

    def _steps_at(self, shape: int) -> dict[int, Side]:
        """Give the steps to and from a shape, each with the side on which the shape is."""
        sides: dict[int, Side] = {shape - 1: "target", shape: "source"}
        return {step: side for step, side in sides.items() if 0 <= step < len(self.steps)}

    def _with(self, number: int, shape: KeyShape, links: dict[int, Links]) -> "Sequence":
        """Replace a shape and the links of some steps; parts that are new or left over are alone."""
        shapes = (*self.shapes[:number], shape, *self.shapes[number + 1 :])
        steps = tuple(
            replace(step, links=complete(links.get(k, step.links), *map(len, shapes[k : k + 2])))
            for k, step in enumerate(self.steps)
        )
        return Sequence(shapes, steps)


def lost_marks(former: Sequence, later: Sequence) -> int:
    """Count the marks that an edit of shapes or links took along from those that are still there."""
    if former.shapes == later.shapes and former.pairings == later.pairings:
        return 0
    if later.rings <= former.rings:
        left = frozenset(end for ends in later.ends for end in ends)
        gone = {end for ends in former.ends for end in ends if end[0] in later.rings} - left
        return sum(not gone.isdisjoint(ends) for ends in former.ends)
    return max(len(former.ends) - len(later.ends), 0)
