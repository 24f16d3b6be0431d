"""Compatible bridges: from ring to ring through both regions alike, so that they fall into simple polygons.

Bridges are straight and link rows that see each other in source and target. They lead from the outline to a
hole, from there to the next, and from the last hole back to the outline: so many holes, one bridge more, and
two simple polygons on both sides of that chain.
"""

from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
import shapely

from starskel.correspondence import Correspondence
from starskel.errors import StarskelError
from starskel.outline import Flags
from starskel.predicates import Floats, Indices, segments_meet
from starskel.task import Task

Bridge = tuple[int, int]
"""The rows where it begins and ends."""

Shares = list[list[float]]
"""For both shapes and each row a part of its ring: lists, as single numbers are taken from them."""

WIDTHS = (60, 40), (2000, 400)
"""How widely is sought, and how widely where that finds nothing: so many bridges between two rings, the
shortest that are clear; and so many beginnings of chains that have the same holes behind them.
"""

APART = 0.3
"""What it costs where a chain leaves a ring just where it came to it, as a part of the size."""

_AT_ONCE = 400


@dataclass(frozen=True)
class _Chain:
    cost: float
    bridges: tuple[Bridge, ...]
    holes: frozenset[int]
    ring: int


def chain_of(pair: Correspondence, task: Task) -> tuple[Bridge, ...]:
    """Give the cheapest chain: short bridges, in source and target, that part every ring well.

    Raises
    ------
    StarskelError
        If no chain of straight bridges is found.
    """
    for kept, breadth in WIDTHS:
        chains = _chains(pair, kept, breadth, task)
        if chains:
            return min(chains, key=_by_cost).bridges
    raise StarskelError(
        "the holes of a part cannot be joined to its outline by straight bridges that both shapes have",
        "add vertices or marks, or pair the holes otherwise",
    )


def _chains(pair: Correspondence, kept: int, breadth: int, task: Task) -> list[_Chain]:
    """Give chains through all holes, hole by hole, the cheapest beginnings followed."""
    ring_of = np.repeat(np.arange(len(pair.starts)), np.diff([*pair.starts, len(pair)]))
    found = _bridges(pair, ring_of, kept, task)
    shares = _shares(pair, ring_of)
    crossing = _crossings(pair, [bridge for own in found.values() for _, bridge in own])
    holes = range(1, len(pair.starts))
    chains = [_Chain(0.0, (), frozenset(), 0)]
    for step in range(len(holes) + 1):
        longer: dict[tuple[frozenset[int], int], list[_Chain]] = {}
        for chain in chains:
            task.reach(0)
            goals = [hole for hole in holes if hole not in chain.holes] if step < len(holes) else [0]
            for goal in goals:
                for cost, bridge in found[chain.ring, goal]:
                    if all(frozenset((bridge, other)) not in crossing for other in chain.bridges):
                        new = _extended(chain, cost, bridge, goal, shares)
                        longer.setdefault((new.holes, goal), []).append(new)
        chains = [c for own in longer.values() for c in sorted(own, key=_by_cost)[:breadth]]
    return chains


def halves(pair: Correspondence, chain: tuple[Bridge, ...]) -> tuple[Indices, Indices]:
    """Give the rows of the simple polygons right and left of a chain, counter-clockwise."""
    first, last = chain[0][0], chain[-1][1]
    stops = [(came[1], left[0]) for came, left in pairwise(chain)]
    right = [_walk(pair, first, last), *(_walk(pair, left, came) for came, left in reversed(stops))]
    left = [_walk(pair, last, first), *(_walk(pair, came, left) for came, left in stops)]
    return np.concatenate(right), np.concatenate(left)


def _walk(pair: Correspondence, start: int, end: int) -> Indices:
    rows = [start]
    while rows[-1] != end:
        rows.append(int(pair.following[rows[-1]]))
    return np.array(rows, dtype=np.intp)


def _by_cost(chain: _Chain) -> tuple[float, tuple[Bridge, ...]]:
    return round(chain.cost, 9), chain.bridges


def _extended(chain: _Chain, cost: float, bridge: Bridge, goal: int, shares: Shares) -> _Chain:
    """Lengthen a chain; it costs more where it leaves a ring near to where it came to it."""
    total = chain.cost + cost
    if chain.bridges:
        total += _narrowness(shares, chain.bridges[-1][1], bridge[0])
    if goal == 0:
        total += _narrowness(shares, chain.bridges[0][0], bridge[1])
    return _Chain(total, (*chain.bridges, bridge), chain.holes | {goal}, goal)


