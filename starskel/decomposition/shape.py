"""Better-shaped pieces: every Steiner vertex goes to where the smallest kernel round it is largest.

The kernel of a piece is measured against the piece: its area over the square of the piece's perimeter. In
rounds every Steiner vertex tries places round its own, in the source or in the target, and takes the one
that is best for the worst of its pieces there. A move is made only if exact predicates prove all its pieces.
"""

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.decomposition.board import Board
from starskel.decomposition.half_planes import kernels_of_chains
from starskel.decomposition.pieces import Piece, chain_after
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
    places, gains = _better(board, around, stride, task)
    names = {vertex: vertex for vertex in around}
    for side in (0, 1):
        moves = _apart(around, places[side], gains[side])
        rows = _placed_again(board, {names[vertex]: place for vertex, place in moves.items()}, side)
        names = {vertex: rows.get(name, name) for vertex, name in names.items()}
    return _proven(board, pieces, names, task)


def _apart(around: dict[int, list[Piece]], places: Floats, gains: Floats) -> dict[int, Floats]:
    """Give the moves that are worth it, but no two of the same piece."""
    moves: dict[int, Floats] = {}
    touched: set[Piece] = set()
    for vertex, place, gain in zip(around, places, gains, strict=True):
        if gain > WORTH and touched.isdisjoint(around[vertex]):
            moves[vertex] = place
            touched.update(around[vertex])
    return moves


def _proven(board: Board, pieces: list[Piece], names: dict[int, int], task: Task) -> list[Piece]:
    """Give the pieces with vertices renamed, but for those of pieces that do not prove right."""
    while True:
        renamed = [tuple(names.get(v, v) for v in piece) for piece in pieces]
        changed = [k for k, piece in enumerate(pieces) if piece != renamed[k]]
        proven = board.have_kernels([renamed[k] for k in changed], task)
        wrong = {v for k, star in zip(changed, proven, strict=True) if not star for v in pieces[k]}
        if not wrong:
            return renamed
        names = {vertex: name for vertex, name in names.items() if vertex not in wrong}


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


def _better(board: Board, around: dict[int, list[Piece]], stride: float, task: Task) -> tuple[Floats, Floats]:
    """Give for each vertex on each side the best place among those round its own, and how much that is worth.

    All are asked for at once, as if every other vertex stayed: a few large array operations. The worth of a
    place is that of the worst kernel round it, over the same for the vertex where it stands.

    Returns
    -------
    (2, k, 2) and (2, k) arrays
    """
    chains = Rings.of([chain_after(piece, vertex) for vertex, near in around.items() for piece in near])
    counts = np.array([len(near) for near in around.values()])
    owner = np.repeat(np.arange(len(counts)), counts)
    own = board.at[:, list(around)]
    tried = own[..., None] + _ways(
        board.at[:, chains.rows[chains.first]] - own[:, owner], chains, counts, stride
    )
    worth = _worth(board.at[:, chains.rows], tried, chains, owner, task)
    least = np.minimum.reduceat(worth, np.cumsum(counts) - counts, axis=1)
    best = least.argmax(axis=2)[..., None]
    places = np.take_along_axis(tried, best, axis=2).view(np.float64)
    return places, np.take_along_axis(least, best, axis=2)[..., 0] / least[..., 0]


def _ways(spokes: Complex, chains: Rings, counts: Indices, stride: float) -> Complex:
    """Give the ways of vertices to the places to try: none, then WAYS round them.

    The first leads towards the first neighbour: so they turn with the shape.
    """
    first = np.cumsum(counts) - counts
    owner = np.repeat(np.arange(len(counts)), counts)
    foremost = np.lexsort((chains.rows[chains.first], owner))[first]
    length = np.add.reduceat(np.abs(spokes), first, axis=1) / counts
    step = stride * length * np.sign(spokes[:, foremost])
    turns = np.append(0, np.exp(2j * np.pi / WAYS * np.arange(WAYS)))
    ways: Complex = step[..., None] * turns
    return ways


def _worth(ends: Complex, tried: Complex, chains: Rings, owner: Indices, task: Task) -> Floats:
    """Give the kernels of the rings that places make with chains, measured against the rings.

    A kernel is cut along the chain once, and for each place along the two edges there.
    """
    cells = kernels_of_chains(ends, chains, owner, task)
    start, end = ends[:, chains.first, None], ends[:, chains.last, None]
    places = tried[:, owner]
    cells = cells.chosen(np.repeat(np.arange(len(cells.size)), places.shape[2]))
    cells = cells.left_of(places.ravel(), np.broadcast_to(start, places.shape).ravel())
    cells = cells.left_of(np.broadcast_to(end, places.shape).ravel(), places.ravel())
    along = np.abs(np.roll(ends, -1, axis=1) - ends)
    along[:, chains.last] = 0
    perimeters = np.add.reduceat(along, chains.first, axis=1)[..., None]
    perimeters = perimeters + np.abs(places - start) + np.abs(places - end)
    worth: Floats = cells.measured()[1].reshape(places.shape) / perimeters**2
    return worth


def _placed_again(board: Board, moves: dict[int, Floats], side: int) -> dict[int, int]:
    """Put vertices anew, on one side where they are moved to, on the other where they were; give the rows."""
    rows = np.array(list(moves), dtype=np.intp)
    added = [points.again(rows) for points in board.sides]
    added[side] = board.sides[side].with_free(np.array(list(moves.values())).reshape(-1, 2))
    return dict(zip(moves, board.add(*added), strict=True))
