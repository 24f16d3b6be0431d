"""A tiling in change: moves put pieces in the place of others, and what they touch is looked at again.

What has been offered once is not offered again as long as it stays as it is: either the move was made, or
it was found wrong, and what has been found out about rings stays true. So a round of moves costs as much as
the round before has changed.
"""

from collections.abc import Iterable, Sequence

import numpy as np

from starskel.decomposition.board import Board
from starskel.decomposition.pieces import Around, Piece, chain_after, edges_of, from_least
from starskel.task import Task

Union = tuple[tuple[Piece, Piece], Piece]
"""Two neighbours, and the ring round both."""


class Tiling:
    """Pieces that tile a cell, with what lies across their edges and round their Steiner vertices."""

    def __init__(self, board: Board, pieces: Iterable[Piece]) -> None:
        self.pieces: dict[Piece, None] = {}
        self._board = board
        self._owner: dict[tuple[int, int], Piece] = {}
        self._around: dict[int, dict[Piece, None]] = {}
        self._new: dict[Piece, None] = {}
        self._touched: set[int] = set()
        for piece in pieces:
            self._put(piece)

    def unions(self, task: Task) -> list[Union]:
        """Give the rings that may be star pieces round neighbours of which one at least is new.

        Those across the longest edges come first.
        """
        edges, known = {}, self._board.unions
        for piece in self._new:
            task.reach(0)
            for a, b in edges_of(piece):
                if (b, a) in self._owner:
                    edge = (a, b) if a < b else (b, a)
                    pair = self._owner[edge], self._owner[edge[::-1]]
                    if pair not in known:
                        known[pair] = union(*pair)
                    if (ring := known[pair]) is not None:
                        edges[edge] = pair, ring
        self._new = {}
        return [edges[edge] for edge in _longest_first(self._board, sorted(edges))]

    def stars(self, task: Task) -> list[Around]:
        """Give the Steiner vertices that moves have touched, the last placed first, with the pieces round."""
        touched, self._touched = sorted(self._touched, reverse=True), set()
        stars = []
        for vertex in touched:
            task.reach(0)
            if near := self._around[vertex]:
                stars.append((vertex, tuple(near)))
        return stars

    def make(self, moves: Iterable[tuple[Iterable[Piece], Iterable[Piece]]]) -> bool:
        """Put pieces in the place of others, move by move, unless these are gone already."""
        made = False
        for before, after in moves:
            if all(piece in self.pieces for piece in before):
                for piece in before:
                    self._take(piece)
                for piece in after:
                    self._put(piece)
                made = True
        return made

    def _put(self, piece: Piece) -> None:
        self.pieces[piece] = self._new[piece] = None
        self._owner.update(dict.fromkeys(edges_of(piece), piece))
        for vertex in piece:
            if vertex >= self._board.n:
                self._around.setdefault(vertex, {})[piece] = None
                self._touched.add(vertex)

    def _take(self, piece: Piece) -> None:
        del self.pieces[piece]
        self._new.pop(piece, None)
        for edge in edges_of(piece):
            del self._owner[edge]
        for vertex in piece:
            if vertex >= self._board.n:
                del self._around[vertex][piece]
                self._touched.add(vertex)


def _longest_first(board: Board, edges: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    ends = np.array(edges, dtype=np.intp).reshape(-1, 2)
    length = np.abs(board.at[:, ends[:, 0]] - board.at[:, ends[:, 1]]).sum(axis=0)
    return [edges[k] for k in np.argsort(-length, kind="stable").tolist()]


def union(first: Piece, second: Piece) -> Piece | None:
    """Give the ring round two neighbours, None where they enclose something or touch twice."""
    common = set(first).intersection(second)
    if len(common) == 2:  # so it is nearly always: they touch along one edge
        return _across_edge(first, second, *common)
    return outline([first, second])


def outline(pieces: Iterable[Piece]) -> Piece | None:
    """Give the ring round pieces, None where they enclose something or it touches itself."""
    edges = [edge for piece in pieces for edge in edges_of(piece)]
    inner = set(edges) & {(b, a) for a, b in edges}
    outer = [edge for edge in edges if edge not in inner]
    onward = dict(outer)
    if len(onward) < len(outer):
        return None
    ring = [outer[0][0]]
    while (following := onward[ring[-1]]) != ring[0]:
        ring.append(following)
    return from_least(tuple(ring)) if len(ring) == len(outer) else None


def _across_edge(first: Piece, second: Piece, a: int, b: int) -> Piece:
    """Give the ring round two pieces that have the ends of an edge in common, and no other vertices."""
    if chain_after(first, a)[0] != b:
        a, b = b, a
    return from_least(chain_after(first, a) + chain_after(second, b))
