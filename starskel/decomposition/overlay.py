"""The last rung: two triangulations laid over each other (Aronov, Seidel, Souvaine 1993).

Both polygons are thought of as one convex polygon, where each triangulation is a set of chords. Crossings of
chords become Steiner vertices and the cells between chords the pieces. Every piece lies in one triangle of
the source and in one of the target, so it is convex in both. Which chords cross, and in what order, depends
on indices alone. A crossing is pulled back to the diagonal of the source's triangulation and to that of the
target's; any places in the right order do, so they are spread evenly.
"""

from itertools import pairwise

import numpy as np

from starskel.decomposition.minimal import Piece
from starskel.decomposition.tiling import Tiling
from starskel.points import Indices
from starskel.predicates import Floats
from starskel.triangulation import Triangulation

Chord = tuple[int, int]


def overlay(tiling: Tiling, piece: Piece, source: Triangulation, target: Triangulation) -> Tiling:
    """Replace a piece, given triangulated in both polygons, by pieces that are convex in both.

    Each crossing of diagonals becomes a Steiner vertex.
    """
    n = len(piece)
    first, second = _chords(source), _chords(target)
    names = _name_crossings(first, second, n)
    tracks = {chord: _crossed(chord, second, n) for chord in first}
    lines = [[a, *(names[(a, b), o] for o in tracks[a, b]), b] for a, b in first]
    across = [[a, *(names[o, (a, b)] for o in _crossed((a, b), first, n)), b] for a, b in second]
    faces = _faces(n, [*lines, *(line for line in across if not _doubled(line, tracks))])
    rows = [*piece, *(len(tiling.source.coordinates) + np.arange(len(names))).tolist()]
    return tiling.replace(
        piece,
        [tuple(rows[v] for v in face) for face in faces],
        _spread(source.vertices, lines, len(names)),
        _spread(target.vertices, across, len(names)),
    )


def crossings(source: Triangulation, target: Triangulation) -> int:
    """Count the Steiner vertices that an overlay of two triangulations needs."""
    return len(_name_crossings(_chords(source), _chords(target), len(source.ring)))


def _chords(ground: Triangulation) -> list[Chord]:
    a, b = ground.triangles.ravel(), np.roll(ground.triangles, -1, axis=1).ravel()
    inner = (ground.twins >= 0) & (a < b)
    return sorted(zip(a[inner].tolist(), b[inner].tolist(), strict=True))


def _name_crossings(first: list[Chord], second: list[Chord], n: int) -> dict[tuple[Chord, Chord], int]:
    """Give each crossing of a first with a second chord its row among the vertices."""
    crossing = _crossing(np.array(first).reshape(-1, 2), np.array(second).reshape(-1, 2))
    return {(first[i], second[j]): n + at for at, (i, j) in enumerate(np.argwhere(crossing).tolist())}


def _crossing(first: Indices, second: Indices) -> np.ndarray:
    a, b = (first[:, None, side] for side in (0, 1))
    c, d = (second[None, :, side] for side in (0, 1))
    crossing: np.ndarray = ((a < c) & (c < b) & (b < d)) | ((c < a) & (a < d) & (d < b))
    return crossing


def _crossed(chord: Chord, others: list[Chord], n: int) -> list[Chord]:
    """Give the chords that cross this one, in order from its start; they do not cross each other."""
    a, b = chord

    def way(other: Chord) -> int:
        near, far = other if a < other[0] < b else other[::-1]
        return (near - a) + (a - far) % n

    return sorted((o for o in others if _crossing(np.array([chord]), np.array([o])).item()), key=way)


def _spread(ring: Floats, lines: list[list[int]], count: int) -> Floats:
    """Place the inner vertices of lines evenly between their ends."""
    n = len(ring)
    placed = np.empty((count, 2))
    for start, *inner, end in lines:
        share = (np.arange(len(inner)) + 1)[:, None] / (len(inner) + 1)
        placed[np.array(inner, dtype=np.intp) - n] = (1 - share) * ring[start] + share * ring[end]
    return placed


def _doubled(line: list[int], tracks: dict[Chord, list[Chord]]) -> bool:
    """Tell whether a chord stands in both triangulations, and so has been drawn."""
    return len(line) == 2 and (line[0], line[1]) in tracks


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
