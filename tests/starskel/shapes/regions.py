"""Seeded random shapes with holes."""

import numpy as np
import shapely

import starskel
from starskel import Shape
from starskel.arrays import Floats
from starskel.shapes.correspondence import ShapeCorrespondence
from tests.families import two_opt
from tests.starskel.shapes.drawn import moved


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


def holed_pair(seed: int) -> ShapeCorrespondence:
    """Two shapes that have nothing but the number of holes in common, one to four."""
    rng = np.random.default_rng(seed)
    holes, n, m = 1 + seed % 4, *rng.integers(8, 20, 2).tolist()
    source, target = Shape(holed(n, holes, 2 * seed)), Shape(holed(m, holes, 2 * seed + 1))
    links = [(k, k) for k in range(holes + 1)]
    return starskel.match(source, target, [[(0, 0)]] * (holes + 1), pairing=links)


def parts_in_a_row(seed: int) -> tuple[list[Floats], list[Floats]]:
    """Two shapes of as many parts, one to three, with as many holes, none to two; each part lies turned."""
    rng = np.random.default_rng([7, seed])
    holes = [(seed % 3, 0, 1)[part] for part in range(int(rng.integers(1, 4)))]
    return _in_a_row(holes, rng), _in_a_row(holes, rng)


def _in_a_row(holes: list[int], rng: np.random.Generator) -> list[Floats]:
    rings: list[Floats] = []
    for part, count in enumerate(holes):
        own = holed(int(rng.integers(6, 14)), count, int(rng.integers(1e6)))
        angle = rng.uniform(0, 2 * np.pi)
        rings += moved(own, angle, 130 * part + rng.uniform(-10, 10), rng.uniform(-60, 60))
    return rings
