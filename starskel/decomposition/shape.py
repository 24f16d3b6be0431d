"""Better-shaped pieces: every Steiner vertex goes to where the smallest kernel round it is largest.

The kernel of a piece is measured against the piece: its area over the square of the piece's perimeter. In
rounds every Steiner vertex tries places round its own, in the source or in the target, and takes the one
that is best for the worst of its pieces there. A move is made only if exact predicates prove all its pieces.
"""

import numpy as np

from starskel.decomposition.kernel import star_points
from starskel.decomposition.pieces import Piece, edges_of
from starskel.decomposition.tiling import Tiling
from starskel.outline import edge_lengths
from starskel.points import Points
from starskel.predicates import Floats
from starskel.task import Task

STRIDES = (0.4, 0.25, 0.15, 0.1, 0.06)
"""How far a vertex tries to go in each round, in distances to its neighbours."""

WAYS = 8
"""In so many directions."""

WORTH = 1.02
"""A move has to make the smallest kernel larger by this factor."""


def shaped(tiling: Tiling, n: int, task: Task) -> Tiling:
    """Give a tiling of the same two n-gons by the same pieces, with Steiner vertices in better places.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    for stride in STRIDES:
        for side in (0, 1):
            task.reach(0)
            tiling = _moved(tiling, n, side, stride, task)
    return tiling


def _moved(tiling: Tiling, n: int, side: int, stride: float, task: Task) -> Tiling:
    """Move Steiner vertices on one side, no two of the same piece.

    A piece that is seen whole only from a common vertex is left alone: another kernel may not contain it.
    """
    points = (tiling.source, tiling.target)[side]
    around = _around(tiling, n)
    neighbours = list(dict.fromkeys(piece for pieces in around.values() for piece in pieces))
    stars = tiling.are_stars(neighbours, task)
    touched = {piece for piece, star in zip(neighbours, stars, strict=True) if not star}
    moves: dict[int, Floats] = {}
    for vertex, pieces in sorted(around.items()):
        task.reach(0)
        place = _better(points, vertex, pieces, stride) if touched.isdisjoint(pieces) else None
        if place is not None:
            moves[vertex] = place
            touched.update(pieces)
    return _renamed(tiling, moves, side) if moves else tiling


def _around(tiling: Tiling, n: int) -> dict[int, list[Piece]]:
    """Give the pieces round each Steiner vertex."""
    around: dict[int, list[Piece]] = {}
    for piece in tiling.pieces:
        for vertex in piece:
            if vertex >= n:
                around.setdefault(vertex, []).append(piece)
    return around


def _better(points: Points, vertex: int, pieces: list[Piece], stride: float) -> Floats | None:
    """Give the best place for a vertex among those around its own, None if that is as good as any."""
    tried = points.with_free(_places(points, vertex, pieces, stride))
    rows = [vertex, *range(len(points.coordinates), len(tried.coordinates))]
    rings = [np.array([row if v == vertex else v for v in piece]) for row in rows for piece in pieces]
    _, areas = star_points(tried, rings)
    perimeters = np.array([edge_lengths(tried.coordinates[ring]).sum() for ring in rings])
    worth = (areas / perimeters**2).reshape(len(rows), -1).min(axis=1)
    best = int(worth.argmax())
    return tried.coordinates[rows[best]] if worth[best] > WORTH * worth[0] else None


def _places(points: Points, vertex: int, pieces: list[Piece], stride: float) -> Floats:
    """Give the places round a vertex, the first towards its first neighbour: so they turn with the shape."""
    edges = [edge for piece in pieces for edge in edges_of(piece) if vertex in edge]
    neighbours = sorted({v for edge in edges for v in edge} - {vertex})
    ways = (points.coordinates[neighbours] - points.coordinates[vertex]).view(np.complex128)[:, 0]
    step = stride * np.abs(ways).mean() * np.sign(ways[0])
    turns = np.exp(2j * np.pi / WAYS * np.arange(WAYS))
    places: Floats = points.coordinates[vertex] + (step * turns)[:, None].view(np.float64)
    return places


def _renamed(tiling: Tiling, moves: dict[int, Floats], side: int) -> Tiling:
    """Put vertices that were moved on one side in the place of old ones; on the other side they stay."""
    names = {vertex: len(tiling.source.coordinates) + at for at, vertex in enumerate(moves)}
    places, rows = np.array(list(moves.values())), np.array(list(moves))
    source = tiling.source.again(rows) if side else tiling.source.with_free(places)
    target = tiling.target.with_free(places) if side else tiling.target.again(rows)
    return Tiling(source, target, tuple(tuple(names.get(v, v) for v in piece) for piece in tiling.pieces))
