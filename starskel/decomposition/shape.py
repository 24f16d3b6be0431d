"""Better-shaped pieces: every Steiner vertex goes to where the smallest kernel round it is largest.

The kernel of a piece is measured against the piece: its area over the square of the piece's perimeter. In
rounds every Steiner vertex tries places round its own, in the source or in the target, and takes the one
that is best for the worst of its pieces there. A move is made only if exact predicates prove all its pieces.
"""

import numpy as np

from starskel.decomposition.board import Board
from starskel.decomposition.clipping import boxes, cut_along
from starskel.decomposition.pieces import Piece, chain_after
from starskel.points import Points
from starskel.predicates import Complex, Floats, Indices
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
    """Move Steiner vertices on one side, no two of the same piece, where all pieces round them prove right.

    A piece that is seen whole only from a common vertex is left alone: another kernel may not contain it.
    """
    around = _around(board, pieces, task)
    if not around:
        return pieces
    places, gains = _better(board.sides[side], around, stride, task)
    moves: dict[int, Floats] = {}
    touched: set[Piece] = set()
    for vertex, place, gain in zip(around, places, gains, strict=True):
        if gain > WORTH and touched.isdisjoint(around[vertex]):
            moves[vertex] = place
            touched.update(around[vertex])
    names = _placed_again(board, moves, side)
    renamed = {piece: tuple(names.get(v, v) for v in piece) for piece in pieces if piece in touched}
    proven = dict(zip(renamed, board.have_kernels(list(renamed.values()), task), strict=True))
    kept = {vertex for vertex in moves if not all(proven[piece] for piece in around[vertex])}
    return [piece if piece not in renamed or kept & set(piece) else renamed[piece] for piece in pieces]


def _around(board: Board, pieces: list[Piece], task: Task) -> dict[int, list[Piece]]:
    """Give the pieces round each Steiner vertex, if all of these have kernels with an inside."""
    around: dict[int, list[Piece]] = {}
    for piece in pieces:
        for vertex in piece:
            if vertex >= board.n:
                around.setdefault(vertex, []).append(piece)
    neighbours = list(dict.fromkeys(piece for near in around.values() for piece in near))
    stars = dict(zip(neighbours, board.have_kernels(neighbours, task), strict=True))
    return {vertex: near for vertex, near in sorted(around.items()) if all(stars[piece] for piece in near)}


def _better(
    points: Points, around: dict[int, list[Piece]], stride: float, task: Task
) -> tuple[Floats, Floats]:
    """Give for each vertex the best place among those round its own, and how much that is worth.

    All are asked for at once, as if every other vertex stayed: a few large array operations. The worth of a
    place is that of the worst kernel round it, over the same for the vertex where it stands.
    """
    chains = Rings.of([chain_after(piece, vertex) for vertex, near in around.items() for piece in near])
    counts = np.array([len(near) for near in around.values()])
    at = points.coordinates.view(np.complex128)[:, 0]
    own, ends = at[list(around)], at[chains.rows]
    tried = own[:, None] + _ways(own.repeat(counts), ends, chains, counts, stride)
    worth = _worth(tried.repeat(counts, axis=0), ends, chains, task)
    least = np.minimum.reduceat(worth, np.cumsum(counts) - counts, axis=0)
    best = least.argmax(axis=1)
    chosen = np.arange(len(own)), best
    return tried[chosen][:, None].view(np.float64), least[chosen] / least[:, 0]


def _ways(own: Complex, ends: Complex, chains: Rings, counts: Indices, stride: float) -> Complex:
    """Give the ways of vertices to the places to try: none, then WAYS round them.

    The first leads towards the first neighbour: so they turn with the shape.
    """
    spokes = ends[chains.first] - own
    first = np.cumsum(counts) - counts
    owner = np.repeat(np.arange(len(counts)), counts)
    foremost = np.lexsort((chains.rows[chains.first], owner))[first]
    step = stride * np.add.reduceat(np.abs(spokes), first) / counts * np.sign(spokes[foremost])
    turns = np.exp(2j * np.pi / WAYS * np.arange(WAYS))
    return np.concatenate([np.zeros((len(step), 1)), step[:, None] * turns], axis=1)


def _worth(tried: Complex, ends: Complex, chains: Rings, task: Task) -> Floats:
    """Give the kernels of the rings that places make with chains, measured against the rings.

    A kernel is cut along the chain once, and for each place along the two edges there.
    """
    start, end = ends[chains.first], ends[chains.last]
    following = np.roll(ends, -1)
    corners = np.concatenate([ends, tried.ravel()])
    owner = np.concatenate([chains.owner, np.repeat(np.arange(len(tried)), tried.shape[1])])
    order = np.argsort(owner, kind="stable")
    whole = boxes(corners[order], np.searchsorted(owner[order], np.arange(len(tried))))
    cells = cut_along(whole, (ends, following), chains.first, chains.counts - 1, task)
    cells = cells.chosen(np.repeat(np.arange(len(tried)), tried.shape[1]))
    begins, stops = (edge.repeat(tried.shape[1]) for edge in (start, end))
    _, areas = cells.left_of(tried.ravel(), begins).left_of(stops, tried.ravel()).measured()
    along = np.abs(following - ends)
    along[chains.last] = 0
    around = np.abs(tried - start[:, None]) + np.abs(tried - end[:, None])
    perimeters = around + np.add.reduceat(along, chains.first)[:, None]
    worth: Floats = areas.reshape(tried.shape) / perimeters**2
    return worth


def _placed_again(board: Board, moves: dict[int, Floats], side: int) -> dict[int, int]:
    """Put vertices anew, on one side where they are moved to, on the other where they were; give the rows."""
    rows = np.array(list(moves), dtype=np.intp)
    added = [points.again(rows) for points in board.sides]
    added[side] = board.sides[side].with_free(np.array(list(moves.values())).reshape(-1, 2))
    return dict(zip(moves, board.add(*added), strict=True))
