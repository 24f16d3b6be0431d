"""One way to read a pair of regions, wherever they lie: as their outlines are read, behind them the holes.

Which way round a chain of bridges leads costs nothing, and much else about bridges hangs on the order of
rings and rows. So they are sought in a pair that is read as `starskel.decomposition.canonical` says: holes
and their vertices that are far out come first, what is as far out is told apart by coordinates.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.correspondence import Correspondence
from starskel.decomposition.canonical import PairReading, canonical
from starskel.predicates import DIGITS


@dataclass(frozen=True, eq=False)
class RegionReading:
    """A way to read a pair of regions.

    Attributes
    ----------
    outline : PairReading
        How the outlines are read, and whether regions are exchanged and mirrored.
    rows : (n,) array of int
        All rows in the order in which they are read.
    starts : tuple of int
        At which of these rings begin.
    """

    outline: PairReading
    rows: Indices
    starts: tuple[int, ...]

    @classmethod
    def of(cls, pair: Correspondence) -> "RegionReading":
        """Give the canonical reading."""
        outline, *holes = np.split(np.arange(len(pair)), pair.starts[1:])
        reading = canonical(pair)
        first, second = reading.ordered(
            [_distances(rows, len(outline)) for rows in (pair.source, pair.target)]
        )
        far = (2 * first + second).round(DIGITS)
        places = np.concatenate(
            reading.ordered([reading.placed(rows) for rows in (pair.source, pair.target)]), axis=1
        )

        def order(row: int) -> tuple[float, ...]:
            return -far[row], *places[row].tolist()

        read = [_from(hole, min(hole.tolist(), key=order), reading.mirrored) for hole in holes]
        read.sort(key=lambda hole: order(int(hole[0])))
        rings = [outline[reading.rows(len(outline))], *read]
        starts = np.cumsum([0, *map(len, rings[:-1])]).tolist()
        return cls(reading, np.concatenate(rings), tuple(starts))

    def read(self, pair: Correspondence) -> Correspondence:
        """Give the pair as it is read."""
        sides = [self.outline.placed(rows[self.rows]) for rows in (pair.source, pair.target)]
        source, target = self.outline.ordered(sides)
        own = np.arange(len(pair))
        return Correspondence(source, target, (), own, own, self.starts)

    def back(self, places: Floats) -> Floats:
        """Give (2, k, 2) places in the regions as they are read where they are in source and target."""
        return np.stack(self.outline.ordered([self.outline.placed(side) for side in places]))


def _distances(rows: Floats, outline: int) -> Floats:
    """Give how far rows are from the middle of the outline's, over what these are in the mean."""
    distances = np.hypot(*(rows - rows[:outline].mean(axis=0)).T)
    return np.asarray(distances / distances[:outline].mean())


def _from(ring: Indices, row: int, backwards: bool) -> Indices:
    """Give the rows of a ring from one of them on."""
    steps = np.arange(len(ring))
    return np.asarray(ring[(row - ring[0] + (-steps if backwards else steps)) % len(ring)])
