"""Seeded random shapes with holes."""

import numpy as np
import shapely

from starskel.predicates import Floats
from tests.families import two_opt


def holed(n: int, holes: int, seed: int) -> list[Floats]:
    """A random outline of n vertices, and in its roomiest places random holes of 3 to 8."""
    rng = np.random.default_rng([n, holes, seed])
    rings = [two_opt(n, seed)]
    for _ in range(holes):
        left = shapely.Polygon(rings[0], rings[1:])
        widest = shapely.maximum_inscribed_circle(left, tolerance=0.01)
        count = int(rng.integers(3, 9))
        angles = 2 * np.pi * np.sort(rng.random(count) * 0.8 + np.arange(count)) / count
        reach = widest.length * rng.uniform(0.5, 0.9) * rng.uniform(0.4, 1, count)
        spokes = np.stack([np.cos(angles), np.sin(angles)], axis=1) * reach[:, None]
        rings.append(shapely.get_coordinates(widest)[0] + spokes)
    return rings
