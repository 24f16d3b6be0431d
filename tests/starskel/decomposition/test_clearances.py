import numpy as np
import pytest
import shapely

from starskel.decomposition.transfer.clearances import (
    are_diagonals,
    place_clearances,
    reflex_vertices,
    rounding,
    segment_clearances,
)
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import UNWATCHED
from starskel.triangulation import triangulate
from starskel.visibility import visibility


def whole(ring):
    return Rings.of([range(len(ring))])


def test_the_segments_that_are_diagonals_are_those_that_all_pairs_know(ring):
    n = len(ring)
    i, j = np.triu_indices(n, 1)
    rings = Rings.of([range(n)] * len(i))
    found = are_diagonals(points_of(ring), rings, rings.first + i, rings.first + j, UNWATCHED)
    expected = visibility(triangulate(points_of(ring), Rings.of([range(n)]))).diagonal[i, j]
    np.testing.assert_array_equal(found, expected)
    assert 0 < expected.sum() < len(i)


def test_the_clearance_of_a_place_is_the_distance_from_the_outline(ring):
    places = np.random.default_rng(3).uniform(ring.min(axis=0), ring.max(axis=0), (50, 2))
    found = place_clearances(places, np.zeros(50, dtype=int), points_of(ring), whole(ring), UNWATCHED)
    outline = shapely.LinearRing(ring)
    np.testing.assert_allclose(found, shapely.distance(outline, shapely.points(places)), atol=1e-12)


def test_the_clearance_of_a_segment_is_the_distance_from_the_nearest_corner_of_the_own_ring():
    segments = np.random.default_rng(4).random((40, 2, 2))
    corners = np.random.default_rng(5).random((9, 2))
    rings = Rings(np.arange(9), np.array([4, 0, 5]))
    owner = np.arange(40) % 3
    found = segment_clearances(segments, owner, corners, rings, UNWATCHED)
    for segment, own, clearance in zip(segments, owner, found, strict=True):
        near = corners[rings.owner == own]
        expected = shapely.distance(shapely.LineString(segment), shapely.points(near)).min(initial=np.inf)
        assert clearance == pytest.approx(expected, abs=1e-12)
    assert np.isinf(found[owner == 1]).all()


def test_reflex_vertices_are_those_that_turn_right_but_for_some_left_out():
    ring = np.array([(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)], dtype=float)
    rings = Rings.of([range(6), [0, 1, 2, 3], [0, 1, 3, 4, 5]])
    none = np.empty(0, dtype=int)
    assert reflex_vertices(points_of(ring), rings, none).rows.tolist() == [3, 3]
    left = reflex_vertices(points_of(ring), rings, np.array([3]))
    assert left.rows.tolist() == [3]
    assert left.counts.tolist() == [0, 0, 1]


def test_rounding_grows_with_the_largest_coordinate_of_each_ring():
    points = points_of(np.array([(0, 0), (1, 0), (1, 1), (8, -16)], dtype=float))
    slack = rounding(points, Rings.of([[0, 1, 2], [1, 2, 3]]))
    assert slack[1] == 16 * slack[0] > 0
