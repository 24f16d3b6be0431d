"""A tiling while it is being made: two sets of points, and the pieces over them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from starskel.decomposition.kernel import star_point, star_vertices
from starskel.decomposition.minimal import Piece
from starskel.points import Points
from starskel.predicates import Floats

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

    def is_flat(self, piece: Piece) -> bool:
        """Tell whether all vertices of a piece lie on one line, in the source or in the target."""
        ring = np.array(piece)
        before, after = np.roll(ring, 1), np.roll(ring, -1)
        return not all(side.orientation(before, ring, after).any() for side in (self.source, self.target))

    def is_star(self, piece: Piece) -> bool:
        """Tell whether a simple ring of vertices has a common star vertex, or kernels with an inside."""
        ring = np.array(piece)
        common = star_vertices(self.source, ring) & star_vertices(self.target, ring)
        if common.any():
            return True
        return star_point(self.source, ring) is not None and star_point(self.target, ring) is not None
