"""Compatible bridges: from ring to ring through both regions alike, so that they fall into simple polygons.

Bridges lead from the outline to a hole, from there to the next, and from the last hole back to the outline:
so many holes, one bridge more, and two simple polygons on both sides of that chain. They are straight and
link rows that see each other in source and target, if there is such a chain. Else some of them bend, equally
often in both: with bends there always is a chain, whatever the holes are paired with.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, pairwise

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.correspondence import Correspondence
from starskel.errors import StarskelError, told
from starskel.shapes.holes.chains import Bridges, Search, chains
from starskel.shapes.holes.reading import RegionReading
from starskel.shapes.holes.region import Region
from starskel.shapes.holes.routes import Bridge, bends_of
from starskel.task import Task

STRAIGHT = Search(60, 40), Search(2000, 400)
"""How widely straight bridges are sought, and how widely where that finds nothing."""

BENT = Search(16, 10, bend_price=1.0)
"""How bent ones are sought."""

DRAWN = 4
"""So many chains are drawn before the one with the fewest bends is taken."""


@dataclass(frozen=True, eq=False)
class BridgeChain:
    """Bridges through both regions.

    Attributes
    ----------
    bridges : tuple of (int, int)
        The rows where each begins and ends.
    counts : tuple of int
        How often each bends.
    bends : (2, k, 2) array
        All bends in order, in source and target.
    """

    bridges: tuple[Bridge, ...]
    counts: tuple[int, ...]
    bends: Floats


def chain_of(pair: Correspondence, task: Task) -> BridgeChain:
    """Give the cheapest chain: short bridges, in source and target, that part every ring well.

    It is the same whichever region is the source, wherever rings begin, and in a mirrored pair.

    Raises
    ------
    StarskelError
        If a region is too narrow somewhere for floating point.
    """
    reading = RegionReading.of(pair)
    found = _chain(reading.read(pair), task)
    bridges = tuple((int(reading.rows[i]), int(reading.rows[j])) for i, j in found.bridges)
    return replace(found, bridges=bridges, bends=reading.back(found.bends))


def _chain(pair: Correspondence, task: Task) -> BridgeChain:
    regions = [Region(rows, pair.starts, pair.following) for rows in (pair.source, pair.target)]
    bridges = Bridges(pair, regions)
    for search in STRAIGHT:
        for found in chains(bridges, search, task):
            return BridgeChain(found, (0,) * len(found), np.empty((2, 0, 2)))
    bent = list(islice(_bent(bridges, regions, task), DRAWN))
    if not bent:
        raise StarskelError(
            told("no bridges lead to the holes of a part: somewhere it is all but as narrow as rounding"),
            told("widen its narrowest places, or pair the holes otherwise"),
        )
    return min(bent, key=lambda chain: sum(chain.counts))


def _bent(bridges: Bridges, regions: Sequence[Region], task: Task) -> Iterator[BridgeChain]:
    """Give the chains that can be drawn, the cheapest first."""
    for found in chains(bridges, BENT, task):
        task.reach(0)
        bends = bends_of(regions, found, task)
        if bends is not None:
            counts = tuple(map(len, bends[0]))
            yield BridgeChain(found, counts, np.stack([np.concatenate(own) for own in bends]))


def halves(pair: Correspondence, chain: BridgeChain) -> tuple[Indices, Indices]:
    """Give the (k,) rows of the simple polygons right and left of a chain, counter-clockwise.

    The bends' rows follow those of the pair.
    """
    bends = np.split(len(pair) + np.arange(sum(chain.counts)), np.cumsum(chain.counts)[:-1])
    first, last = chain.bridges[0][0], chain.bridges[-1][1]
    stops = [(came[1], left[0]) for came, left in pairwise(chain.bridges)]
    right = [_walk(pair, first, last)]
    for own, stop in zip(bends[:0:-1], reversed(stops), strict=True):
        right += [own[::-1], _walk(pair, stop[1], stop[0])]
    left = [_walk(pair, last, first)]
    for own, stop in zip(bends[:-1], stops, strict=True):
        left += [own, _walk(pair, *stop)]
    return np.concatenate([*right, bends[0][::-1]]), np.concatenate([*left, bends[-1]])


def _walk(pair: Correspondence, start: int, end: int) -> Indices:
    return np.array(list(_rows(pair, start, end)), dtype=np.intp)


def _rows(pair: Correspondence, row: int, end: int) -> Iterator[int]:
    while row != end:
        yield row
        row = int(pair.following[row])
    yield row
