"""A vertex, its partner, and the way that a blend takes it."""

from dataclasses import dataclass

import numpy as np

from app.model.marks import Side
from app.model.point import Point
from starskel import Correspondence


@dataclass(frozen=True)
class MatchedVertex:
    """Two vertices that correspond.

    Attributes
    ----------
    row : int
        Their row in the frames.
    source, target : (float, float)
        Where they are.
    source_vertex, target_vertex : int or None
        Their numbers on the canvases; None where the correspondence has inserted the vertex.
    """

    row: int
    source: Point
    target: Point
    source_vertex: int | None
    target_vertex: int | None

    def place(self, side: Side) -> Point:
        """Give where the vertex is on this side."""
        return self.source if side == "source" else self.target

    def vertex(self, side: Side) -> int | None:
        """Give the number of the vertex on this side."""
        return self.source_vertex if side == "source" else self.target_vertex


def matched_vertex(pair: Correspondence, side: Side, vertex: int) -> MatchedVertex | None:
    """Find a vertex of one side in a correspondence; None where it has no such vertex."""
    numbers = pair.source_vertices, pair.target_vertices
    rows = np.flatnonzero(numbers[side == "target"] == vertex)
    if not len(rows):
        return None
    row = int(rows[0])
    places = [(float(x), float(y)) for x, y in (pair.source[row], pair.target[row])]
    source, target = (int(own[row]) if own[row] >= 0 else None for own in numbers)
    return MatchedVertex(row, places[0], places[1], source, target)
