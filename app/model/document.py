"""Document: a frozen snapshot of all that is edited, with verbs that give new documents."""

from collections.abc import Collection
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from app.model import marks as pins
from app.model.marks import Marks, Place, Side
from app.model.sequence import Sequence
from starskel.errors import InvalidPolygon, told
from starskel.files.picture import Picture
from starskel.files.step import Step
from starskel.polygon import Polygon
from starskel.predicates import Floats

Point = tuple[float, float]


def _unmoved(vertex: int) -> int:
    return vertex


@dataclass(frozen=True)
class Document:
    """Key shapes in order, two neighbours of them to be edited, and the methods to compare.

    Every verb gives a new document, or raises the `StarskelError` that says why it cannot: what is not a
    simple polygon, and marks that cross, never get in.

    Attributes
    ----------
    name : str
        What the user calls it.
    sequence : Sequence
        The key shapes, and the steps from one to the next.
    step : int
        Which step is on the canvases, counted from 0.
    methods : tuple of str
        Names of the blending methods shown side by side.
    description : str
        A sentence about it, as the file has it.
    """

    name: str = ""
    sequence: Sequence = field(default_factory=Sequence)
    step: int = 0
    methods: tuple[str, ...] = ()
    description: str = ""

    @classmethod
    def of(
        cls, source: Polygon | None = None, target: Polygon | None = None, marks: Marks = ()
    ) -> "Document":
        """Give a document of two shapes.

        Raises
        ------
        InvalidMarks
            If the marks do not fit them.
        """
        return cls(sequence=Sequence((source, target), (Step(marks),)))

    # the whole sequence

    def shape_on(self, side: Side) -> int:
        """Give the number in the sequence of the shape on this side, from 0 on."""
        return self.step + (side == "target")

    def showing(self, step: int) -> "Document":
        """Give the same document with another step on the canvases."""
        return replace(self, step=step) if step != self.step else self

    def arranged(self, sequence: Sequence, step: int) -> "Document":
        """Replace the whole sequence, with this step of it on the canvases."""
        return replace(self, sequence=sequence, step=step)

    def add_shape(self, after: int) -> "Document":
        """Put an empty shape behind another, and show the step to it."""
        return self.arranged(self.sequence.added(after), after)

    def duplicate_shape(self, shape: int) -> "Document":
        """Put a copy behind a shape, and show the step to it; both correspond where the shape is marked."""
        return self.arranged(self.sequence.duplicated(shape), shape)

    def delete_shape(self, shape: int) -> "Document":
        """Take a shape out of the sequence.

        Raises
        ------
        StarskelError
            If there are but two.
        """
        rest = self.sequence.without(shape)
        return self.arranged(rest, min(max(shape - 1, 0), len(rest.steps) - 1))

    def move_shape(self, shape: int, to: int) -> "Document":
        """Move a shape to another number in the sequence, and show a step of it."""
        step = to if self.shape_on("source") == shape else to - 1
        return self.arranged(self.sequence.moved(shape, to), min(max(step, 0), len(self.sequence.steps) - 1))

    def set_duration(self, step: int, duration: float) -> "Document":
        """Let a step take so long.

        Raises
        ------
        StarskelError
            If that is too short to be seen.
        """
        return self.arranged(self.sequence.timed(step, duration), self.step)

    # what is on the canvases

    @property
    def way(self) -> Step:
        """The step from the source to the target."""
        return self.sequence.steps[self.step]

    @property
    def source(self) -> Polygon | None:
        """The shape on the left canvas, None where nothing has been drawn yet."""
        return self.polygon("source")

    @property
    def target(self) -> Polygon | None:
        """The shape on the right canvas, None where nothing has been drawn yet."""
        return self.polygon("target")

    @property
    def marks(self) -> Marks:
        """A vertex of the source, a vertex of the target, in the order in which they were set."""
        return self.way.marks

    def steer(self, **changes: Any) -> "Document":
        """Change how the source becomes the target: its easing, root, turns or marks, as `Step` has them.

        Raises
        ------
        InvalidMarks
            If marks cross or do not fit the shapes.
        """
        return replace(self, sequence=self.sequence.put_step(self.step, replace(self.way, **changes)))

    def ease_alike(self) -> "Document":
        """Let t run over every step as over the one on the canvases."""
        steps = tuple(replace(step, easing=self.way.easing) for step in self.sequence.steps)
        return replace(self, sequence=replace(self.sequence, steps=steps))

    def polygon(self, side: Side) -> Polygon | None:
        """Give the shape on this side."""
        return self.sequence.shapes[self.shape_on(side)]

    def vertices(self, side: Side) -> Floats:
        """Give the vertices on this side, (n, 2), none where nothing has been drawn."""
        polygon = self.polygon(side)
        return polygon.vertices if polygon is not None else np.empty((0, 2))

    def picture(self, side: Side) -> Picture | None:
        """Give what is behind the shape on this side."""
        return self.sequence.pictures[self.shape_on(side)]

    def put_picture(self, side: Side, picture: Picture | None) -> "Document":
        """Put a picture behind the shape on this side, or take it away."""
        return replace(self, sequence=self.sequence.put_picture(self.shape_on(side), picture))

    def draw(self, side: Side, polygon: Polygon | None) -> "Document":
        """Replace a whole shape, or remove it; its marks go with it."""
        return self._with(side, polygon, lambda _: None)

    def moved(self, side: Side, vertices: Collection[int], offset: Point) -> Floats:
        """Give the ring with some vertices moved, simple or not."""
        ring = self.vertices(side).copy()
        ring[sorted(vertices)] += offset
        return ring

    def move(self, side: Side, vertices: Collection[int], offset: Point) -> "Document":
        """Move some vertices by the same offset.

        Raises
        ------
        InvalidPolygon
            If edges would cross or vertices coincide.
        InvalidMarks
            If the shape is turned inside out so that marks cross.
        """
        return self.place(side, self.moved(side, vertices, offset))

    def place(self, side: Side, ring: Floats) -> "Document":
        """Move each vertex to the row of its number.

        Raises
        ------
        InvalidPolygon
            If edges would cross or vertices coincide.
        InvalidMarks
            If the shape is turned inside out so that marks cross.
        """
        return self._reshape(side, ring)

    def insert(self, side: Side, edge: int, point: Point) -> "Document":
        """Insert a vertex on the edge that starts at vertex `edge`; its index is `edge` + 1.

        Raises
        ------
        InvalidPolygon
            If edges would cross.
        """
        ring = np.insert(self.vertices(side), edge + 1, point, axis=0)
        return self._reshape(side, ring, pins.after_insertion(edge + 1))

    def delete(self, side: Side, vertices: Collection[int]) -> "Document":
        """Delete vertices with their marks; deleting all of them removes the shape.

        Raises
        ------
        InvalidPolygon
            If fewer than three would be left, or edges would cross.
        """
        ring = np.delete(self.vertices(side), sorted(vertices), axis=0)
        if not len(ring):
            return self.draw(side, None)
        if len(ring) < 3:
            raise InvalidPolygon(
                told("{count} vertices would be left, and a polygon has at least 3", count=len(ring)),
                told("select all vertices to delete the whole shape"),
                place=(float(ring[0, 0]), float(ring[0, 1])),
            )
        return self._reshape(side, ring, pins.after_deletion(vertices))

    def reform(self, side: Side, ring: Floats, place: Place) -> "Document":
        """Give a shape another ring; `place` tells where each vertex is in it, None where it is gone.

        Raises
        ------
        InvalidPolygon
            If edges would cross or vertices coincide.
        InvalidMarks
            If the shape is turned inside out so that marks cross.
        """
        return self._reshape(side, ring, place)

    def marked(self, side: Side) -> tuple[int, ...]:
        """Give the vertices on this side that are marked, in this step or in the other one of the shape."""
        number = self.shape_on(side)
        return tuple(vertex for vertex, _ in self.sequence.marks_between(number, number))

    def exchanged(self) -> "Document":
        """Exchange source and target."""
        return self.arranged(self.sequence.moved(self.step, self.step + 1), self.step)

    def mark(self, source: int, target: int) -> "Document":
        """Add the mark that these vertices correspond.

        Raises
        ------
        InvalidMarks
            Naming the new mark and the one that it conflicts with.
        """
        return self.steer(marks=(*self.marks, (source, target)))

    def unmark(self, index: int) -> "Document":
        """Remove a mark."""
        return self.steer(marks=self._marks_but(index))

    def repin(self, index: int, side: Side, vertex: int) -> "Document":
        """Move one end of a mark to another vertex; the mark keeps its number.

        Raises
        ------
        InvalidMarks
            Naming the mark as it would be and the one that it conflicts with.
        """
        moved = pins.with_end(self.marks[index], side, vertex)
        rest = self._marks_but(index)
        self.steer(marks=(*rest, moved))  # checked last, the moved mark is the one that is named
        return self.steer(marks=(*rest[:index], moved, *rest[index:]))

    def remark(self, marks: Marks) -> "Document":
        """Replace all marks.

        Raises
        ------
        InvalidMarks
            Naming two that conflict.
        """
        return self.steer(marks=marks)

    def compare(self, methods: tuple[str, ...]) -> "Document":
        """Choose the methods shown side by side."""
        return replace(self, methods=methods)

    def _marks_but(self, index: int) -> Marks:
        return self.marks[:index] + self.marks[index + 1 :]

    def _reshape(self, side: Side, ring: Floats, place: Place = _unmoved) -> "Document":
        """Check the ring and store it; `place` tells which point of it each former vertex is now.

        Where the ring runs clockwise the marks follow its new indices.
        """
        polygon = Polygon(ring)

        def vertex(former: int) -> int | None:
            given = place(former)
            return None if given is None else polygon.vertex_of(given)

        return self._with(side, polygon, vertex)

    def _with(self, side: Side, polygon: Polygon | None, place: Place) -> "Document":
        """Store a shape; it forgets in which order it was given, so that marks mean its own vertices."""
        own = Polygon(polygon.vertices) if polygon is not None else None
        return replace(self, sequence=self.sequence.put_shape(self.shape_on(side), own, place))


def lost_marks(before: Document, after: Document) -> int:
    """Count the marks that an edit of shapes took along from those that are still there."""
    former, later = before.sequence, after.sequence
    if former.shapes == later.shapes:
        return 0
    if set(later.shapes) - {None} <= set(former.shapes):
        gone = {end for end in former.marked - later.marked if end[0] in later.shapes}
        return sum(not gone.isdisjoint(ends) for ends in former.ends)
    return max(sum(map(len, former.marks)) - sum(map(len, later.marks)), 0)
