import numpy as np
import pytest

from starskel.points import points_of
from starskel.rings import Rings, ranges
from starskel.triangulation import triangulate
from starskel.visibility import visibility
from tests.families import comb, subdivided, turned, two_opt


def test_neighbours_stay_within_their_ring():
    rings = Rings.of([(4, 7, 5), range(4)])
    assert rings.rows.tolist() == [4, 7, 5, 0, 1, 2, 3]
    assert rings.following.tolist() == [1, 2, 0, 4, 5, 6, 3]
    assert rings.preceding.tolist() == [2, 0, 1, 6, 3, 4, 5]
    assert rings.owner.tolist() == [0, 0, 0, 1, 1, 1, 1]


def test_ranges_count_up_from_each_number():
    owner, number = ranges(np.array([5, 0, 7]), np.array([2, 0, 3]))
    assert owner.tolist() == [0, 0, 2, 2, 2]
    assert number.tolist() == [5, 6, 7, 8, 9]


SHAPES = [two_opt(20, 1), comb(4), turned(subdivided(two_opt(8, 6), 3), 0.4)]


@pytest.mark.parametrize("shape", SHAPES, ids=["random", "comb", "straight runs"])
def test_rings_that_are_looked_at_together_see_what_each_sees_alone(shape):
    points, whole = points_of(shape), np.arange(len(shape))
    inner = visibility(triangulate(points, Rings.of([whole]))).diagonal
    i, j = np.argwhere(inner)[len(shape) // 2]
    rings = Rings.of([whole, whole[i : j + 1], np.concatenate([whole[: i + 1], whole[j:]]), whole])
    together = visibility(triangulate(points, rings))
    expected = np.zeros_like(together.sees), np.zeros_like(together.sees)
    for ring, first in rings.parts():
        alone = visibility(triangulate(points, Rings.of([ring])))
        block = slice(first, first + len(ring))
        expected[0][block, block], expected[1][block, block] = alone.sees, alone.diagonal
    np.testing.assert_array_equal(together.sees, expected[0])
    np.testing.assert_array_equal(together.diagonal, expected[1])
