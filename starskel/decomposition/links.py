"""What two polygons have in common: pairs that see each other in both, diagonals of both."""

import numpy as np

from starskel.decomposition.minimal import Links
from starskel.predicates import Floats
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import visibility


def links_of(source: Triangulation, target: Triangulation, task: Task) -> Links:
    """Give the links of a pair; a diagonal costs its mean length, each in the size of its polygon."""
    first, second = visibility(source, task), visibility(target, task)
    lengths = _lengths(source.vertices) + _lengths(target.vertices)
    price = lengths / (2 * len(lengths) * lengths.max())
    return Links(first.sees & second.sees, first.diagonal & second.diagonal, price)


def _lengths(ring: Floats) -> Floats:
    x, y = ring.T / np.ptp(ring, axis=0).max()
    lengths: Floats = np.hypot(x[:, None] - x, y[:, None] - y)
    return lengths
