"""Convex pieces of one polygon, cut along diagonals: the fewest, or few where the polygon is large.

The fewest come from a dynamic program over sub-polygons (Keil 1985, "Decomposing a Polygon into Simpler
Components"). The piece on a line of sight (i, k), i < k, is a convex chain i < l < ... < j < k. It is the
piece on (i, j) with the triangle i, j, k added, or that triangle alone. Of the pieces that leave the fewest
cuts only the narrowest matter, for one cut more would buy the freedom to start afresh: for each vertex j
before k the piece whose first vertex l is greatest. Vertices lie round a vertex in the order of their
indices, so a piece may turn towards k if its vertex before j is one of the first few. A running maximum
therefore answers every question at once: O(n^3) in all.

Large polygons are triangulated, and diagonals that are not needed are dropped again (Hertel and Mehlhorn
1983): at most four times as many pieces as there could be.
"""

from bisect import insort
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.points import Points
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import Visibility

Cut = tuple[int, int]

Price = Callable[[Indices, Indices], Floats]
"""Gives what diagonals cost, from places in the ring to others."""

FEWEST = 200
"""Up to so many vertices the pieces are the fewest: beyond, the tables of n^3 entries grow too large."""


def convex_cuts(ground: Triangulation, seen: Visibility, price: Price, task: Task) -> list[Cut]:
    """Give diagonals, as pairs of places in the ring, that cut a polygon into few convex pieces.

    Parameters
    ----------
    ground : Triangulation
        The polygon.
    seen : Visibility
        Who sees whom in it.
    price : callable
        Which diagonals to prefer, the cheaper ones; n prices together stay below 1/2.
    task : Task
    """
    if len(ground.rings.rows) > FEWEST:
        return _needed_diagonals(ground, price, task)
    return _Pieces(ground.points, ground.rings.rows, seen, price).cuts(task)


class _Pieces:
    """The tables, filled span by span.

    A cost is the number of cuts plus their prices, so that its whole part is the number. An entry
    narrowest[i, k, j] is the greatest first vertex l of the pieces on (i, k) whose last vertex is j or an
    earlier one, less the prices of that piece.
    """

    def __init__(self, points: Points, ring: Indices, seen: Visibility, price: Price) -> None:
        n = len(ring)
        self._seen = seen
        every = np.arange(n)
        self._price = price(every[:, None], every)
        self._last, self._first = _limits(points, ring, seen)
        self._least = np.full((n, n), np.inf)
        self._cut = np.full((n, n), np.inf)
        self._cut[np.arange(n - 1), np.arange(1, n)] = 0
        self._narrowest = np.full((n, n, n), -np.inf)

    def cuts(self, task: Task) -> list[Cut]:
        n = len(self._least)
        for span in range(2, n):
            task.reach((span / n) ** 2)
            seen = np.flatnonzero(np.diagonal(self._seen.sees, span)) if span < n - 1 else np.array([0])
            self._fill(seen, span)
        cuts: list[Cut] = []
        waiting = [(0, n - 1)]
        while waiting:
            chain = self._chain(*waiting.pop())
            inner = [(a, b) for a, b in pairwise(chain) if b - a > 1]
            cuts += inner
            waiting += inner
        return cuts

    def _fill(self, i: Indices, span: int) -> None:
        k = i + span
        cost, first = self._costs(i, span)
        least = cost.min(axis=1)
        self._least[i, k] = least
        with np.errstate(invalid="ignore"):  # where there is no piece
            narrow = np.where(np.floor(cost) == np.floor(least)[:, None], first - cost % 1, -np.inf)
        narrow = np.maximum.accumulate(np.where(np.isfinite(cost), narrow, -np.inf), axis=1)
        self._narrowest[i[:, None], k[:, None], i[:, None] + np.arange(1, span)] = narrow
        proper = self._seen.diagonal[i, k]
        self._cut[i[proper], k[proper]] = 1 + least[proper] + self._price[i[proper], k[proper]]

    def _costs(self, i: Indices, span: int) -> tuple[Floats, Indices]:
        """Give, for pieces on (i, i + span) with each last vertex in turn, the cost and the first vertex."""
        k = (i + span)[:, None]
        i = i[:, None]
        j = i + np.arange(1, span)
        piece = self._narrowest[i, j, self._last[j, k]]
        joins = np.ceil(piece) >= self._first[i, k]
        first = np.where(joins, np.ceil(piece), j)
        with np.errstate(invalid="ignore"):  # where nothing joins
            joined = np.floor(self._least[i, j]) + (first - piece)
        return np.where(joins, joined, self._cut[i, j]) + self._cut[j, k], first

    def _chain(self, i: int, k: int) -> list[int]:
        """Walk the cheapest piece on (i, k) back from k to i."""
        cost, _ = self._costs(np.array([i]), k - i)
        chain = [k, i + 1 + int(cost[0].argmin())]
        while True:
            k, j = chain[-2:]
            piece = self._narrowest[i, j, self._last[j, k]]
            if np.ceil(piece) < self._first[i, k]:
                return [i, *chain[::-1]]
            chain.append(int((self._narrowest[i, j] == piece).argmax()))


