"""Document: a frozen snapshot of all that is edited, with verbs that give new documents."""

from collections.abc import Collection
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from app.model import marks as pins
from app.model.marks import Marks, Renumbering, Side, other
from app.model.pairing import Links, complete, paired, part_of
from app.model.point import Point
from app.model.sequence import Sequence
from starskel.arrays import Floats
from starskel.errors import InvalidPolygon, told
from starskel.files.projects.key_shape import KeyShape, Part
from starskel.files.projects.picture import Picture
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon


def _unmoved(vertex: int) -> int:
    return vertex


@dataclass(frozen=True)
class Document:
    """Key shapes in order, two neighbours of them to be edited, and the methods to compare.

    Of two shapes with several parts, one link is worked on: a part of the source and its partner. Verbs that
    speak of the source, the target or the marks are about these.

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
    link : int
        Which of its links is worked on, counted from 0; one more than there are means parts yet to be drawn.
    methods : tuple of str
        Names of the blending methods shown side by side.
    description : str
        A sentence about it, as the file has it.
    """

    name: str = ""
    sequence: Sequence = field(default_factory=Sequence)
    step: int = 0
    link: int = 0
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
        shapes = tuple(KeyShape() if ring is None else KeyShape.of(ring) for ring in (source, target))
        one, two = (0 if shape.parts else None for shape in shapes)
        links = () if one is two is None and not marks else (Link(one, two, marks),)
        return cls(sequence=Sequence(shapes, (Step(links),)))

    # the whole sequence

    def shape_on(self, side: Side) -> int:
        """Give the number in the sequence of the shape on this side, from 0 on."""
        return self.step + (side == "target")

    def showing(self, step: int, link: int | None = None) -> "Document":
        """Give the same document with another step on the canvases, and a link of it worked on.

        Where none is named, it is one of the part that both steps have.
        """
        if link is None:
            link = self.link if step == self.step else self._link_in(step)
        return replace(self, step=step, link=link)

    def _link_in(self, step: int) -> int:
        """Give the link in a neighbouring step of the part worked on, 0 where there is none."""
        side: Side = "source" if step == self.step + 1 else "target"
        part = self.part(other(side)) if abs(step - self.step) == 1 else None
        links = self.sequence.steps[step].links
        return next((k for k, link in enumerate(links) if part_of(link, side) == part is not None), 0)

    def arranged(self, sequence: Sequence, step: int) -> "Document":
        """Replace the whole sequence, with this step of it on the canvases."""
        return replace(self, sequence=sequence, step=step, link=0)

    # what is on the canvases

    @property
    def way(self) -> Step:
        """The step from the source to the target."""
        return self.sequence.steps[self.step]

    @property
    def pair(self) -> Link:
        """The link that is worked on."""
        return self.way.links[self.link] if self.link < len(self.way.links) else Link()

    @property
    def source(self) -> Polygon | None:
        """The part worked on of the shape on the left canvas, None where it has not been drawn yet."""
        return self.polygon("source")

    @property
    def target(self) -> Polygon | None:
        """The part worked on of the shape on the right canvas, None where it has not been drawn yet."""
        return self.polygon("target")

    @property
    def marks(self) -> Marks:
        """A vertex of the source, a vertex of the target, in the order in which they were set."""
        return self.pair.marks

    def steer(self, **changes: Any) -> "Document":
        """Change how the shapes become each other: the easing or the turns, as `Step` has them."""
        return replace(self, sequence=self.sequence.put_step(self.step, replace(self.way, **changes)))

    def shape(self, side: Side) -> KeyShape:
        """Give all parts on this side."""
        return self.sequence.shapes[self.shape_on(side)]

    def part(self, side: Side) -> int | None:
        """Give the number of the part worked on among those on this side, None where there is none yet."""
        return part_of(self.pair, side)

    def polygon(self, side: Side) -> Polygon | None:
        """Give the part worked on."""
        part = self.part(side)
        return None if part is None else self.shape(side).rings[part]

    def vertices(self, side: Side) -> Floats:
        """Give the vertices on this side, (n, 2), none where nothing has been drawn."""
        polygon = self.polygon(side)
        return polygon.vertices if polygon is not None else np.empty((0, 2))

    def extent(self, side: Side) -> Floats:
        """Give the vertices of all parts on this side, (n, 2)."""
        return np.concatenate([np.empty((0, 2)), *(ring.vertices for ring in self.shape(side).rings)])

    def picture(self, side: Side) -> Picture | None:
        """Give what is behind the shape on this side."""
        return self.shape(side).picture

    def put_picture(self, side: Side, picture: Picture | None) -> "Document":
        """Put a picture behind the shape on this side, or take it away."""
        return replace(self, sequence=self.sequence.put_picture(self.shape_on(side), picture))

    def draw(self, side: Side, polygon: Polygon | None) -> "Document":
        """Replace the part worked on, add it where there is none, or remove it; its marks go with it."""
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
        return self.reform(side, self.moved(side, vertices, offset))

    def reform(self, side: Side, ring: Floats, renumbered: Renumbering = _unmoved) -> "Document":
        """Give a part another ring; its vertices keep their numbers, or have others in it.

        A ring that runs clockwise is turned round, and the marks follow.

        Raises
        ------
        InvalidPolygon
            If edges would cross or vertices coincide.
        InvalidMarks
            If the shape is turned inside out so that marks cross.
        """
        polygon = Polygon(ring)

        def vertex(former: int) -> int | None:
            given = renumbered(former)
            return None if given is None else polygon.vertex_of(given)

        return self._with(side, polygon, vertex)

    def insert(self, side: Side, edge: int, point: Point) -> "Document":
        """Insert a vertex on the edge that starts at vertex `edge`; its index is `edge` + 1.

        Raises
        ------
        InvalidPolygon
            If edges would cross.
        """
        ring = np.insert(self.vertices(side), edge + 1, point, axis=0)
        return self.reform(side, ring, pins.after_insertion(edge + 1))

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
        return self.reform(side, ring, pins.after_deletion(vertices))

    def marked(self, side: Side) -> tuple[int, ...]:
        """Give the vertices on this side that are marked, in this step or in the other one of the shape."""
        part = self.part(side)
        return () if part is None else self.sequence.marked(self.shape_on(side), part)

    def exchanged(self) -> "Document":
        """Exchange source and target."""
        return replace(self, sequence=self.sequence.moved(self.step, self.step + 1))

    def mark(self, source: int, target: int) -> "Document":
        """Add the mark that these vertices correspond.

        Raises
        ------
        InvalidMarks
            Naming the new mark and the one that it conflicts with.
        """
        return self.remark((*self.marks, (source, target)))

    def unmark(self, index: int) -> "Document":
        """Remove a mark."""
        return self.remark(self._marks_but(index))

    def repin(self, index: int, side: Side, vertex: int) -> "Document":
        """Move one end of a mark to another vertex; the mark keeps its number.

        Raises
        ------
        InvalidMarks
            Naming the mark as it would be and the one that it conflicts with.
        """
        moved = pins.with_end(self.marks[index], side, vertex)
        rest = self._marks_but(index)
        self.remark((*rest, moved))  # checked last, the moved mark is the one that is named
        return self.remark((*rest[:index], moved, *rest[index:]))

    def remark(self, marks: Marks) -> "Document":
        """Replace all marks.

        Raises
        ------
        InvalidMarks
            Naming two that conflict.
        """
        return self.put_link(replace(self.pair, marks=marks))

    def compare(self, methods: tuple[str, ...]) -> "Document":
        """Choose the methods shown side by side."""
        return replace(self, methods=methods)

    def _marks_but(self, index: int) -> Marks:
        return self.marks[:index] + self.marks[index + 1 :]

    def _with(self, side: Side, polygon: Polygon | None, renumbered: Renumbering) -> "Document":
        """Store a part; it forgets in which order it was given, so that marks mean its own vertices."""
        number, part = self.shape_on(side), self.part(side)
        if polygon is None:
            return self if part is None else self.remove_part(side)
        own = Polygon(polygon.vertices)
        if part is not None:
            return replace(self, sequence=self.sequence.put_ring(number, part, own, renumbered))
        return self._added(side, Part(own))

    def _added(self, side: Side, part: Part) -> "Document":
        """Add a part, which becomes the partner of the other one that is worked on."""
        grown = replace(self, sequence=self.sequence.add_part(self.shape_on(side), part))
        partner, own = self.part(other(side)), len(grown.shape(side)) - 1
        if partner is None:
            return grown.working_on(side, own)
        source, target = (own, partner) if side == "source" else (partner, own)
        return grown.relinked(paired(grown.way.links, source, target)).working_on(side, own)

    # parts and what becomes of them

    def working_on(self, side: Side, part: int) -> "Document":
        """Work on a part and its partner: on the first where it has several."""
        links = enumerate(self.way.links)
        return replace(self, link=next((k for k, link in links if part_of(link, side) == part), self.link))

    def remove_part(self, side: Side) -> "Document":
        """Remove the part worked on; its partner is alone, and still worked on."""
        part, partner = self.part(side), self.part(other(side))
        if part is None:
            return self
        rest = self.sequence.remove_part(self.shape_on(side), part)
        left = replace(self, sequence=rest, link=min(self.link, max(len(rest.steps[self.step].links) - 1, 0)))
        return left if partner is None else left.working_on(other(side), partner)

    def relinked(self, links: Links) -> "Document":
        """Say anew what becomes of the parts; parts left out are alone. The same part is worked on."""
        whole = complete(links, len(self.shape("source")), len(self.shape("target")))
        same = (k for k, link in enumerate(whole) if link.ends == self.pair.ends)
        return replace(self.steer(links=whole), link=next(same, min(self.link, len(whole) - 1)))

    def put_link(self, link: Link) -> "Document":
        """Replace the link that is worked on, between the same parts.

        Raises
        ------
        InvalidMarks
            If its marks cross or do not fit the parts.
        """
        links = self.way.links
        return self.steer(links=(*links[: self.link], link, *links[self.link + 1 :]))
