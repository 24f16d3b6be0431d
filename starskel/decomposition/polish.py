"""Fewer Steiner vertices in a tiling that is there: in small steps, and by tiling parts of it anew.

Vertices collapse into neighbours and pieces merge; in better places more vertices do. Where that ends, two
neighbouring Steiner vertices may still be one too many: the pieces round both are a cell, which is climbed
again. What comes of it is kept only where it costs less.
"""

from collections.abc import Iterator

from starskel.decomposition.board import Board
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.moves.reduce import reduce
from starskel.decomposition.moves.relocate import relocated
from starskel.decomposition.moves.tiling import Tiling, outline
from starskel.decomposition.pieces import Piece, cost, edges_of
from starskel.task import Task

FEW = 16
"""Up to so many Steiner vertices parts are tiled anew; of more it takes longer than all that went before."""

LARGE = 30
"""Cells of more vertices are left alone: they take long, and are seldom tiled better."""


def polished(board: Board, pieces: list[Piece], task: Task) -> list[Piece]:
    """Drop Steiner vertices and pieces that are not needed, by tiling anew as long as that goes on.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    (pieces,) = reduce(board, [pieces], task.quiet)
    pieces = _in_better_places(board, pieces, task)
    known: set[Piece] = set()
    while len({v for piece in pieces for v in piece if v >= board.n}) <= FEW:
        anew = _tiled_anew(board, pieces, known, task.quiet)
        if cost(anew) >= cost(pieces):
            break
        pieces = _in_better_places(board, anew, task)
    return pieces


def _in_better_places(board: Board, pieces: list[Piece], task: Task) -> list[Piece]:
    """Relocate Steiner vertices, which frees more vertices and pieces."""
    pieces = relocated(board, pieces, task.quiet)
    (pieces,) = reduce(board, [pieces], task)
    return pieces


def _tiled_anew(board: Board, pieces: list[Piece], known: set[Piece], task: Task) -> list[Piece]:
    """Tile cells of the tiling anew where that costs less, those first that gain most, but no known ones."""
    cells = {ring: near for ring, near in _cells(board, pieces) if ring not in known}
    known.update(cells)
    found = climb(board, list(cells), by_fan, task)
    offers = []
    for near, tiling in zip(cells.values(), found, strict=True):
        (vertices, count), (fewer, least) = cost(near), cost(tiling)
        if (gain := (vertices - fewer, count - least)) > (0, 0):
            offers.append((gain, near, tiling))
    offers.sort(key=lambda offer: offer[0], reverse=True)
    changed = Tiling(board, pieces)
    changed.make((near, tiling) for _, near, tiling in offers)
    return list(changed.pieces)


def _cells(board: Board, pieces: list[Piece]) -> Iterator[tuple[Piece, list[Piece]]]:
    """Give the cells round two Steiner vertices with an edge between them: ring and pieces."""
    around: dict[int, dict[Piece, None]] = {}
    for piece in pieces:
        for vertex in piece:
            around.setdefault(vertex, {})[piece] = None
    for a, b in dict.fromkeys(edge for piece in pieces for edge in edges_of(piece)):
        if board.n <= a < b:
            near = list(around[a] | around[b])
            ring = outline(near)
            if ring is not None and len(ring) <= LARGE and {a, b}.isdisjoint(ring):
                yield ring, near