def _narrowness(shares: Shares, came: int, left: int) -> float:
    if came == left:
        return np.inf
    apart = min(abs((own[came] - own[left] + 0.5) % 1 - 0.5) for own in shares)
    return APART * (1 - 2 * apart)


def _shares(pair: Correspondence, ring_of: Indices) -> Shares:
    """Give how far along its ring each row is in both shapes, as parts of the whole."""
    shares = []
    for rows in (pair.source, pair.target):
        steps = np.hypot(*(rows[pair.following] - rows).T)
        along = np.cumsum(steps) - steps
        starts = np.array(pair.starts)
        parts = (along - along[starts][ring_of]) / np.add.reduceat(steps, starts)[ring_of]
        shares.append(parts.tolist())
    return shares


def _bridges(
    pair: Correspondence, ring_of: Indices, kept: int, task: Task
) -> dict[tuple[int, int], list[tuple[float, Bridge]]]:
    """Give for each two rings the shortest bridges from the one to the other, with what they cost."""
    found: dict[tuple[int, int], list[tuple[float, Bridge]]] = {}
    for one, two in combinations(range(len(pair.starts)), 2):
        task.reach(0)
        i, j = (
            k.ravel() for k in np.meshgrid(*(np.flatnonzero(ring_of == r) for r in (one, two)), indexing="ij")
        )
        costs = _costs(pair, i, j)
        order = np.lexsort((j, i, costs.round(9)))
        own: list[tuple[float, Bridge]] = []
        for k in range(0, len(order), _AT_ONCE):
            some = order[k : k + _AT_ONCE]
            clear = _clear(pair, i[some], j[some])
            own += [(float(costs[b]), (int(i[b]), int(j[b]))) for b in some[clear]]
            if len(own) >= kept:
                break
        found[one, two] = own[:kept]
        found[two, one] = [(cost, (b, a)) for cost, (a, b) in own[:kept]]
    return found


def _costs(pair: Correspondence, i: Indices, j: Indices) -> Floats:
    sides = [(rows[j] - rows[i], np.ptp(rows, axis=0).max()) for rows in (pair.source, pair.target)]
    return np.asarray(sum(np.hypot(*way.T) / size for way, size in sides))


def _clear(pair: Correspondence, i: Indices, j: Indices) -> Flags:
    """Tell which bridges lie in the open inside of both regions but for their ends."""
    clear = np.ones(len(i), dtype=np.bool_)
    for rows in (pair.source, pair.target):
        outline, *holes = np.split(rows, pair.starts[1:])
        region = shapely.Polygon(outline, holes)
        shapely.prepare(region)
        clear &= shapely.contains_xy(region, *((rows[i] + rows[j]) / 2).T)
        ends = rows[pair.following]
        tree = shapely.STRtree(shapely.linestrings(np.stack([rows, ends], axis=1)))
        bridge, edge = tree.query(shapely.linestrings(np.stack([rows[i], rows[j]], axis=1)))
        corners = np.stack([edge, pair.following[edge]])
        foreign = ((corners != i[bridge]) & (corners != j[bridge])).all(axis=0)
        bridge, edge = bridge[foreign], edge[foreign]
        clear[bridge[segments_meet(rows[i[bridge]], rows[j[bridge]], rows[edge], ends[edge])]] = False
    return clear


def _crossings(pair: Correspondence, bridges: list[Bridge]) -> set[frozenset[Bridge]]:
    """Give the pairs of bridges that meet in one of the shapes, be it at their ends."""
    ends = np.array(bridges, dtype=np.intp).reshape(-1, 2)
    found: set[frozenset[Bridge]] = set()
    for rows in (pair.source, pair.target):
        segments = shapely.linestrings(rows[ends])
        first, second = shapely.STRtree(segments).query(segments)
        first, second = first[first < second], second[first < second]
        met = segments_meet(*(rows[ends[k, c]] for k in (first, second) for c in (0, 1)))
        found |= {frozenset((bridges[a], bridges[b])) for a, b in zip(first[met], second[met], strict=True)}
    return found
