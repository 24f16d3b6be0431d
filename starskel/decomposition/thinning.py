"""Fewer vertices on straight runs: of very large rings what is needed of them, put back into the pieces.

A vertex at which both rings go straight on changes nothing of what is seen, but the search for pieces looks
at all pairs of vertices. Those left out lie on edges of pieces, which stay the same pieces with them.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from starskel.arrays import Flags
from starskel.decomposition.board import Board
from starskel.decomposition.kernels.kernel import turns
from starskel.decomposition.pieces import Piece
from starskel.rings import Rings

MANY = 2000
"""Up to so many vertices none are left out, so that pieces can be as few as possible."""


def thinned(board: Board) -> Piece:
    """Give the ring's vertices; of many, those on straight runs of both only as far as there is room."""
    rows = np.arange(board.n)
    if board.n <= MANY:
        return tuple(rows.tolist())
    ring = Rings(rows, np.array([board.n]))
    straight: Flags = np.all([turns(side, ring) == 0 for side in board.sides], axis=0)
    room = max(0, MANY - int((~straight).sum()))
    along = np.flatnonzero(straight)
    chosen = along[np.arange(room) * len(along) // max(1, room)] if room < len(along) else along
    return tuple(np.union1d(rows[~straight], chosen).tolist())


def refilled(pieces: Sequence[Piece], whole: Piece, count: int) -> list[Piece]:
    """Put back into pieces what `thinned` has left out of a ring of `count` vertices."""
    if len(whole) == count:
        return list(pieces)
    between = {
        (a, b % count): tuple(k % count for k in range(a + 1, b))
        for a, b in pairwise([*whole, whole[0] + count])
    }
    return [
        tuple(v for a, b in pairwise([*piece, piece[0]]) for v in (a, *between.get((a, b), ())))
        for piece in pieces
    ]
