"""Better-shaped pieces: every Steiner vertex goes to where the smallest kernel round it is largest.

The kernel of a piece is measured against the piece: its area over the square of the piece's perimeter. In
rounds every Steiner vertex tries places round its own, in the source or in the target, and takes the one
that is best for the worst of its pieces there. A move is made only if exact predicates prove all its pieces.
"""

from collections.abc import Sequence

import numpy as np

from starskel.decomposition.board import Board
from starskel.decomposition.kernel import star_points
from starskel.decomposition.pieces import Piece, edges_of
from starskel.points import Points
from starskel.predicates import Floats, Indices
from starskel.rings import Rings
from starskel.task import Task

STRIDES = (0.4, 0.25, 0.15, 0.1, 0.06)
"""How far a vertex tries to go in each round, in distances to its neighbours."""

WAYS = 8
"""In so many directions."""

WORTH = 1.02
"""A move has to make the smallest kernel larger by this factor."""


def shaped(board: Board, pieces: list[Piece], task: Task) -> list[Piece]:
    """Give the same pieces, with Steiner vertices in better places.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    for stride in STRIDES:
        for side in (0, 1):
            task.reach(0)
            pieces = _moved(board, pieces, side, stride, task)
    return pieces


def _moved(board: Board, pieces: list[Piece], side: int, stride: float, task: Task) -> list[Piece]:
    """Move Steiner vertices on one side, no two of the same piece.

    A piece that is seen whole only from a common vertex is left alone: another kernel may not contain it.
    """
    around = _around(board, pieces)
    neighbours = list(dict.fromkeys(piece for pieces in around.values() for piece in pieces))
    stars = board.have_kernels(neighbours, task)
    touched = {piece for piece, star in zip(neighbours, stars, strict=True) if not star}
    free = {vertex: near for vertex, near in sorted(around.items()) if touched.isdisjoint(near)}
    moves: dict[int, Floats] = {}
    for vertex, place in _better(board.sides[side], free, stride, task).items():
        if touched.isdisjoint(free[vertex]):
            moves[vertex] = place
            touched.update(free[vertex])
    return _renamed(board, pieces, moves, side) if moves else pieces


def _around(board: Board, pieces: list[Piece]) -> dict[int, list[Piece]]:
    """Give the pieces round each Steiner vertex."""
    around: dict[int, list[Piece]] = {}
    for piece in pieces:
        for vertex in piece:
            if vertex >= board.n:
                around.setdefault(vertex, []).append(piece)
    return around


def _better(points: Points, free: dict[int, list[Piece]], stride: float, task: Task) -> dict[int, Floats]:
    """Give for each vertex the best place among those around its own, unless that is as good as any.

    All are asked for at once, as if every other vertex stayed: a few large array operations.
    """
    if not free:
        return {}
    tried = points.with_free(
        np.concatenate([_places(points, vertex, pieces, stride) for vertex, pieces in free.items()])
    )
    rows = np.arange(len(free) * WAYS).reshape(-1, WAYS) + len(points.coordinates)
    rows = np.concatenate([np.array(list(free))[:, None], rows], axis=1)
    worth = _worth(tried, list(free.items()), rows, task)
    best = worth.argmax(axis=1)
    return {
        vertex: tried.coordinates[rows[at, best[at]]]
        for at, vertex in enumerate(free)
        if worth[at, best[at]] > WORTH * worth[at, 0]
    }


def _worth(points: Points, free: list[tuple[int, list[Piece]]], rows: Indices, task: Task) -> Floats:
    """Give for each vertex, with each of its rows in its place, the worst of its pieces' kernels."""
    rings = []
    for (vertex, pieces), names in zip(free, rows, strict=True):
        for piece in map(np.array, pieces):
            renamed = np.repeat(piece[None], len(names), axis=0)
            renamed[:, piece == vertex] = names[:, None]
            rings += list(renamed)
    _, areas = star_points(points, Rings.of(rings), task)
    perimeters = _perimeters(points.coordinates, rings)
    first = np.cumsum([0, *(len(pieces) for _, pieces in free)])[:-1]
    worth = (areas / perimeters**2).reshape(-1, rows.shape[1])
    least: Floats = np.minimum.reduceat(worth, first, axis=0)
    return least


def _perimeters(coordinates: Floats, rings: Sequence[Indices]) -> Floats:
    counts = np.array([len(ring) for ring in rings])
    ends = np.cumsum(counts)
    start = np.concatenate(rings)
    end = np.append(start[1:], start[0])
    end[ends - 1] = start[ends - counts]
    perimeters: Floats = np.add.reduceat(np.hypot(*(coordinates[end] - coordinates[start]).T), ends - counts)
    return perimeters


def _places(points: Points, vertex: int, pieces: list[Piece], stride: float) -> Floats:
    """Give the places round a vertex, the first towards its first neighbour: so they turn with the shape."""
    edges = [edge for piece in pieces for edge in edges_of(piece) if vertex in edge]
    neighbours = sorted({v for edge in edges for v in edge} - {vertex})
    ways = (points.coordinates[neighbours] - points.coordinates[vertex]).view(np.complex128)[:, 0]
    step = stride * np.abs(ways).mean() * np.sign(ways[0])
    turns = np.exp(2j * np.pi / WAYS * np.arange(WAYS))
    places: Floats = points.coordinates[vertex] + (step * turns)[:, None].view(np.float64)
    return places


def _renamed(board: Board, pieces: list[Piece], moves: dict[int, Floats], side: int) -> list[Piece]:
    """Put vertices that were moved on one side in the place of old ones; on the other side they stay."""
    rows = np.array(list(moves))
    added = [points.again(rows) for points in board.sides]
    added[side] = board.sides[side].with_free(np.array(list(moves.values())))
    names = dict(zip(moves, board.add(*added), strict=True))
    return [tuple(names.get(v, v) for v in piece) for piece in pieces]
