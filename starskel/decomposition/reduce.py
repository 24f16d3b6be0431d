"""Fewer Steiner vertices and fewer pieces: vertices collapse into neighbours, pieces merge, all stays right.

Both moves keep the edges cancelling in pairs, so the pieces go on tiling both polygons as long as each of
them is simple and counter-clockwise in both (see verify.py).
"""

from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise

import numpy as np

from starskel.decomposition.pieces import Piece, edges_of
from starskel.decomposition.tiling import Tiling
from starskel.task import Task

AT_ONCE = 1 << 12
"""Vertices of rings that are looked at between two questions whether to stop."""

SIDES_AT_ONCE = 1 << 16
"""Pairs of a vertex and an edge that are looked at between two such questions."""


def reduce(tiling: Tiling, n: int, task: Task) -> Tiling:
    """Give a tiling of the same two n-gons with fewer, or as many, Steiner vertices and pieces.

    Points that no piece uses stay behind.
    """
    reduction = _Reduction(tiling, n, task)
    while reduction.merge() | reduction.collapse():
        pass
    return Tiling(tiling.source, tiling.target, tuple(reduction.pieces))


class _Reduction:
    """Pieces in change, in rounds of moves that do not touch one another.

    What a round may ask about rings is found out for all of them together, and remembered.
    """

    def __init__(self, tiling: Tiling, n: int, task: Task) -> None:
        self.pieces = dict.fromkeys(tiling.pieces)
        self._tiling = tiling
        self._n = n
        self._task = task
        self._stars: dict[Piece, bool] = {}
        self._common: dict[Piece, bool] = {}
        self._unions: dict[tuple[Piece, Piece], Piece | None] = {}
        self._shrunk: dict[tuple[int, tuple[Piece, ...]], list[list[Piece]]] = {}

    def merge(self) -> bool:
        """Merge neighbours whose union is a star piece, if only from a vertex, the longest edges first."""
        neighbours = _neighbouring(self._tiling, self.pieces)
        for pair in neighbours:
            if pair not in self._unions:
                self._unions[pair] = union(*pair)
        unions = [self._unions[pair] for pair in neighbours]
        self._look_at(ring for ring in unions if ring is not None)
        self._look_for_common_vertices(ring for ring in unions if ring is not None and not self._stars[ring])
        merged = False
        for pair, ring in zip(neighbours, unions, strict=True):
            if ring is not None and (self._stars[ring] or self._common[ring]):
                merged |= self._replace(pair, [ring])
        return merged

    def collapse(self) -> bool:
        """Collapse Steiner vertices into neighbours."""
        around: dict[int, list[Piece]] = {}
        for piece in self.pieces:
            for vertex in piece:
                if vertex >= self._n:
                    around.setdefault(vertex, []).append(piece)
        moves = [
            (pieces, shrunk)
            for vertex, pieces in sorted(around.items(), reverse=True)
            for shrunk in self._collapses(vertex, pieces)
        ]
        self._look_at(ring for _, shrunk in moves for ring in shrunk)
        collapsed = False
        for pieces, shrunk in moves:
            if all(self._stars[ring] for ring in shrunk):
                collapsed |= self._replace(pieces, shrunk)
        return collapsed

    def _collapses(self, vertex: int, pieces: list[Piece]) -> list[list[Piece]]:
        key = vertex, tuple(pieces)
        if key not in self._shrunk:
            self._shrunk[key] = _collapses(vertex, pieces)
        return self._shrunk[key]

    def _replace(self, before: Iterable[Piece], after: Iterable[Piece]) -> bool:
        """Put pieces in the place of others, unless one of these is gone already."""
        if not all(piece in self.pieces for piece in before):
            return False
        for piece in before:
            del self.pieces[piece]
        self.pieces.update(dict.fromkeys(after))
        return True

    def _look_at(self, rings: Iterable[Piece]) -> None:
        """Find out which rings are simple, counter-clockwise and star-shaped in both polygons."""
        for part in self._parts({ring for ring in rings if ring not in self._stars}, AT_ONCE, len):
            stars = self._tiling.have_kernels(part, self._task.quiet)
            self._stars.update(zip(part, stars.tolist(), strict=True))

    def _look_for_common_vertices(self, rings: Iterable[Piece]) -> None:
        """Find out which unions of pieces are seen whole from a common vertex."""
        unknown = {ring for ring in rings if ring not in self._common}
        for part in self._parts(unknown, SIDES_AT_ONCE, lambda ring: len(ring) ** 2):
            common = self._tiling.have_common_star_vertices(part, self._task.quiet)
            self._common.update(zip(part, common.tolist(), strict=True))

    def _parts(self, rings: set[Piece], most: int, work: Callable[[Piece], int]) -> Iterator[list[Piece]]:
        """Cut rings, the short ones first, into handfuls of so much work or of one ring."""
        waiting = sorted(rings, key=lambda ring: (len(ring), ring))
        while waiting:
            self._task.reach(0)
            ends = np.cumsum([work(ring) for ring in waiting])
            count = 1 + int(np.searchsorted(ends[1:], most))
            yield waiting[:count]
            waiting = waiting[count:]


def _collapses(vertex: int, around: list[Piece]) -> list[list[Piece]]:
    """Give what becomes of the pieces round a vertex where it is moved onto each of its neighbours."""
    moves = []
    for neighbour in sorted({v for piece in around for v in _neighbours(piece, vertex)}):
        shrunk = [_renamed(piece, vertex, neighbour) for piece in around]
        if None not in shrunk:
            moves.append([piece for piece in shrunk if piece])
    return moves


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


def _neighbouring(tiling: Tiling, pieces: Iterable[Piece]) -> list[tuple[Piece, Piece]]:
    owner = {edge: piece for piece in pieces for edge in edges_of(piece)}
    shared = sorted((a, b) for a, b in owner if a < b and (b, a) in owner)
    ends = np.array(shared, dtype=np.intp).reshape(-1, 2)
    length = np.zeros(len(ends))
    for side in (tiling.source, tiling.target):
        length += np.hypot(*(side.coordinates[ends[:, 0]] - side.coordinates[ends[:, 1]]).T)
    longest_first = np.argsort(-length, kind="stable")
    return [(owner[a, b], owner[b, a]) for a, b in (shared[i] for i in longest_first)]


def union(first: Piece, second: Piece) -> Piece | None:
    """Give the ring round two neighbours, None where they enclose something or touch twice."""
    edges = edges_of(first) + edges_of(second)
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
