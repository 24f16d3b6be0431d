"""Tilings of a pair of rings while they are being made: rings, Steiner vertices, pieces."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from starskel.decomposition.minimal import Piece
from starskel.predicates import Floats


@dataclass(frozen=True, eq=False)
class Tiling:
    """Pieces that tile two rings in the same way.

    Attributes
    ----------
    source, target : (m, 2) arrays
        The vertices of the rings, then the Steiner vertices.
    pieces : tuple of tuples of int
        For each piece the rows of its vertices, counter-clockwise.
    """

    source: Floats
    target: Floats
    pieces: tuple[Piece, ...]

    def cost(self) -> tuple[int, int]:
        """Give the price of this tiling: vertices, Steiner ones among them, then pieces."""
        return len(self.source), len(self.pieces)

    def refine(self, cell: int, inner: "Tiling") -> "Tiling":
        """Replace a piece by a tiling of it, whose ring is that piece's."""
        return self.refine_all([(cell, inner)])

    def refine_all(self, inner: Sequence[tuple[int, "Tiling"]]) -> "Tiling":
        """Replace several pieces by tilings of them."""
        source, target = [self.source], [self.target]
        count = len(self.source)
        pieces = [piece for at, piece in enumerate(self.pieces) if at not in dict(inner)]
        for cell, tiling in inner:
            ring = self.pieces[cell]
            rows = np.concatenate([ring, count + np.arange(len(tiling.source) - len(ring))])
            pieces += [tuple(rows[list(piece)].tolist()) for piece in tiling.pieces]
            source.append(tiling.source[len(ring) :])
            target.append(tiling.target[len(ring) :])
            count += len(tiling.source) - len(ring)
        return Tiling(np.concatenate(source), np.concatenate(target), tuple(pieces))
