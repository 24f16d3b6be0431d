"""Placing one Steiner vertex: a fan round it is a star piece, and what it does not see is left in pockets."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from starskel.arrays import Flags, Floats, Indices
from starskel.decomposition.board import TABLED_AT_ONCE, Board, handfuls
from starskel.decomposition.overlay import crossings
from starskel.decomposition.pieces import Piece
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import visibility_from

EASY = 2
"""A pocket of so many hidden vertices is a pentagon at most, and every pentagon is star-shaped."""

MOST_PLACES = 300
"""Candidates kept in each polygon, those that see most; all pairs of them are compared."""

MOST_SAMPLES = 3000
"""Places that are looked at in each polygon, one at least in each triangle."""

_WEIGHTS = np.array(
    [(31, 33, 36), (67, 16, 17), (15, 68, 17), (17, 15, 68), (41, 40, 19), (42, 19, 39), (18, 41, 41)],
    dtype=float,
)
"""Weights of sampled places in a triangle: uneven, since even ones fall on lines of symmetric shapes."""


@dataclass(frozen=True, eq=False)
class Fan:
    """A place for a Steiner vertex.

    Attributes
    ----------
    source, target : (2,) arrays
    spokes : list of int
        The places in the ring that it sees in both polygons.
    hidden : int
        How many others lie in pockets, beyond those that are easy.
    """

    source: Floats
    target: Floats
    spokes: list[int]
    hidden: int


@dataclass(frozen=True, eq=False)
class Stuck:
    """A cell that common diagonals do not help.

    Attributes
    ----------
    ring : tuple of int
    crossings : int
        How many Steiner vertices an overlay needs.
    fans : list of Fan
        The most promising places for one Steiner vertex, the best first.
    """

    ring: Piece
    crossings: int
    fans: list[Fan]


def survey(
    board: Board, cells: Sequence[Piece], most: Sequence[int], task: Task, samples: int = len(_WEIGHTS)
) -> list[Stuck]:
    """Look for ways to free stuck cells, at most so many for each by one Steiner vertex.

    Every pocket has fewer vertices than its cell. In each triangle so many places are looked at.
    """
    wanted = dict(zip(cells, most, strict=True))
    found = {}
    for handful in handfuls(set(cells), TABLED_AT_ONCE, len):
        grounds = board.triangulated(handful, task)
        places = zip(*(_places(ground, samples, task) for ground in grounds), strict=True)
        for cell, (first, second), count in zip(handful, places, crossings(*grounds), strict=True):
            fans = [
                Fan(
                    first.at[i], second.at[j], np.flatnonzero(first.sees[i] & second.sees[j]).tolist(), hidden
                )
                for i, j, hidden in _best(first.sees, second.sees, wanted[cell], task)
            ]
            found[cell] = Stuck(cell, count, fans)
    return [found[cell] for cell in cells]


@dataclass(frozen=True, eq=False)
class _Places:
    """Places inside a polygon and the vertices that each of them sees by a diagonal."""

    at: Floats
    sees: Flags


def _places(ground: Triangulation, samples: int, task: Task) -> list[_Places]:
    """Sample the triangles; of the places that see the same vertices of their ring keep one."""
    corners = ground.vertices[ground.triangles]
    weights = _WEIGHTS[: max(1, min(samples, MOST_SAMPLES // len(corners)))]
    at = np.einsum("ws,fsx->fwx", weights / weights.sum(axis=1, keepdims=True), corners).reshape(-1, 2)
    triangles = np.repeat(np.arange(len(corners)), len(weights))
    sees = visibility_from(ground, at, triangles, task).diagonal
    places = []
    for ring, (first, last) in enumerate(zip(ground.rings.first, ground.rings.last, strict=True)):
        own = np.flatnonzero(ground.owner[triangles] == ring)
        places.append(_distinct(at[own], sees[own, first : last + 1]))
    return places


def _distinct(samples: Floats, sees: Flags) -> _Places:
    _, kept = np.unique(np.packbits(sees, axis=1), axis=0, return_index=True)
    kept = kept[np.lexsort((kept, -sees[kept].sum(axis=1)))][:MOST_PLACES]
    return _Places(samples[kept], sees[kept])


def _best(first: Flags, second: Flags, most: int, task: Task) -> list[tuple[int, int, int]]:
    """Rank pairs of places by what they leave hidden; give the best, and how many vertices these hide."""
    task.reach(0)
    hardness = _hardness(first, second)
    count = most
    while True:
        ranked = _least(hardness.ravel(), count)
        i, j = np.unravel_index(ranked, hardness.shape)
        hopeful = np.flatnonzero(_leave_less(first[i] & second[j]))[:most]
        if len(hopeful) == most or count >= hardness.size:
            hidden = hardness[i, j] // first.shape[1]
            return list(zip(*(part[hopeful].tolist() for part in (i, j, hidden)), strict=True))
        count *= 8


def _least(numbers: Indices, count: int) -> Indices:
    """Give where the least of some numbers are, in rising order, the first of equal ones first."""
    if count < len(numbers):
        near = np.flatnonzero(numbers <= np.partition(numbers, count)[count])
        return near[np.argsort(numbers[near], kind="stable")][:count]
    return np.argsort(numbers, kind="stable")


def _hardness(first: Flags, second: Flags) -> Indices:
    """Give for each pair of places the hidden vertices beyond those that are easy, then the pockets."""
    n = first.shape[1]
    seen, earlier, before = (
        _words(np.roll(first, step, axis=1))[:, None] & _words(np.roll(second, step, axis=1))
        for step in range(EASY + 1)
    )
    near = _count(seen | earlier | before)
    hardness: Indices = n * (n - near) + _count(seen & ~earlier)
    return hardness


def _leave_less(seen: Flags) -> Flags:
    """Tell from the vertices that places see whether all their pockets are smaller than the polygon.

    A pocket, its run of hidden vertices and three more, is not where all vertices seen are among three
    neighbours.
    """
    run = np.add.reduce([np.roll(seen, step, axis=1) for step in range(EASY + 1)], dtype=np.int8)
    less: Flags = run.max(axis=1, initial=0) < seen.sum(axis=1)
    return less


def _words(flags: Flags) -> NDArray[np.uint64]:
    """Pack rows of flags into words of 64."""
    packed = np.zeros((len(flags), -(-flags.shape[1] // 64) * 8), dtype=np.uint8)
    bits = np.packbits(flags, axis=1)
    packed[:, : bits.shape[1]] = bits
    return packed.view(np.uint64)


def _count(words: NDArray[np.uint64]) -> Indices:
    counts: Indices = np.bitwise_count(words).sum(axis=-1, dtype=np.intp)
    return counts


def cut_round(piece: Piece, fan: Fan, centre: int) -> tuple[list[Piece], list[Piece]]:
    """Cut a piece along spokes into star pieces, made of the triangles between spokes, and pockets."""
    n, spokes = len(piece), fan.spokes
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
