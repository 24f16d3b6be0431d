"""Placing one Steiner vertex: a fan round it is a star piece, and what it does not see is left in pockets."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.decomposition.pieces import Piece
from starskel.decomposition.tiling import Tiling
from starskel.predicates import Floats, Relation
from starskel.task import Task
from starskel.triangulation import Grounds, Triangulation
from starskel.visibility import visibility_from

EASY = 2
"""A pocket of so many hidden vertices is a pentagon at most, and every pentagon is star-shaped."""

MOST_PLACES = 300
"""Candidates kept in each polygon, those that see most; all pairs of them are compared."""

MOST_SAMPLES = 3000
"""Places that are looked at in each polygon, one at least in each triangle."""

_AT_ONCE = 1 << 20
"""Vertices of pairs of places that are compared at once: all pairs would take gigabytes."""

_WEIGHTS = np.array(
    [(31, 33, 36), (67, 16, 17), (15, 68, 17), (17, 15, 68), (41, 40, 19), (42, 19, 39), (18, 41, 41)],
    dtype=float,
)
"""Weights of sampled places in a triangle: uneven, since even ones fall on lines of symmetric shapes."""


@dataclass(frozen=True, eq=False)
class Fan:
    """A piece cut round a new Steiner vertex: star pieces between spokes, and the pockets that are left."""

    tiling: Tiling
    pockets: list[Piece]


@dataclass(frozen=True, eq=False)
class _Places:
    """Places inside a polygon and the vertices that each of them sees by a diagonal."""

    at: Floats
    sees: Relation


def fans(tiling: Tiling, piece: Piece, grounds: Grounds, most: int, task: Task) -> list[Fan]:
    """Give the most promising ways to place one Steiner vertex in a piece, the best first.

    Every pocket has fewer vertices than the piece.
    """
    centre = len(tiling.source.coordinates)
    first, second = (_places(ground, task) for ground in grounds)
    found = []
    for i, j in _best(first.sees, second.sees, most, task):
        spokes = np.flatnonzero(first.sees[i] & second.sees[j])
        stars, pockets = _cut(piece, spokes.tolist(), centre)
        cut = tiling.replace(piece, [*stars, *pockets], first.at[[i]], second.at[[j]])
        found.append(Fan(cut, pockets))
    return found


def _places(ground: Triangulation, task: Task) -> _Places:
    """Sample the triangles; of the places that see the same vertices keep one."""
    corners = ground.vertices[ground.triangles]
    weights = _WEIGHTS[: max(1, MOST_SAMPLES // len(corners))]
    samples = np.einsum("ws,fsx->fwx", weights / weights.sum(axis=1, keepdims=True), corners).reshape(-1, 2)
    triangles = np.repeat(np.arange(len(corners)), len(weights))
    sees = visibility_from(ground, samples, triangles, task).diagonal
    _, kept = np.unique(np.packbits(sees, axis=1), axis=0, return_index=True)
    kept = kept[np.lexsort((kept, -sees[kept].sum(axis=1)))][:MOST_PLACES]
    return _Places(samples[kept], sees[kept])


def _best(first: Relation, second: Relation, most: int, task: Task) -> list[tuple[int, int]]:
    """Rank pairs of places by what they leave hidden."""
    hardness = np.empty((len(first), len(second)))
    rows = max(1, _AT_ONCE // second.size)
    for start in range(0, len(first), rows):
        task.reach(0)
        hardness[start : start + rows] = _hardness(first[start : start + rows, None] & second)
    ranked = np.argsort(hardness, axis=None, kind="stable")[:most]
    ranked = ranked[np.isfinite(hardness.ravel()[ranked])]
    return [(int(i), int(j)) for i, j in zip(*np.unravel_index(ranked, hardness.shape), strict=True)]


def _hardness(seen: Relation) -> Floats:
    """Give for each row the hidden vertices beyond those that are easy, then the pockets.

    It is infinite where a pocket, its run of hidden vertices and three more, is no smaller than the polygon:
    where all vertices seen are among three neighbours.
    """
    n = seen.shape[-1]
    cyclic = np.concatenate([seen[..., -EASY:], seen], axis=-1)
    earlier = [cyclic[..., EASY - step : EASY - step + n] for step in range(EASY + 1)]
    deep = ~np.logical_or.reduce(earlier)
    pockets = seen & ~earlier[1]
    neighbours = np.add.reduce(earlier, dtype=np.int8)
    hardness: Floats = n * deep.sum(axis=-1) + pockets.sum(axis=-1).astype(np.float64)
    hardness[neighbours.max(axis=-1) == seen.sum(axis=-1)] = np.inf
    return hardness


def _cut(piece: Piece, spokes: list[int], centre: int) -> tuple[list[Piece], list[Piece]]:
    """Cut a piece along spokes into star pieces, made of the triangles between spokes, and pockets."""
    n = len(piece)
    if len(spokes) == n:  # the Steiner vertex stays, as a common star vertex of two halves
        half = n // 2
        return [(centre, *piece[: half + 1]), (centre, *piece[half:], piece[0])], []
    gaps = np.flatnonzero(np.diff(spokes, append=spokes[0] + n) > 1)
    first = np.roll(
        spokes, -1 - gaps[0]
    ).tolist()  # behind a pocket, so that no run of triangles is cut in two
    stars, pockets = [], []
    star = [first[0]]
    for a, b in pairwise([*first, first[0]]):
        if (b - a) % n == 1:
            star.append(b)
            continue
        pockets.append((centre, *(piece[(a + step) % n] for step in range((b - a) % n + 1))))
        if len(star) > 1:
            stars.append((centre, *(piece[v] for v in star)))
        star = [b]
    return stars, pockets
