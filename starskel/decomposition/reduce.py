"""Fewer Steiner vertices and fewer pieces: vertices collapse into neighbours, pieces merge, all stays right.

Both moves keep the edges cancelling in pairs, so the pieces go on tiling both polygons as long as each of
them is simple and counter-clockwise in both (see verify.py).
"""

from itertools import pairwise

import numpy as np

from starskel.decomposition.minimal import Piece
from starskel.decomposition.tiling import Tiling
from starskel.polygon import crossing_edges, signed_area
from starskel.task import Task


def reduce(tiling: Tiling, n: int, task: Task) -> Tiling:
    """Give a tiling of the same two n-gons with fewer, or as many, Steiner vertices and pieces.

    Points that no piece uses stay behind.
    """
    while True:
        pieces = list(tiling.pieces)
        _collapse_all(tiling, pieces, n, task)
        _merge_all(tiling, pieces, task)
        reduced = Tiling(tiling.source, tiling.target, tuple(pieces))
        if len(pieces) == len(tiling.pieces):
            return reduced
        tiling = reduced


def _collapse_all(tiling: Tiling, pieces: list[Piece], n: int, task: Task) -> None:
    """Collapse every Steiner vertex into a neighbour where that can be done."""
    for vertex in sorted({v for piece in pieces for v in piece if v >= n}, reverse=True):
        task.reach(0)
        around = [piece for piece in pieces if vertex in piece]
        neighbours = sorted({v for piece in around for v in _neighbours(piece, vertex)})
        for neighbour in neighbours:
            shrunk = [_renamed(piece, vertex, neighbour) for piece in around]
            if all(piece is not None and (not piece or _holds(tiling, piece)) for piece in shrunk):
                pieces[:] = [piece for piece in pieces if vertex not in piece]
                pieces += [piece for piece in shrunk if piece]
                break


def _neighbours(piece: Piece, vertex: int) -> tuple[int, int]:
    at = piece.index(vertex)
    return piece[at - 1], piece[(at + 1) % len(piece)]


def _renamed(piece: Piece, vertex: int, name: int) -> Piece | None:
    """Give the piece with a vertex moved onto another: () if nothing is left of it, None if it is torn."""
    renamed = [name if v == vertex else v for v in piece]
    kept = tuple(v for before, v in pairwise([renamed[-1], *renamed]) if v != before)
    if len(set(kept)) < len(kept):
        return None
    return kept if len(kept) > 2 else ()


def _holds(tiling: Tiling, piece: Piece) -> bool:
    """Tell whether a ring of vertices is a star piece in both polygons."""
    rings = [side.coordinates[list(piece)] for side in (tiling.source, tiling.target)]
    if any(signed_area(ring) <= 0 for ring in rings) or any(len(crossing_edges(ring)) for ring in rings):
        return False
    return tiling.is_star(piece)


def _merge_all(tiling: Tiling, pieces: list[Piece], task: Task) -> None:
    """Merge neighbours while the union is a star piece, across the longest edges first."""
    refused: set[tuple[Piece, Piece]] = set()
    merged = True
    while merged:
        merged = False
        for pair in _neighbouring(tiling, pieces):
            task.reach(0)
            if pair in refused or not (pair[0] in pieces and pair[1] in pieces):
                continue
            whole = union(*pair)
            if whole is not None and tiling.is_star(whole):
                pieces.remove(pair[0])
                pieces[pieces.index(pair[1])] = whole
                merged = True
            else:
                refused.add(pair)


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
    return tuple(ring) if len(ring) == len(outer) else None


def _edges(piece: Piece) -> list[tuple[int, int]]:
    return list(pairwise((*piece, piece[0])))
