"""Bridges that bend: drawn through a region, straightened, and bent alike in source and target.

Which bridges there are is given, and from where to where they lead. However the holes lie, they can be drawn
(`triangulated_region`). Then each is straightened over its own points, as far as the others leave room, to as
few links as can be. Where it has fewer bends than in the other shape, it is bent a little more often.
"""

from collections.abc import Sequence

import numpy as np

from starskel.arrays import Complex, Flags, Floats
from starskel.polar import as_points
from starskel.predicates import DIGITS
from starskel.shapes.holes.region import Region, meeting
from starskel.shapes.holes.triangulated_region import TriangulatedRegion
from starskel.task import Task

ROUNDS = 3
"""How often all bridges are straightened: one that has got straight leaves more room to the others."""

BULGE = 0.1
"""How far a link is bent that needs a bend more, as a part of its length."""

HALVINGS = 20
"""How often that is halved until there is room."""

_STARTS, _ENDS = slice(-1), slice(1, None)

Bridge = tuple[int, int]
"""The rows where it begins and ends."""


def bends_of(regions: Sequence[Region], bridges: Sequence[Bridge], task: Task) -> list[list[Floats]] | None:
    """Give the bends of bridges in all of some regions, equally many in each.

    Returns
    -------
    For each region a list of (k, 2) arrays; None where something is too narrow for floats to name a way.
    """
    drawn = [_drawn(region, bridges, task) for region in regions]
    ways = [own for own in drawn if own is not None]
    if len(ways) < len(regions):
        return None
    counts = [max(map(len, same)) for same in zip(*ways, strict=True)]
    bent = [_bent(region, own, counts, task) for region, own in zip(regions, ways, strict=True)]
    if any(own is None for own in bent):
        return None
    return [[as_points(way[1:-1]) for way in own] for own in bent if own is not None]


def _drawn(region: Region, bridges: Sequence[Bridge], task: Task) -> list[Complex] | None:
    triangulated = TriangulatedRegion(region)
    ways = []
    for bridge in bridges:
        task.reach(0)
        way = triangulated.draw(*bridge)
        if way is None:
            return None
        ways.append(way)
    for _ in range(ROUNDS):
        for number, way in enumerate(ways):
            task.reach(0)
            if len(way) > 2:
                ways[number] = _straightened(region, way, ways[:number] + ways[number + 1 :])
    fine = all(_is_clear(region, way, ways[:number]) for number, way in enumerate(ways))
    return ways if fine else None


def _straightened(region: Region, way: Complex, others: Sequence[Complex]) -> Complex:
    """Give the way with fewest links over points of a way, the shortest of them."""
    first, last = np.triu_indices(len(way), 1)
    free = _clear(region, way[first], way[last], others)
    cost, before = [(0, 0.0)] + [(len(way), 0.0)] * (len(way) - 1), [0] * len(way)
    for i, j in zip(first[free].tolist(), last[free].tolist(), strict=True):
        through = cost[i][0] + 1, cost[i][1] + abs(way[j] - way[i])
        if through < cost[j]:
            cost[j], before[j] = through, i
    kept = [len(way) - 1]
    while kept[-1]:
        kept.append(before[kept[-1]])
    if len(kept) == len(way):
        return way
    shorter = way[kept[::-1]]
    return shorter if _is_clear(region, shorter, others) else way


def _bent(region: Region, ways: Sequence[Complex], counts: Sequence[int], task: Task) -> list[Complex] | None:
    """Bend ways until each has so many points."""
    bent = list(ways)
    for number, count in enumerate(counts):
        while len(bent[number]) < count:
            task.reach(0)
            more = _bulging(region, bent[number], bent[:number] + bent[number + 1 :])
            if more is None:
                return None
            bent[number] = more
    return bent


def _bulging(region: Region, way: Complex, others: Sequence[Complex]) -> Complex | None:
    """Bend the longest link of a way to the left, as little as there is room for: its points in no line.

    The two links beside a bend are equally long: rounding must not choose.
    """
    lengths = np.abs(np.diff(way))
    link = int((lengths / lengths.max()).round(DIGITS).argmax())
    start, end = way[link], way[link + 1]
    for halving in range(HALVINGS):
        bend = (start + end) / 2 + 1j * BULGE / 2**halving * (end - start)
        more = np.insert(way, link + 1, bend)
        if _is_clear(region, more, others):
            return more
    return None


def _is_clear(region: Region, way: Complex, others: Sequence[Complex]) -> bool:
    """Tell whether a way lies in a region and meets neither itself nor others."""
    if not _clear(region, way[:-1], way[1:], others).all():
        return False
    links = as_points(way[:-1]), as_points(way[1:])
    first, second = meeting(links, links)
    return bool((np.abs(first - second) <= 1).all())


def _clear(region: Region, starts: Complex, ends: Complex, others: Sequence[Complex]) -> Flags:
    """Tell which links lie in a region and meet no other way."""
    links = as_points(starts), as_points(ends)
    clear = region.clear(*links)
    if others:
        first, last = (np.concatenate([way[side] for way in others]) for side in (_STARTS, _ENDS))
        clear[meeting(links, (as_points(first), as_points(last)))[0]] = False
    return clear
