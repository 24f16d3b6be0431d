"""What two polygons have in common: pairs that see each other in both, diagonals of both."""

import numpy as np

from starskel.decomposition.minimal import Links
from starskel.predicates import Floats
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import visibility


def links_of(source: Triangulation, target: Triangulation, task: Task) -> Links:
    """Give the links of a pair; a diagonal costs its lengths, each in the size of its polygon."""
    first, second = visibility(source, task), visibility(target, task)
    return Links(
        first.sees & second.sees,
        first.diagonal & second.diagonal,
        _scaled(source.vertices),
        _scaled(target.vertices),
    )


def _scaled(ring: Floats) -> Floats:
    scaled: Floats = ring / (8 * len(ring) * np.ptp(ring, axis=0).max())
    return scaled
