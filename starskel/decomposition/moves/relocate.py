"""Better-shaped pieces: every Steiner vertex goes to where the smallest kernel round it is largest.

In rounds every Steiner vertex tries places round its own, in the source or in the target, and takes the one
that is best for the worst of its pieces there. A move is made only if exact predicates prove all its pieces.
"""

from collections.abc import Container

import numpy as np

from starskel.arrays import Complex, Floats
from starskel.decomposition.board import Board
from starskel.decomposition.moves.best_places import best_places
from starskel.decomposition.pieces import Piece
from starskel.task import Task

STRIDES = (0.4, 0.25, 0.15, 0.1, 0.06)
"""How far a vertex tries to go in each round, in distances to its neighbours."""

WORTH = 1.02
"""A move has to make the smallest kernel larger by this factor."""


def relocated(board: Board, pieces: list[Piece], task: Task) -> list[Piece]:
    """Give the same pieces, with Steiner vertices in better places.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    for stride in STRIDES:
        task.reach(0)
        pieces = _moved(board, pieces, stride, task)
    return pieces


def _moved(board: Board, pieces: list[Piece], stride: float, task: Task) -> list[Piece]:
    """Move Steiner vertices, on one side no two of the same piece, where all pieces prove right after it.

    A piece that is seen whole only from a common vertex is left alone: another kernel may not contain it.
    """
    around = _around(board, pieces, task)
    if not around:
        return pieces
    best = best_places(board, around, stride, task)
    names = {vertex: vertex for vertex in around}
    middles: list[dict[Piece, complex]] = []
    for side in (0, 1):
        moves = _apart(around, best.places[side], best.gains[side])
        rows = _placed_again(board, {names[vertex]: place for vertex, place in moves.items()}, side)
        names = {vertex: rows.get(name, name) for vertex, name in names.items()}
        middles.append(_middles(around, moves, best.stayed[side], best.moved[side]))
    return _proven(board, pieces, names, middles, task)


def _middles(
    around: dict[int, list[Piece]], moves: Container[int], stayed: Complex, moved: Complex
) -> dict[Piece, complex]:
    """Give the middles of the kernels of pieces once vertices have moved, no two of the same piece."""
    found: dict[Piece, complex] = {}
    own = ((vertex, piece) for vertex, near in around.items() for piece in near)
    for (vertex, piece), before, after in zip(own, stayed.tolist(), moved.tolist(), strict=True):
        if vertex in moves:
            found[piece] = after
        else:
            found.setdefault(piece, before)
    return found


def _apart(around: dict[int, list[Piece]], places: Floats, gains: Floats) -> dict[int, Floats]:
    """Give the moves that are worth it, but no two of the same piece."""
    moves: dict[int, Floats] = {}
    touched: set[Piece] = set()
    for vertex, place, gain in zip(around, places, gains, strict=True):
        if gain > WORTH and touched.isdisjoint(around[vertex]):
            moves[vertex] = place
            touched.update(around[vertex])
    return moves


def _proven(
    board: Board,
    pieces: list[Piece],
    names: dict[int, int],
    middles: list[dict[Piece, complex]],
    task: Task,
) -> list[Piece]:
    """Give the pieces with vertices renamed, but for those of pieces that do not prove right.

    Nearly all do, from the middles of their kernels.
    """
    renamed = _renamed(pieces, names)
    changed = [k for k, piece in enumerate(pieces) if piece != renamed[k]]
    places = [np.array([found[pieces[k]] for k in changed]).reshape(-1, 1) for found in middles]
    board.note_kernels([renamed[k] for k in changed], [place.view(np.float64) for place in places])
    while True:
        proven = board.have_kernels([renamed[k] for k in changed], task)
        wrong = {v for k, star in zip(changed, proven, strict=True) if not star for v in pieces[k]}
        if not wrong:
            return renamed
        names = {vertex: name for vertex, name in names.items() if vertex not in wrong}
        renamed = _renamed(pieces, names)
        changed = [k for k, piece in enumerate(pieces) if piece != renamed[k]]


def _renamed(pieces: list[Piece], names: dict[int, int]) -> list[Piece]:
    return [tuple(names.get(v, v) for v in piece) for piece in pieces]


def _around(board: Board, pieces: list[Piece], task: Task) -> dict[int, list[Piece]]:
    """Give the pieces round each Steiner vertex, if all of these have kernels with an inside."""
    around: dict[int, list[Piece]] = {}
    for piece in pieces:
        task.reach(0)
        for vertex in piece:
            if vertex >= board.n:
                around.setdefault(vertex, []).append(piece)
    neighbours = list(dict.fromkeys(piece for near in around.values() for piece in near))
    stars = dict(zip(neighbours, board.have_kernels(neighbours, task), strict=True))
    return {vertex: near for vertex, near in sorted(around.items()) if all(stars[piece] for piece in near)}


def _placed_again(board: Board, moves: dict[int, Floats], side: int) -> dict[int, int]:
    """Put vertices anew, on one side where they are moved to, on the other where they were; give the rows."""
    rows = np.array(list(moves), dtype=np.intp)
    added = [points.again(rows) for points in board.sides]
    added[side] = board.sides[side].with_free(np.array(list(moves.values())).reshape(-1, 2))
    return dict(zip(moves, board.add(*added), strict=True))
