import numpy as np

from starskel.points import points_of
from starskel.rings import Rings
from starskel.triangulation import _delaunay


def teeth_round_the_origin(count):
    """Give a ring on a grid round the origin: many of its coordinates differ in their signs only."""
    x = np.arange(-count, count + 1)
    teeth = np.stack([np.repeat(x, 2)[1:-1], np.tile([1, 1, 2, 2], count)[: 4 * count]], axis=1)
    return np.concatenate([teeth[::-1], teeth * [1, -1]]).astype(float)


def test_vertices_are_found_again_that_differ_in_signs_and_round_numbers_only():
    ring = teeth_round_the_origin(50)
    triangles = _delaunay(points_of(ring), Rings.of([np.arange(len(ring))]))
    assert triangles is not None
    assert len(triangles) == len(ring) - 2
