"""A tiling while it is being made: two sets of points, and the pieces over them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from starskel.decomposition.kernel import have_star_vertices, star_points, star_vertices
from starskel.decomposition.pieces import Piece
from starskel.points import Points
from starskel.predicates import Floats, Relation
from starskel.task import Task

NOWHERE = np.empty((0, 2))

_SMALL = 100
"""Rings of so many vertices are looked at together with all edges; of larger ones few edges leave little."""


@dataclass(frozen=True, eq=False)
class Tiling:
    """Pieces that tile two polygons in the same way.

    Attributes
    ----------
    source, target : Points
        The vertices of the polygons, then the Steiner vertices.
    pieces : tuple of tuples of int
        For each piece the rows of its vertices, counter-clockwise.
    """

    source: Points
    target: Points
    pieces: tuple[Piece, ...]

    def cost(self) -> tuple[int, int]:
        """Give the price of this tiling: the vertices it uses, Steiner ones among them, then its pieces."""
        return len({vertex for piece in self.pieces for vertex in piece}), len(self.pieces)

    def replace(
        self, piece: Piece, pieces: Sequence[Piece], source: Floats = NOWHERE, target: Floats = NOWHERE
    ) -> "Tiling":
        """Put pieces in the place of one, and add Steiner vertices at (k, 2) places in source and target."""
        rest = tuple(other for other in self.pieces if other != piece)
        return Tiling(self.source.with_free(source), self.target.with_free(target), (*rest, *pieces))

    def only(self, piece: Piece) -> "Tiling":
        """Give one piece alone, over the same points."""
        return Tiling(self.source, self.target, (piece,))

    def refined(self, piece: Piece, inner: "Tiling") -> "Tiling":
        """Put a tiling of a piece in its place; its points are these and more."""
        rest = tuple(other for other in self.pieces if other != piece)
        return Tiling(inner.source, inner.target, (*rest, *inner.pieces))

    def swapped(self) -> "Tiling":
        """Give the tiling with source and target exchanged."""
        return Tiling(self.target, self.source, self.pieces)

    def is_star(self, piece: Piece, task: Task) -> bool:
        """Tell whether a simple ring of vertices has a common star vertex, or kernels with an inside."""
        return self.has_common_star_vertex(piece, task) or bool(self.are_stars([piece], task)[0])

    def has_common_star_vertex(self, piece: Piece, task: Task) -> bool:
        """Tell whether one of its vertices sees the whole of a simple ring, in both polygons."""
        ring = np.array(piece)
        stars = star_vertices(self.source, ring, task)
        return bool(stars.any() and (stars & star_vertices(self.target, ring, task)).any())

    def have_common_star_vertices(self, pieces: Sequence[Piece], task: Task) -> Relation:
        """Tell for which simple rings one of their vertices sees the whole, in both polygons."""
        found: Relation = np.zeros(len(pieces), dtype=bool)
        small = np.array([len(piece) <= _SMALL for piece in pieces], dtype=bool)
        rings = [np.array(pieces[k]) for k in np.flatnonzero(small).tolist()]
        found[small] = have_star_vertices((self.source, self.target), rings)
        for k in np.flatnonzero(~small).tolist():
            found[k] = self.has_common_star_vertex(pieces[k], task)
        return found

    def are_stars(self, pieces: Sequence[Piece], task: Task) -> Relation:
        """Tell which rings of vertices are simple, counter-clockwise and have kernels with an inside."""
        rings = [np.array(piece) for piece in pieces]
        stars: Relation = np.ones(len(rings), dtype=bool)
        for side in (self.source, self.target):
            _, areas = star_points(side, [rings[k] for k in np.flatnonzero(stars)], task)
            stars[stars] = areas > 0
        return stars
