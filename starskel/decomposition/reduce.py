"""Fewer Steiner vertices and fewer pieces: vertices collapse into neighbours, pieces merge, all stays right.

Both moves keep the edges cancelling in pairs, so the pieces go on tiling both polygons as long as each of
them is simple and counter-clockwise in both (see verify.py).
"""

from itertools import pairwise

import numpy as np

from starskel.decomposition.minimal import Piece
from starskel.decomposition.tiling import Tiling
from starskel.outline import signed_areas
from starskel.polygon import crossing_edges
from starskel.task import Task


def reduce(tiling: Tiling, n: int, task: Task) -> Tiling:
    """Give a tiling of the same two n-gons with fewer, or as many, Steiner vertices and pieces.

    Points that no piece uses stay behind.
    """
    reduction = _Reduction(tiling, n, task)
    while reduction.merge() | reduction.collapse():
        pass
    return Tiling(tiling.source, tiling.target, tuple(reduction.pieces))


class _Reduction:
    """Pieces in change; what was found out about a ring of vertices is remembered."""

    def __init__(self, tiling: Tiling, n: int, task: Task) -> None:
        self.pieces = list(tiling.pieces)
        self._tiling = tiling
        self._n = n
        self._task = task
        self._stars: dict[Piece, bool] = {}
        self._pieces: dict[Piece, bool] = {}

    def merge(self) -> bool:
        """Merge neighbours while the union is a star piece, across the longest edges first."""
        merged = False
        for first, second in _neighbouring(self._tiling, self.pieces):
            self._task.reach(0)
            if first not in self.pieces or second not in self.pieces:
                continue
            whole = union(first, second)
            if whole is not None and self._is_star(whole):
                self.pieces.remove(first)
                self.pieces[self.pieces.index(second)] = whole
                merged = True
        return merged

    def collapse(self) -> bool:
        """Collapse every Steiner vertex into a neighbour where that can be done."""
        vertices = sorted({v for piece in self.pieces for v in piece if v >= self._n}, reverse=True)
        return True in [self._collapse(vertex) for vertex in vertices]

    def _collapse(self, vertex: int) -> bool:
        self._task.reach(0)
        around = [piece for piece in self.pieces if vertex in piece]
        for neighbour in sorted({v for piece in around for v in _neighbours(piece, vertex)}):
            shrunk = [_renamed(piece, vertex, neighbour) for piece in around]
            if None not in shrunk and all(self._is_piece(piece) for piece in shrunk if piece):
                self.pieces = [piece for piece in self.pieces if vertex not in piece]
                self.pieces += [piece for piece in shrunk if piece]
                return True
        return False

    def _is_star(self, piece: Piece) -> bool:
        if piece not in self._stars:
            self._stars[piece] = self._tiling.is_star(piece)
        return self._stars[piece]

    def _is_piece(self, piece: Piece) -> bool:
        """Tell whether a ring of vertices is simple, counter-clockwise and star-shaped in both polygons."""
        if piece not in self._pieces:
            rings = [side.coordinates[list(piece)] for side in (self._tiling.source, self._tiling.target)]
            self._pieces[piece] = (
                all(signed_areas(ring) > 0 for ring in rings)
                and not self._tiling.is_flat(piece)
                and self._is_star(piece)
                and not any(len(crossing_edges(ring)) for ring in rings)  # last, as it takes longest
            )
        return self._pieces[piece]


def _neighbours(piece: Piece, vertex: int) -> tuple[int, int]:
    at = piece.index(vertex)
    return piece[at - 1], piece[(at + 1) % len(piece)]


def _renamed(piece: Piece, vertex: int, name: int) -> Piece | None:
    """Give the piece with a vertex moved onto another: () if nothing is left of it, None if it is torn."""
    renamed = [name if v == vertex else v for v in piece]
    kept = tuple(v for before, v in pairwise([renamed[-1], *renamed]) if v != before)
    if len(set(kept)) < len(kept):
        return None
    return _from_least(kept) if len(kept) > 2 else ()


def _neighbouring(tiling: Tiling, pieces: list[Piece]) -> list[tuple[Piece, Piece]]:
    owner = {edge: piece for piece in pieces for edge in _edges(piece)}
    shared = sorted((a, b) for a, b in owner if a < b and (b, a) in owner)
    ends = np.array(shared, dtype=np.intp).reshape(-1, 2)
    length = np.zeros(len(ends))
    for side in (tiling.source, tiling.target):
        length += np.hypot(*(side.coordinates[ends[:, 0]] - side.coordinates[ends[:, 1]]).T)
    longest_first = np.argsort(-length, kind="stable")
    return [(owner[a, b], owner[b, a]) for a, b in (shared[i] for i in longest_first)]


def union(first: Piece, second: Piece) -> Piece | None:
    """Give the ring round two neighbours, None where they enclose something or touch twice."""
    edges = _edges(first) + _edges(second)
    inner = set(edges) & {(b, a) for a, b in edges}
    outer = [edge for edge in edges if edge not in inner]
    onward = dict(outer)
    if len(onward) < len(outer):
        return None
    ring = [outer[0][0]]
    while (following := onward[ring[-1]]) != ring[0]:
        ring.append(following)
    return _from_least(tuple(ring)) if len(ring) == len(outer) else None


def _from_least(piece: Piece) -> Piece:
    """Give the ring from its least vertex on, so that one ring has one name."""
    start = piece.index(min(piece))
    return piece[start:] + piece[:start]


def _edges(piece: Piece) -> list[tuple[int, int]]:
    return list(pairwise((*piece, piece[0])))
