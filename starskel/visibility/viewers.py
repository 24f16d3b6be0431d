"""What is looked at, and from where."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Flags, Floats, Indices
from starskel.points import Points, doubtful_area
from starskel.predicates import ROUNDING
from starskel.triangulation import Triangulation
from starskel.visibility.cells import Cells


@dataclass(frozen=True, eq=False)
class Viewers:
    """Where the viewers and the ring's vertices are, and the cells between them.

    Attributes
    ----------
    cells : Cells
    points : Points
    ring, rows : (n,) and (k,) arrays of int
        The rows of the vertices and of the viewers.
    vertices, at : (n,) and (k,) complex arrays
        The coordinates of the vertices and of the viewers.
    slack : float
        What two coordinates may be off by rounding, together.
    doubtful : float
        Up to which doubled area of a triangle rounding might turn its sign.
    """

    cells: Cells
    points: Points
    ring: Indices
    rows: Indices
    vertices: Complex
    at: Complex
    slack: float
    doubtful: float

    @classmethod
    def of(cls, ground: Triangulation, cells: Cells, points: Points, rows: Indices) -> "Viewers":
        """Put viewers, the rows of some points, into triangulated rings and their cells."""
        places = points.coordinates.view(np.complex128)[:, 0]
        slack = 2 * ROUNDING * float(np.abs(ground.vertices).max())
        doubtful = doubtful_area(ground.vertices)
        return cls(
            cells, points, ground.rings.rows, rows, places[ground.rings.rows], places[rows], slack, doubtful
        )

    def pairs(self, viewer: Indices, vertex: Indices) -> Indices:
        """Give the places of pairs in a table of all viewers and vertices, row by row."""
        return viewer * len(self.ring) + vertex

    def turns(
        self, viewer: Indices, first: Indices, second: Indices, doubled: Floats
    ) -> tuple[Floats, Flags]:
        """Tell how viewers turn to look from one vertex to another: left (1), right (-1) or not (0), exactly.

        Tell, too, whether the line to either vertex passes the other by no more than rounding. Doubled are
        the areas of the triangles that the three form, rounded.
        """
        at = self.at[viewer]
        reach = self.slack * (np.abs(self.vertices[first] - at) + np.abs(self.vertices[second] - at))
        signs = np.sign(doubled)
        close = np.flatnonzero(np.abs(doubled) <= 4 * reach)
        if len(close):
            rows = self.rows[viewer[close]], self.ring[first[close]], self.ring[second[close]]
            signs[close] = self.points.orientation(*rows)
        return signs, np.abs(doubled) <= reach
