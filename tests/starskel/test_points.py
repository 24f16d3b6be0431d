import numpy as np
import pytest

from starskel.points import points_of
from tests.families import blob, comb, subdivided, turned, two_opt


def corners(points):
    ring = np.arange(len(points.coordinates))
    return np.flatnonzero(points.orientation(np.roll(ring, 1), ring, np.roll(ring, -1)))


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.1, 2.5])
@pytest.mark.parametrize("scale", [1.0, 1e-6, 1e6])
def test_vertices_on_straight_runs_are_found_however_the_ring_is_turned(angle, scale):
    ring = subdivided(two_opt(9, 4), 5)
    points = points_of(turned(ring, angle) * scale)
    np.testing.assert_array_equal(corners(points), np.arange(0, 45, 5))
    expected = np.tile([0, 0.2, 0.4, 0.6, 0.8], 9)
    np.testing.assert_allclose(points.share[points.rounded], expected[points.rounded], atol=1e-9)


def test_far_from_the_origin_the_rounding_of_the_coordinates_counts():
    ring = turned(subdivided(comb(3), 4), 0.7) + 1e6
    assert len(corners(points_of(ring))) == len(comb(3)) - 1  # one vertex of the comb is straight itself


def test_gentle_curves_are_no_straight_runs():
    assert len(corners(points_of(blob(2000)))) == 2000


def test_many_vertices_on_one_edge():
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], dtype=float)
    points = points_of(turned(subdivided(square, 2500), 0.2))
    np.testing.assert_array_equal(corners(points), [0, 2500, 5000, 7500])


def test_straight_vertices_do_not_bend_their_run():
    ring = turned(subdivided(np.array([(0, 0), (9, 1), (3, 8)], dtype=float), 7), 0.4)
    points = points_of(ring)
    run = np.arange(8)
    i, j, k = np.meshgrid(run, run, run)
    assert not points.orientation(i, j, k).any()


def test_a_straight_vertex_is_beside_a_line_that_cuts_its_run_near_it():
    ring = turned(subdivided(np.array([(0, 0), (9, 1), (3, 8)], dtype=float), 3), 0.4)
    points = points_of(ring)
    exact = ring[0] + points.share[1] * (ring[3] - ring[0])
    near = points.with_free(np.array([exact + (ring[6] - exact) / 2]))
    one, six, free = (np.array([i]) for i in (1, 6, 9))
    assert (
        near.orientation(np.array([0]), six, free).item()
        == -near.orientation(np.array([3]), six, free).item()
    )
    assert near.orientation(one, one, six).item() == 0


def test_points_on_chords_stand_exactly_on_them():
    """Also where the ends of a chord are rounded themselves."""
    ring = turned(subdivided(two_opt(8, 3), 3), 0.7)
    points = points_of(ring)
    assert points.rounded.any()
    start, end = np.repeat(np.arange(0, 8), 3), np.repeat(np.arange(12, 20), 3)
    added = points.with_on_chords(start, end, np.tile([0.1, 1 / 3, 0.9], 8))
    rows = len(ring) + np.arange(24)
    assert not added.orientation(start, rows, end).any()
    assert not added.orientation(rows[::3], rows[1::3], rows[2::3]).any()
    sides = points.orientation(start[:, None], end[:, None], np.arange(len(ring))[None])
    np.testing.assert_array_equal(added.orientation(rows[:, None], end[:, None], np.arange(len(ring))), sides)


@pytest.mark.parametrize("shift", [0, 1e6])
def test_turns_to_places_are_those_to_points_added_there(shift):
    rng = np.random.default_rng(3)
    points = points_of(turned(subdivided(two_opt(8, 6), 3), 0.4) + shift)
    n = len(points.coordinates)
    places = np.concatenate([points.coordinates, rng.uniform(-50, 150, (40, 2)) + shift])
    i, j = rng.integers(n, size=(2, 2000))
    k = rng.integers(len(places), size=2000)
    for some in (places[:n], places):  # all within the box round the points, and not
        wanted = points.with_free(some).orientation(i, j, n + k % len(some))
        np.testing.assert_array_equal(points.orientation_to(i, j, k % len(some), some), wanted)
        assert len(set(wanted.tolist())) == 3
