"""Chains of bridges: out of all bridges between rings those that together cost least."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.correspondence import Correspondence
from starskel.predicates import DIGITS
from starskel.shapes.holes.region import Region, meeting
from starskel.shapes.holes.routes import Bridge
from starskel.task import Task

APART = 0.3
"""What it costs where a chain leaves a ring just where it came to it, as a part of the size."""

_AT_ONCE = 400

Priced = list[tuple[float, Bridge]]


@dataclass(frozen=True)
class Search:
    """How widely chains are sought.

    Attributes
    ----------
    kept : int
        So many bridges between two rings, the cheapest.
    breadth : int
        So many beginnings of chains that have the same holes behind them.
    bend_price : float
        What it costs, in sizes, where a bridge is not straight in one of the shapes; infinite where it must.
    """

    kept: int
    breadth: int
    bend_price: float = np.inf


class Bridges:
    """All bridges of a pair, and what they cost.

    Parameters
    ----------
    pair : Correspondence
    regions : sequence of Region
        That of the source, and that of the target.
    """

    def __init__(self, pair: Correspondence, regions: Sequence[Region]) -> None:
        self.rings = len(pair.starts)
        self._regions = regions
        self._ring_of = np.repeat(np.arange(self.rings), np.diff([*pair.starts, len(pair)]))
        self._shares = _shares(pair, self._ring_of)

    def between(self, one: int, two: int, search: Search, task: Task) -> Priced:
        """Give the cheapest bridges between two rings; where all have to be straight, perhaps fewer."""
        rows = (np.flatnonzero(self._ring_of == ring) for ring in (one, two))
        i, j = (k.ravel() for k in np.meshgrid(*rows, indexing="ij"))
        costs = self._lengths(i, j)
        order = np.lexsort((j, i, costs.round(9)))
        found: Priced = []
        for k in range(0, len(order), _AT_ONCE):
            task.reach(0)
            some = order[k : k + _AT_ONCE]
            bent = sum(~region.clear(region.rows[i[some]], region.rows[j[some]]) for region in self._regions)
            priced = costs[some] + np.where(bent > 0, search.bend_price, 0.0) * np.maximum(bent, 1)
            good = np.isfinite(priced)
            found += [
                (float(cost), (int(i[b]), int(j[b])))
                for cost, b in zip(priced[good], some[good], strict=True)
            ]
            if len(found) >= search.kept:
                break
        return sorted(found, key=_by_cost)[: search.kept]

    def crossings(self, bridges: Sequence[Bridge]) -> dict[frozenset[Bridge], int]:
        """Tell of two bridges in how many of the shapes they meet, be it at their ends, if in any."""
        ends = np.array(bridges, dtype=np.intp).reshape(-1, 2)
        found: dict[frozenset[Bridge], int] = {}
        for region in self._regions:
            segments = region.rows[ends[:, 0]], region.rows[ends[:, 1]]
            for a, b in np.stack(meeting(segments, segments), axis=1).tolist():
                if a < b:
                    both = frozenset((bridges[a], bridges[b]))
                    found[both] = found.get(both, 0) + 1
        return found

    def narrowness(self, came: int, left: int) -> float:
        """Give what it costs that a chain comes to a ring here and leaves it there."""
        if came == left:
            return np.inf
        apart = min(abs((own[came] - own[left] + 0.5) % 1 - 0.5) for own in self._shares)
        return APART * (1 - 2 * apart)

    def _lengths(self, i: Indices, j: Indices) -> Floats:
        """Give the lengths of bridges, in parts of the shapes' sizes, summed over both."""
        ways = [(region.rows[j] - region.rows[i], region.size) for region in self._regions]
        return np.asarray(sum(np.hypot(*way.T) / size for way, size in ways))


def chains(bridges: Bridges, search: Search, task: Task) -> Iterator[tuple[Bridge, ...]]:
    """Give chains through all holes, the cheapest first."""
    found: dict[tuple[int, int], Priced] = {}
    for one, two in combinations(range(bridges.rings), 2):
        own = found[one, two] = bridges.between(one, two, search, task)
        found[two, one] = [(cost, (b, a)) for cost, (a, b) in own]
    crossings = bridges.crossings([bridge for own in found.values() for _, bridge in own])
    holes = frozenset(range(1, bridges.rings))
    known = [_Chain(0.0, (), frozenset(), 0)]
    for step in range(bridges.rings):
        longer: dict[tuple[frozenset[int], int], list[_Chain]] = {}
        for chain in known:
            for goal in sorted(holes - chain.holes) if step < len(holes) else [0]:
                task.reach(0)
                for cost, bridge in found[chain.ring, goal]:
                    met = sum(crossings.get(frozenset((bridge, other)), 0) for other in chain.bridges)
                    price = cost + (search.bend_price * met if met else 0.0)
                    if price < np.inf:
                        new = chain.extended(price, bridge, goal, bridges)
                        longer.setdefault((new.holes, goal), []).append(new)
        known = [c for own in longer.values() for c in sorted(own, key=_Chain.order)[: search.breadth]]
    yield from (chain.bridges for chain in sorted(known, key=_Chain.order) if chain.cost < np.inf)


@dataclass(frozen=True)
class _Chain:
    cost: float
    bridges: tuple[Bridge, ...]
    holes: frozenset[int]
    ring: int

    def order(self) -> tuple[float, tuple[Bridge, ...]]:
        return round(self.cost, DIGITS), self.bridges

    def extended(self, price: float, bridge: Bridge, goal: int, bridges: Bridges) -> "_Chain":
        """Lengthen the chain; it costs more where it leaves a ring near to where it came to it."""
        total = self.cost + price
        if self.bridges:
            total += bridges.narrowness(self.bridges[-1][1], bridge[0])
        if goal == 0:
            total += bridges.narrowness(self.bridges[0][0], bridge[1])
        return _Chain(total, (*self.bridges, bridge), self.holes | {goal}, goal)


def _by_cost(priced: tuple[float, Bridge]) -> tuple[float, Bridge]:
    return round(priced[0], DIGITS), priced[1]


def _shares(pair: Correspondence, ring_of: Indices) -> list[list[float]]:
    """Give for both shapes how far along its ring each row is, as parts of the whole."""
    shares = []
    for rows in (pair.source, pair.target):
        steps = np.hypot(*(rows[pair.following] - rows).T)
        along = np.cumsum(steps) - steps
        starts = np.array(pair.starts)
        parts = (along - along[starts][ring_of]) / np.add.reduceat(steps, starts)[ring_of]
        shares.append(parts.tolist())  # lists, as single numbers are taken from them
    return shares
