"""Fewer Steiner vertices and fewer pieces: vertices collapse into neighbours, pieces merge, all stays right.

Both moves keep the edges cancelling in pairs, so the pieces go on tiling both polygons as long as each of
them is simple and counter-clockwise in both (see verify.py).
"""

from collections.abc import Iterable, Sequence

import numpy as np

from starskel.decomposition.board import AT_ONCE, Board
from starskel.decomposition.collapse import collapses
from starskel.decomposition.pieces import Around, Piece, chain_after, edges_of, from_least
from starskel.rings import blocks
from starskel.task import Task


def reduce(board: Board, tilings: Sequence[list[Piece]], task: Task) -> list[list[Piece]]:
    """Give tilings of the same polygons or cells with fewer, or as many, Steiner vertices and pieces.

    The tilings are independent of each other. They are worked on together, in rounds of moves that do not
    touch one another, so that all rings of a round can be looked at at once.
    """
    every = [_Reduction(board, pieces) for pieces in tilings]
    changing = every
    while changing:
        merged = _merge(board, changing, task)
        collapsed = _collapse(board, changing, task)
        changing = [
            reduction for reduction, *any_ in zip(changing, merged, collapsed, strict=True) if any(any_)
        ]
    return [list(reduction.pieces) for reduction in every]


def _merge(board: Board, reductions: list["_Reduction"], task: Task) -> list[bool]:
    """Merge neighbours whose union is a star piece, if only from a vertex, the longest edges first."""
    unions = [reduction.unions() for reduction in reductions]
    rings = [ring for found in unions for _, ring in found]
    stars = dict(zip(rings, board.have_kernels(rings, task), strict=True))
    left = [ring for ring in rings if not stars[ring]]
    stars.update(zip(left, board.have_common_star_vertices(left, task), strict=True))
    board.unions.update((pair, None) for found in unions for pair, ring in found if not stars[ring])
    moves = [[(pair, [ring]) for pair, ring in found if stars[ring]] for found in unions]
    return [reduction.make(found) for reduction, found in zip(reductions, moves, strict=True)]


def _collapse(board: Board, reductions: list["_Reduction"], task: Task) -> list[bool]:
    """Collapse Steiner vertices into neighbours."""
    stars = [reduction.stars() for reduction in reductions]
    unknown = dict.fromkeys(star for found in stars for star in found if star not in board.collapses)
    waiting = list(unknown)
    for part in blocks(np.array([sum(map(len, pieces)) for _, pieces in waiting]), AT_ONCE):
        board.collapses.update(collapses(board, waiting[part], task.quiet))
    moves = [[(star[1], shrunk) for star in found for shrunk in board.collapses[star]] for found in stars]
    return [reduction.make(found) for reduction, found in zip(reductions, moves, strict=True)]


class _Reduction:
    """Pieces in change."""

    def __init__(self, board: Board, pieces: Iterable[Piece]) -> None:
        self.pieces = dict.fromkeys(pieces)
        self._board = board

    def unions(self) -> list[tuple[tuple[Piece, Piece], Piece]]:
        """Give the rings round neighbours that may be star pieces, those across the longest edges first."""
        owner = {edge: piece for piece in self.pieces for edge in edges_of(piece)}
        known = self._board.unions
        hopeful = []
        for a, b in sorted(owner):
            if a < b and (b, a) in owner:
                pair = owner[a, b], owner[b, a]
                if pair not in known:
                    known[pair] = union(*pair)
                if (ring := known[pair]) is not None:
                    hopeful.append(((a, b), pair, ring))
        order = _longest_first(self._board, [edge for edge, _, _ in hopeful])
        return [hopeful[k][1:] for k in order]

    def stars(self) -> list[Around]:
        """Give the Steiner vertices, the last placed first, and the pieces round each."""
        around: dict[int, list[Piece]] = {}
        for piece in self.pieces:
            for vertex in piece:
                if vertex >= self._board.n:
                    around.setdefault(vertex, []).append(piece)
        return [(vertex, tuple(pieces)) for vertex, pieces in sorted(around.items(), reverse=True)]

    def make(self, moves: Iterable[tuple[Iterable[Piece], Iterable[Piece]]]) -> bool:
        """Put pieces in the place of others, move by move, unless these are gone already."""
        made = False
        for before, after in moves:
            if all(piece in self.pieces for piece in before):
                for piece in before:
                    del self.pieces[piece]
                self.pieces.update(dict.fromkeys(after))
                made = True
        return made


def _longest_first(board: Board, edges: Sequence[tuple[int, int]]) -> list[int]:
    ends = np.array(edges, dtype=np.intp).reshape(-1, 2)
    length = np.abs(board.at[:, ends[:, 0]] - board.at[:, ends[:, 1]]).sum(axis=0)
    order: list[int] = np.argsort(-length, kind="stable").tolist()
    return order


def union(first: Piece, second: Piece) -> Piece | None:
    """Give the ring round two neighbours, None where they enclose something or touch twice."""
    common = set(first).intersection(second)
    if len(common) == 2:  # so it is nearly always: they touch along one edge
        return _across_edge(first, second, *common)
    edges = edges_of(first) + edges_of(second)
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
