"""Selection: some vertices of one part, and other parts of its shape."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from app.model.document import Document
from app.model.marks import Side
from starskel.arrays import Floats


@dataclass(frozen=True)
class Selection:
    """The selected vertices.

    Attributes
    ----------
    side : {"source", "target"}
        The shape they belong to, the one that was worked on last.
    vertices : frozenset of int
        Their indices; empty where nothing is selected.
    links : frozenset of int
        Where several parts are chosen in their list, the numbers of their links.
    """

    side: Side = "source"
    vertices: frozenset[int] = frozenset()
    links: frozenset[int] = frozenset()

    def __bool__(self) -> bool:
        return bool(self.vertices)

    def on(self, side: Side) -> frozenset[int]:
        """Give the selected vertices of this side."""
        return self.vertices if side == self.side else frozenset()

    def toggle(self, side: Side, vertex: int) -> "Selection":
        """Add the vertex, or take it out; a vertex of the other side starts a new selection."""
        return Selection(side, self.on(side) ^ {vertex})

    def add(self, side: Side, vertices: Iterable[int]) -> "Selection":
        """Add vertices; those of the other side start a new selection."""
        return Selection(side, self.on(side) | frozenset(vertices))

    def after(self, old: Document, new: Document) -> "Selection":
        """Give what remains selected after undo or redo: nothing of another part, or of other vertices."""
        same = _worked_on(old, self.side) == _worked_on(new, self.side)
        return self if same else Selection(self.side)


def _worked_on(document: Document, side: Side) -> tuple[int, int | None, int]:
    """Tell of the part worked on which it is, and how many vertices it has."""
    return document.shape_on(side), document.part(side), len(document.vertices(side))


def at_places(document: Document, side: Side, places: Floats) -> Selection:
    """Select the vertices of one shape that are at these places, (k, 2), whatever their numbers are now."""
    found = (document.vertices(side)[:, None] == places).all(axis=2).any(axis=1)
    return Selection(side, frozenset(np.flatnonzero(found).tolist()))


def everything(document: Document, side: Side) -> Selection:
    """Select all vertices of one shape."""
    return Selection(side, frozenset(range(len(document.vertices(side)))))
