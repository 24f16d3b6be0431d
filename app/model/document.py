"""Document: a frozen snapshot of all that is edited, with verbs that give new documents."""

from collections.abc import Callable, Collection
from dataclasses import dataclass, replace

import numpy as np

from app.model import marks as pins
from app.model.marks import Marks, Side
from starskel.correspondence.marks import Mark, checked_marks
from starskel.errors import InvalidMarks, InvalidPolygon, told
from starskel.polygon import Polygon
from starskel.predicates import Floats

Point = tuple[float, float]


@dataclass(frozen=True)
class Document:
    """Two shapes, what corresponds, and the methods to compare.

    Every verb gives a new document, or raises the `StarskelError` that says why it cannot: what is not a
    simple polygon, and marks that cross, never get in.

    Attributes
    ----------
    name : str
        What the user calls it.
    source, target : Polygon or None
        The shapes, None where nothing has been drawn yet.
    marks : tuple of (int, int)
        A vertex of the source, a vertex of the target, in the order in which they were set.
    methods : tuple of str
        Names of the blending methods shown side by side.
    """

    name: str = ""
    source: Polygon | None = None
    target: Polygon | None = None
    marks: Marks = ()
    methods: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.source is not None and self.target is not None:
            checked_marks(self.source, self.target, self.marks)
        elif self.marks:
            raise InvalidMarks(
                told("there are marks, but not both shapes"), told("draw both shapes first"), self.marks
            )

    def polygon(self, side: Side) -> Polygon | None:
        """Give the shape on this side."""
        return self.source if side == "source" else self.target

    def vertices(self, side: Side) -> Floats:
        """Give the vertices on this side, (n, 2), none where nothing has been drawn."""
        polygon = self.polygon(side)
        return polygon.vertices if polygon is not None else np.empty((0, 2))

    def draw(self, side: Side, polygon: Polygon | None) -> "Document":
        """Replace a whole shape, or remove it; its marks go with it."""
        return self._with(side, polygon, ())

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
        return self._reshape(side, ring, self.marks)

    def insert(self, side: Side, edge: int, point: Point) -> "Document":
        """Insert a vertex on the edge that starts at vertex `edge`; its index is `edge` + 1.

        Raises
        ------
        InvalidPolygon
            If edges would cross.
        """
        ring = np.insert(self.vertices(side), edge + 1, point, axis=0)
        return self._reshape(side, ring, pins.after_insertion(self.marks, side, edge + 1))

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
        return self._reshape(side, ring, pins.after_deletion(self.marks, side, vertices))

    def reform(self, side: Side, ring: Floats, place: Callable[[int], int | None]) -> "Document":
        """Give a shape another ring; `place` tells where each vertex is in it, None where it is gone.

        Raises
        ------
        InvalidPolygon
            If edges would cross or vertices coincide.
        InvalidMarks
            If the shape is turned inside out so that marks cross.
        """
        ends = ((mark, place(pins.end(mark, side))) for mark in self.marks)
        marks = tuple(pins.with_end(mark, side, vertex) for mark, vertex in ends if vertex is not None)
        return self._reshape(side, ring, marks)

    def marked(self, side: Side) -> tuple[int, ...]:
        """Give the vertices on this side that are marked."""
        return tuple(pins.end(mark, side) for mark in self.marks)

    def exchanged(self) -> "Document":
        """Exchange source and target."""
        marks = tuple((target, source) for source, target in self.marks)
        return replace(self, source=self.target, target=self.source, marks=marks)

    def mark(self, source: int, target: int) -> "Document":
        """Add the mark that these vertices correspond.

        Raises
        ------
        InvalidMarks
            Naming the new mark and the one that it conflicts with.
        """
        return replace(self, marks=(*self.marks, (source, target)))

    def unmark(self, index: int) -> "Document":
        """Remove a mark."""
        return replace(self, marks=self._marks_but(index))

    def repin(self, index: int, side: Side, vertex: int) -> "Document":
        """Move one end of a mark to another vertex; the mark keeps its number.

        Raises
        ------
        InvalidMarks
            Naming the mark as it would be and the one that it conflicts with.
        """
        moved = pins.with_end(self.marks[index], side, vertex)
        rest = self._marks_but(index)
        replace(self, marks=(*rest, moved))  # checked last, the moved mark is the one that is named
        return replace(self, marks=(*rest[:index], moved, *rest[index:]))

    def remark(self, marks: Marks) -> "Document":
        """Replace all marks.

        Raises
        ------
        InvalidMarks
            Naming two that conflict.
        """
        return replace(self, marks=marks)

    def compare(self, methods: tuple[str, ...]) -> "Document":
        """Choose the methods shown side by side."""
        return replace(self, methods=methods)

    def _marks_but(self, index: int) -> Marks:
        return self.marks[:index] + self.marks[index + 1 :]

    def _reshape(self, side: Side, ring: Floats, marks: Marks) -> "Document":
        """Check the ring and store it; where it now runs clockwise the marks follow its new indices."""
        polygon = Polygon(ring)
        follow = tuple(self._following(mark, side, polygon) for mark in marks)
        return self._with(side, polygon, follow)

    @staticmethod
    def _following(mark: Mark, side: Side, polygon: Polygon) -> Mark:
        return pins.with_end(mark, side, polygon.vertex_of(pins.end(mark, side)))

    def _with(self, side: Side, polygon: Polygon | None, marks: Marks) -> "Document":
        """Store a shape; it forgets in which order it was given, so that marks mean its own vertices."""
        own = Polygon(polygon.vertices) if polygon is not None else None
        if side == "source":
            return replace(self, source=own, marks=marks)
        return replace(self, target=own, marks=marks)


def lost_marks(before: Document, after: Document) -> int:
    """Count the marks that an edit of the shapes took along."""
    if (before.source, before.target) == (after.source, after.target):
        return 0
    return max(len(before.marks) - len(after.marks), 0)