def _limits(points: Points, ring: Indices, seen: Visibility) -> tuple[Indices, Indices]:
    """Give how far pieces may turn at each vertex.

    Returns
    -------
    last : (n, n) array of int
        At [j, k], j < k, the last vertex before j from which a convex piece may come to go on to k.
    first : (n, n) array of int
        At [i, k], i < k, the first vertex after i to which a convex piece may go that comes from k.
    """
    n = len(ring)
    last = np.repeat(np.arange(n)[:, None] - 1, n, axis=1)
    first = np.repeat(np.arange(n)[:, None] + 1, n, axis=1)
    linked = seen.diagonal | np.eye(n, k=1, dtype=bool) | np.eye(n, k=-1, dtype=bool)
    turns = points.orientation(np.roll(ring, 1), ring, np.roll(ring, -1))
    for v in np.flatnonzero(turns < 0):
        links, after = np.flatnonzero(linked[v]), np.flatnonzero(seen.sees[v, v + 1 :]) + v + 1
        turn = points.orientation(ring[links][:, None], ring[[v]][None], ring[after][None])
        from_before = (turn < 0) & (links < v)[:, None]
        hindered = from_before.any(axis=0)
        last[v, after[hindered]] = links[from_before.argmax(axis=0)[hindered]] - 1
        wide = (turn > 0) & (links > v)[:, None] & (links[:, None] < after)
        hindered = wide.any(axis=0)
        first[v, after[hindered]] = links[len(links) - 1 - wide[::-1].argmax(axis=0)[hindered]] + 1
    return last, first


def _needed_diagonals(ground: Triangulation, price: Price, task: Task) -> list[Cut]:
    """Drop the diagonals of a triangulation that no vertex needs, the dearest first."""
    n = len(ground.rings.rows)
    a, b = ground.starts, ground.ends
    inner = (ground.twins >= 0) & (a < b)
    ways = [[1, n - 1] for _ in range(n)]  # steps ahead to the neighbours of each vertex, counter-clockwise
    for u, v in zip(a[inner].tolist(), b[inner].tolist(), strict=True):
        insort(ways[u], v - u)
        insort(ways[v], n + u - v)
    needed = []
    order = np.lexsort((b[inner], a[inner], -price(a[inner], b[inner])))
    for u, v in zip(a[inner][order].tolist(), b[inner][order].tolist(), strict=True):
        task.reach(0)
        if _is_needed(ground, ways[u], u, v) or _is_needed(ground, ways[v], v, u):
            needed.append((u, v))
        else:
            ways[u].remove(v - u)
            ways[v].remove(n + u - v)
    return needed


def _is_needed(ground: Triangulation, ways: list[int], u: int, v: int) -> bool:
    """Tell whether the angle at u is reflex without the diagonal to v."""
    n = len(ground.rings.rows)
    at = ways.index((v - u) % n)
    before, after = ((u + ways[at + step]) % n for step in (-1, 1))
    return bool(ground.points.orientation(*ground.rings.rows[[[after], [u], [before]]])[0] < 0)
