"""One way to read a pair, wherever it lies: which polygon first, from which vertex, and which way round.

The choice rests on the distances of the vertices from the middle of their polygon alone. So a pair is
decomposed in one way, whichever of its polygons is the source and whatever vertex it starts with, and as it
is where it was moved, turned or mirrored. Ways that these distances cannot tell apart, as in symmetric
shapes, are told apart by coordinates.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.correspondence import Correspondence
from starskel.decomposition.pieces import Piece
from starskel.predicates import ROUNDING

MIRROR = np.array([-1.0, 1.0])


@dataclass(frozen=True)
class PairReading:
    """A way to read a pair of polygons.

    Attributes
    ----------
    swapped : bool
        Whether the target comes first.
    mirrored : bool
        Whether both polygons are mirrored and their vertices read the other way round.
    start : int
        The first vertex.
    """

    swapped: bool
    mirrored: bool
    start: int

    def rows(self, n: int) -> Indices:
        """Give the vertices in the order in which they are read."""
        steps = np.arange(n)
        rows: Indices = (self.start + (-steps if self.mirrored else steps)) % n
        return rows

    def read(self, pair: Correspondence) -> list[Floats]:
        """Give both polygons."""
        rows = self.rows(len(pair))
        return self.ordered([self.placed(ring[rows]) for ring in (pair.source, pair.target)])

    def placed(self, places: Floats) -> Floats:
        """Give places where they are read, or back again."""
        return places * MIRROR if self.mirrored else places

    def ordered(self, sides: list[Floats]) -> list[Floats]:
        """Give what belongs to source and target in the order in which these are read, or back again."""
        return sides[::-1] if self.swapped else sides

    def turned(self, piece: Piece) -> Piece:
        """Give a piece that is counter-clockwise where it is read, counter-clockwise again, or back."""
        return piece[::-1] if self.mirrored else piece


def canonical(pair: Correspondence) -> PairReading:
    """Give the reading whose vertices are far out first, in the first polygon above all.

    Of regions with holes it is that of the outlines.
    """
    outline = slice(*pair.starts[1:2] or [None])
    rings = [pair.source[outline], pair.target[outline]]
    radii, doubt = zip(*map(_radii, rings), strict=True)
    readings = [(swapped, mirrored) for swapped in (False, True) for mirrored in (False, True)]
    scores = np.array(
        [_scores(2 * radii[swapped] + radii[not swapped], mirrored) for swapped, mirrored in readings]
    )
    ways, starts = np.nonzero(scores >= scores.max() - len(rings[0]) * sum(doubt))
    best = [
        PairReading(*readings[way], start) for way, start in zip(ways.tolist(), starts.tolist(), strict=True)
    ]
    return min(best, key=lambda reading: _beginning(reading, rings)) if len(best) > 1 else best[0]


def _radii(ring: Floats) -> tuple[Floats, float]:
    """Give the distances of vertices from their mean, over the mean, and how doubtful rounding makes them."""
    radii = np.hypot(*(ring - ring.mean(axis=0)).T)
    return radii / radii.mean(), ROUNDING * float(np.abs(ring).max() / radii.mean())


def _scores(radii: Floats, mirrored: bool) -> Floats:
    """Give for each start the sum of the radii read from there, each over its place; by Fourier transform."""
    n = len(radii)
    weights = 1 / np.arange(1, n + 1)
    transform = np.fft.rfft(weights)
    scores: Floats = np.fft.irfft(np.fft.rfft(radii) * (transform if mirrored else transform.conj()), n)
    return scores


def _beginning(reading: PairReading, rings: list[Floats]) -> list[float]:
    """Give the first edges of both polygons as they are read."""
    rows = reading.rows(len(rings[0]))[:2]
    return [x for ring in reading.ordered(rings) for x in reading.placed(ring[rows]).ravel().tolist()]
