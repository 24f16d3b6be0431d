"""Placing one Steiner vertex: a fan round it is a star piece, and what it does not see is left in pockets."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.decomposition.minimal import Piece
from starskel.decomposition.tiling import Tiling
from starskel.predicates import Floats
from starskel.triangulation import Triangulation
from starskel.visibility import Relation, visibility_from

EASY = 2
"""A pocket of so many hidden vertices is a pentagon at most, and every pentagon is star-shaped."""

MOST_PLACES = 300
"""Candidates kept in each polygon, those that see most; all pairs of them are compared."""

_WEIGHTS = np.array(
    [(1, 1, 1), (4, 1, 1), (1, 4, 1), (1, 1, 4), (2, 2, 1), (2, 1, 2), (1, 2, 2)], dtype=float
)


@dataclass(frozen=True, eq=False)
class _Places:
    """Places inside a polygon and the vertices that each of them sees by a diagonal."""

    at: Floats
    sees: Relation


def fans(source: Triangulation, target: Triangulation, most: int) -> list[Tiling]:
    """Give the most promising ways to place one Steiner vertex in both polygons, the best first.

    The Steiner vertex is row n of the tiling. Every pocket has fewer vertices than the polygons.
    """
    n = len(source.points.coordinates)
    first, second = _places(source), _places(target)
    chosen = _best(first.sees, second.sees, most)
    rings = source.points.coordinates, target.points.coordinates
    tilings = []
    for i, j in chosen:
        spokes = np.flatnonzero(first.sees[i] & second.sees[j])
        places = np.concatenate([rings[0], first.at[[i]]]), np.concatenate([rings[1], second.at[[j]]])
        tilings.append(Tiling(*places, _pieces(spokes, n)))
    return tilings


def _places(ground: Triangulation) -> _Places:
    """Sample the triangles; of the places that see the same vertices keep one."""
    corners = ground.points.coordinates[ground.triangles]
    weights = _WEIGHTS / _WEIGHTS.sum(axis=1, keepdims=True)
    samples = np.einsum("ws,fsx->fwx", weights, corners).reshape(-1, 2)
    sees = visibility_from(ground, samples).diagonal
    _, kept = np.unique(np.packbits(sees, axis=1), axis=0, return_index=True)
    kept = kept[np.lexsort((kept, -sees[kept].sum(axis=1)))][:MOST_PLACES]
    return _Places(samples[kept], sees[kept])


def _best(first: Relation, second: Relation, most: int) -> list[tuple[int, int]]:
    """Rank pairs of places by what they leave hidden."""
    n = first.shape[1]
    hardness = np.empty((len(first), len(second)))
    for i, sees in enumerate(first):  # one row at a time: all pairs at once would take gigabytes
        hidden = ~(sees & second)
        runs = hidden & ~np.roll(hidden, 1, axis=1)
        deep = hidden.copy()
        for step in range(1, EASY + 1):
            deep &= np.roll(hidden, step, axis=1)
        hardness[i] = n * deep.sum(axis=1) + runs.sum(axis=1)
        hardness[i, ~_shrinks(hidden)] = np.inf
    ranked = np.argsort(hardness, axis=None, kind="stable")[:most]
    ranked = ranked[np.isfinite(hardness.ravel()[ranked])]
    return [(int(i), int(j)) for i, j in zip(*np.unravel_index(ranked, hardness.shape), strict=True)]


def _shrinks(hidden: Relation) -> Relation:
    """Tell whether every pocket, its run of hidden vertices and three more, is smaller than the polygon."""
    n = hidden.shape[1]
    twice = np.concatenate([hidden, hidden], axis=1)
    window = np.lib.stride_tricks.sliding_window_view(twice, max(n - 3, 1), axis=1)
    shrinks: Relation = ~np.any(np.all(window, axis=2), axis=1)
    return shrinks


def _pieces(spokes: np.ndarray, n: int) -> tuple[Piece, ...]:
    """Cut along the spokes into pockets, and star pieces of the triangles between them."""
    if len(spokes) == n:  # the Steiner vertex stays, as a common star vertex of two halves
        return (n, *range(n // 2 + 1)), (n, *range(n // 2, n), 0)
    gaps = np.flatnonzero(np.diff(spokes, append=spokes[0] + n) > 1)
    first = np.roll(spokes, -1 - gaps[0])  # begin behind a pocket, so that no run of triangles is cut in two
    pieces: list[Piece] = []
    star = [int(first[0])]
    for a, b in pairwise([*first.tolist(), int(first[0])]):
        if (b - a) % n == 1:
            star.append(b)
            continue
        pieces.append((n, *((a + step) % n for step in range((b - a) % n + 1))))
        if len(star) > 1:
            pieces.append((n, *star))
        star = [b]
    return tuple(pieces)
