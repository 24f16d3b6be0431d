import numpy as np

from starskel.decomposition.kernels.kernel import are_seen_well_from, star_points, star_vertices
from starskel.points import points_of
from starskel.rings import Rings
from tests.families import comb, subdivided, turned, two_opt

L_SHAPE = np.array([(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)], dtype=float)


def rows(ring):
    return np.arange(len(ring))


def star_point(points, ring):
    """The centroid of a ring's kernel, or None."""
    ((places, areas),) = star_points([points], Rings.of([ring]))
    return places[0] if areas[0] > 0 else None


def stars(ring):
    return np.flatnonzero(star_vertices([points_of(ring)], Rings.of([rows(ring)])))


def test_star_vertices_of_an_angle():
    np.testing.assert_array_equal(stars(L_SHAPE), [0, 3])


def test_the_star_point_is_the_centroid_of_the_kernel():
    place = star_point(points_of(L_SHAPE), rows(L_SHAPE))
    np.testing.assert_allclose(place, (0.5, 0.5))


def test_a_comb_has_no_star_point():
    ring = comb(3)
    assert star_point(points_of(ring), rows(ring)) is None
    assert not len(stars(ring))


def test_straight_runs_bound_nothing_however_they_are_turned():
    ring = turned(subdivided(L_SHAPE, 3), 0.3)
    np.testing.assert_array_equal(stars(ring), [0, 9])
    np.testing.assert_allclose(turned(star_point(points_of(ring), rows(ring))[None], -0.3)[0], (0.5, 0.5))


def test_vertices_on_one_line_have_no_star_point():
    points = points_of(subdivided(L_SHAPE, 3))
    assert star_point(points, np.arange(3)) is None


def test_many_rings_are_asked_for_star_vertices_as_each_is_alone():
    rng = np.random.default_rng(5)
    first, second = points_of(two_opt(30, 1)), points_of(two_opt(30, 1) @ np.array([[1.0, 0.4], [0.2, 1.0]]))
    rings = [np.sort(rng.choice(30, size, replace=False)) for size in rng.integers(3, 9, 200)]
    alone = [[star_vertices([p], Rings.of([r])) for p in (first, second)] for r in rings]
    together = star_vertices((first, second), Rings.of(rings))
    np.testing.assert_array_equal(together, np.concatenate([a & b for a, b in alone]))
    assert 20 < together.sum() < 500


def test_places_that_prove_rings_well_keep_off_their_edges():
    ring, thin = rows(L_SHAPE), np.array([0, 2, 3])
    points = points_of(L_SHAPE)
    rings = Rings.of([ring] * 3 + [thin])
    places = np.array([(0.5, 0.5), (1e-12, 0.5), (2, 0.5), (4 / 3, 2 / 3)])
    assert are_seen_well_from([points], rings, [places]).tolist() == [True, False, False, True]
    assert are_seen_well_from([points] * 2, rings, [places, places[::-1]]).tolist() == [False] * 4


def test_what_a_place_proves_well_the_star_point_proves_as_well():
    rng = np.random.default_rng(8)
    points = points_of(two_opt(40, 3))
    rings = Rings.of([np.sort(rng.choice(40, size, replace=False)) for size in rng.integers(3, 7, 2000)])
    ((middles, areas),) = star_points([points], rings)
    spread = rng.normal(0, 1, middles.shape) * 10.0 ** rng.uniform(-12, 1, (len(middles), 1))
    seen = are_seen_well_from([points], rings, [middles + spread])
    assert (areas[seen] > 0).all()
    assert 50 < seen.sum() < (areas > 0).sum()
