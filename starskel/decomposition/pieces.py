"""What a decomposition is."""

from collections.abc import Collection
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.arguments import point
from starskel.arrays import Floats, ReadOnlyArrays
from starskel.correspondence import Correspondence

Piece = tuple[int, ...]
"""The rows of a piece's vertices, counter-clockwise."""

Around = tuple[int, tuple[Piece, ...]]
"""A Steiner vertex and the pieces round it."""

Replacements = tuple[tuple[Piece, ...], ...]
"""What may take the place of some pieces, choice by choice."""


@dataclass(frozen=True, eq=False)
class Decomposition(ReadOnlyArrays):
    """Compatible star decompositions of the two polygons of a pair (paper, section 2.4.1).

    Attributes
    ----------
    pair : Correspondence
        The polygons decomposed, of n vertices each.
    source, target : (m, 2) arrays
        The points: first the n vertices of the pair, then m - n Steiner vertices.
    pieces : tuple of tuples of int
        For each piece the rows of its vertices, counter-clockwise.
    source_origins, target_origins : (k, 2) arrays
        A star point of each piece, corresponding to each other.

    Examples
    --------
    >>> import starskel
    >>> hook = [(0, 0), (6, 0), (6, 5), (3, 5), (3, 4), (5, 4), (5, 1), (0, 1)]
    >>> decomposition = starskel.decompose(starskel.match(hook, hook, marks=[(0, 0)]))
    >>> decomposition.source[list(decomposition.pieces[0])].tolist()
    [[0.0, 1.0], [0.0, 0.0], [6.0, 0.0], [5.0, 1.0]]
    >>> decomposition.piece_at((1, 0.5))
    0
    """

    pair: Correspondence
    source: Floats
    target: Floats
    pieces: tuple[Piece, ...]
    source_origins: Floats
    target_origins: Floats

    @property
    def exchanged(self) -> "Decomposition":
        """The same pieces of the same pair, with the target as the source."""
        return Decomposition(
            pair=self.pair.exchanged,
            source=self.target,
            target=self.source,
            pieces=self.pieces,
            source_origins=self.target_origins,
            target_origins=self.source_origins,
        )

    def piece_at(self, place: tuple[float, float]) -> int:
        """Give the piece whose star origin is nearest to a place of the source.

        Raises
        ------
        StarskelError
            If these are not two finite numbers.
        """
        return int(np.hypot(*(self.source_origins - point(place, "a place")).T).argmin())


def edges_of(piece: Piece) -> list[tuple[int, int]]:
    """Give the edges of a piece, from each vertex to the next."""
    return list(pairwise((*piece, piece[0])))


def cost(pieces: Collection[Piece]) -> tuple[int, int]:
    """Give the price of pieces: the vertices they use, Steiner ones among them, then their number."""
    return len(set().union(*pieces)), len(pieces)


def chain_after(piece: Piece, vertex: int) -> Piece:
    """Give a piece without one of its vertices, from the next one round to the last before it."""
    at = piece.index(vertex)
    return piece[at + 1 :] + piece[:at]


def from_least(piece: Piece) -> Piece:
    """Give a piece from its least vertex on, so that one ring has one name."""
    start = piece.index(min(piece))
    return piece[start:] + piece[:start]
