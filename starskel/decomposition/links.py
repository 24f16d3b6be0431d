"""What two polygons have in common: pairs that see each other in both, diagonals of both."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from starskel.arrays import Flags, Floats, Indices
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import visibility


@dataclass(frozen=True, eq=False)
class Links:
    """What both polygons allow.

    Attributes
    ----------
    sees : (n, n) array of bool
        Pairs of vertices that see each other in both polygons.
    diagonal : (n, n) array of bool
        Diagonals of both polygons.
    source, target : (n, 2) arrays
        The polygons, scaled so that n diagonals of both together are shorter than 1/2.
    rings : Rings
        The vertices, if these are several pairs of polygons: of different ones none see each other.
    """

    sees: Flags
    diagonal: Flags
    source: Floats
    target: Floats
    rings: Rings

    @cached_property
    def sizes(self) -> Floats:
        """The (n,) numbers of vertices of the rings that the vertices belong to."""
        sizes: Floats = self.rings.counts[self.rings.owner].astype(np.float64)
        return sizes

    @cached_property
    def nearest(self) -> Indices:
        """The (n,) first vertices beyond each to which a diagonal leads, n where none does."""
        beyond = np.triu(self.diagonal)
        nearest: Indices = np.where(beyond.any(axis=1), beyond.argmax(axis=1), len(beyond))
        return nearest

    def price(self, i: Indices, j: Indices) -> Floats:
        """Give what diagonals cost, (k,): their lengths in both polygons."""
        lengths = [np.hypot(*(side[i] - side[j]).T) for side in (self.source, self.target)]
        return np.asarray(lengths[0] + lengths[1])


def links_of(source: Triangulation, target: Triangulation, task: Task) -> Links:
    """Give the links of pairs of rings; a diagonal costs its lengths, each in the size of its ring."""
    first, second = visibility(source, task), visibility(target, task)
    return Links(
        first.sees & second.sees,
        first.diagonal & second.diagonal,
        _scaled(source),
        _scaled(target),
        source.rings,
    )


def _scaled(ground: Triangulation) -> Floats:
    vertices, rings = ground.vertices, ground.rings
    high, low = (extreme.reduceat(vertices, rings.first) for extreme in (np.maximum, np.minimum))
    size = 8 * rings.counts * (high - low).max(axis=1)
    scaled: Floats = vertices / size[rings.owner, None]
    return scaled
