"""A tiling while it is being made: two sets of points, and the pieces over them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from starskel.decomposition.kernel import star_points, star_vertices
from starskel.decomposition.pieces import Piece
from starskel.points import Points
from starskel.predicates import Floats, Relation
from starskel.rings import Rings
from starskel.task import Task

NOWHERE = np.empty((0, 2))


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
        return bool(self.are_stars([piece], task)[0])

    def are_stars(self, pieces: Sequence[Piece], task: Task) -> Relation:
        """Tell which simple rings of vertices have a common star vertex, or kernels with an inside."""
        stars = self.have_common_star_vertices(pieces, task)
        left = np.flatnonzero(~stars)
        stars[left] = self.have_kernels([pieces[k] for k in left.tolist()], task)
        return stars

    def have_common_star_vertices(self, pieces: Sequence[Piece], task: Task) -> Relation:
        """Tell for which simple rings one of their vertices sees the whole, in both polygons."""
        rings = Rings.of(pieces)
        stars = star_vertices((self.source, self.target), rings, task)
        found: Relation = np.bincount(rings.owner[stars], minlength=len(pieces)) > 0
        return found

    def have_kernels(self, pieces: Sequence[Piece], task: Task) -> Relation:
        """Tell which rings of vertices are simple, counter-clockwise and have kernels with an inside."""
        stars: Relation = np.ones(len(pieces), dtype=bool)
        for side in (self.source, self.target):
            left = [pieces[k] for k in np.flatnonzero(stars).tolist()]
            stars[stars] = star_points(side, Rings.of(left), task)[1] > 0
        return stars
