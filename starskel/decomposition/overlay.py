"""The last rung: two triangulations laid over each other (Aronov, Seidel, Souvaine 1993).

Both polygons are thought of as one convex polygon, where each triangulation is a set of chords. Crossings of
chords become Steiner vertices and the cells between chords the pieces. Every piece lies in one triangle of
the source and in one of the target, so it is convex in both. Which chords cross, and in what order, depends
on indices alone. A crossing is pulled back to the diagonal of the source's triangulation and to that of the
target's; any places in the right order do, so they are spread evenly.
"""

from itertools import pairwise

import numpy as np

from starskel.arrays import Flags, Floats, Indices
from starskel.decomposition.board import Board
from starskel.decomposition.pieces import Piece
from starskel.triangulation import Triangulation


def overlay(board: Board, cell: Piece, source: Triangulation, target: Triangulation) -> list[Piece]:
    """Tile a cell, given triangulated in both polygons, by pieces that are convex in both.

    Each crossing of diagonals becomes a Steiner vertex.
    """
    n = len(cell)
    first, second = _chords(source), _chords(target)
    crossing = _crossing(first, second)
    count = int(crossing.sum())
    names = np.where(crossing, n - 1 + np.cumsum(crossing).reshape(crossing.shape), -1)
    lines = _lines(n, first, second, names)
    across = _lines(n, second, first, names.T)
    drawn = {(line[0], line[-1]) for line in lines if len(line) == 2}  # chords of both triangulations
    faces = _faces(n, [*lines, *(line for line in across if (line[0], line[-1]) not in drawn)])
    placed = board.place(_spread(source.vertices, lines, count), _spread(target.vertices, across, count))
    rows = [*cell, *placed]
    return [tuple(rows[v] for v in face) for face in faces]


def crossings(source: Triangulation, target: Triangulation) -> list[int]:
    """Count for each ring the Steiner vertices that an overlay of its two triangulations needs."""
    sides = []
    for ground in (source, target):
        found = _chords(ground)
        ends = np.searchsorted(found[:, 0], ground.rings.last)
        sides.append(np.split(found, ends[:-1]))
    return [int(_crossing(*both).sum()) for both in zip(*sides, strict=True)]


def _chords(ground: Triangulation) -> Indices:
    """Give the diagonals of a triangulation, (k, 2), lower index first, sorted."""
    a, b = ground.starts, ground.ends
    inner = (ground.twins >= 0) & (a < b)
    return np.unique(np.stack([a[inner], b[inner]], axis=1), axis=0)


def _crossing(first: Indices, second: Indices) -> Flags:
    a, b = (first[:, None, side] for side in (0, 1))
    c, d = (second[None, :, side] for side in (0, 1))
    crossing: Flags = ((a < c) & (c < b) & (b < d)) | ((c < a) & (a < d) & (d < b))
    return crossing


def _lines(n: int, chords: Indices, others: Indices, names: Indices) -> list[list[int]]:
    """Give each chord as the vertices along it: its ends, and between them its crossings in order.

    The others do not cross each other, so they cross a chord in the order of their ends.
    """
    lines = []
    for (a, b), row in zip(chords.tolist(), names, strict=True):
        crossed = np.flatnonzero(row >= 0)
        c, d = others[crossed].T
        between = (a < c) & (c < b)
        near, far = np.where(between, c, d), np.where(between, d, c)
        order = np.argsort(near - a + (a - far) % n)
        lines.append([a, *row[crossed[order]].tolist(), b])
    return lines


def _spread(ring: Floats, lines: list[list[int]], count: int) -> Floats:
    """Place the inner vertices of lines evenly between their ends."""
    n = len(ring)
    placed = np.empty((count, 2))
    for start, *inner, end in lines:
        share = (np.arange(len(inner)) + 1)[:, None] / (len(inner) + 1)
        placed[np.array(inner, dtype=np.intp) - n] = (1 - share) * ring[start] + share * ring[end]
    return placed


def _faces(n: int, lines: list[list[int]]) -> tuple[Piece, ...]:
    """Give the faces between the ring and the lines, from the order of the edges round each vertex."""
    around = _fans(n, lines)
    onward = {}
    for vertex, fan in around.items():
        for before, after in zip(fan, fan[1:] + fan[:1], strict=True):
            onward[after, vertex] = before  # arriving from `after`, the next edge clockwise goes to `before`
    faces = []
    waiting = dict.fromkeys((a, b) for a, b in onward if not (b < n and a == (b + 1) % n))
    while waiting:
        edge = next(iter(waiting))
        face = []
        while edge in waiting:
            del waiting[edge]
            face.append(edge[0])
            edge = edge[1], onward[edge]
        faces.append(tuple(face))
    return tuple(faces)


def _fans(n: int, lines: list[list[int]]) -> dict[int, list[int]]:
    """Give each vertex's neighbours counter-clockwise: in the order of the ring vertices they lead to."""
    ahead: dict[int, list[tuple[int, int]]] = {}
    for v in range(n):
        ahead[v] = [(1, (v + 1) % n), (n - 1, (v - 1) % n)]
    for line in lines:
        for way in (line, line[::-1]):
            for vertex, following in pairwise(way):
                base = vertex if vertex < n else 0
                ahead.setdefault(vertex, []).append(((way[-1] - base) % n, following))
    return {vertex: [following for _, following in sorted(ways)] for vertex, ways in ahead.items()}
