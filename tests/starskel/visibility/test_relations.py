import numpy as np
import pytest

from starskel import triangulation
from starskel.errors import Cancelled
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import visibility, visibility_from
from tests.families import blob, comb, spiral, subdivided, turned, two_opt
from tests.starskel.exact import all_relations, rational, relations


def triangulate(ring) -> Triangulation:
    return triangulation.triangulate(points_of(ring), Rings.of([range(len(ring))]))


RINGS = {
    **{
        f"grid {n} {seed}": two_opt(n, seed, grid)
        for n, grid in ((8, 3), (14, 5), (20, 6))
        for seed in range(8)
    },
    **{f"random {seed}": two_opt(18, seed) for seed in range(4)},
    "comb": comb(5),
    "subdivided comb": subdivided(comb(3), 2),
    "spiral": spiral(20),
}


@pytest.fixture(params=list(RINGS))
def ring(request):
    return RINGS[request.param]


@pytest.mark.parametrize("way", [triangulation.triangulate, triangulation.delaunay])
def test_both_relations_agree_with_rational_arithmetic(ring, way):
    seen = visibility(way(points_of(ring), Rings.of([range(len(ring))])))
    sees, diagonal = all_relations(ring)
    np.testing.assert_array_equal(seen.sees, sees)
    np.testing.assert_array_equal(seen.diagonal, diagonal)


GRIDS = ((9, 3), (14, 4), (14, 5), (16, 4), (24, 5))


@pytest.mark.parametrize("scale", [2.0**-20, 2.0**20])
@pytest.mark.parametrize(("n", "grid"), GRIDS)
def test_full_grids_agree_with_rational_arithmetic_at_any_size(n, grid, scale):
    ring = two_opt(n, 7, grid)
    seen = visibility(triangulate(ring * scale + 2.0**20 * scale))
    sees, diagonal = all_relations(ring)
    np.testing.assert_array_equal(seen.sees, sees)
    np.testing.assert_array_equal(seen.diagonal, diagonal)


CHANGES = {
    "scaled by 1e-6": lambda ring: ring * 1e-6,
    "scaled by 1e6": lambda ring: ring * 1e6,
    "shifted by 1e6": lambda ring: ring + 1e6,
    "scaled and shifted": lambda ring: ring * 0.1 + 0.3,
    "turned": lambda ring: turned(ring, 0.5),
    "turned and shifted": lambda ring: turned(ring, 2.0) + 1e6,
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
@pytest.mark.parametrize(("n", "grid"), GRIDS)
def test_diagonals_of_grids_stay_when_the_coordinates_are_rounded(n, grid, change):
    for seed in range(2):
        exact = two_opt(n, seed, grid)
        ring = change(exact)
        seen = visibility(triangulate(ring))
        np.testing.assert_array_equal(seen.diagonal, all_relations(exact)[1])
        if not points_of(ring).rounded.any():  # rational arithmetic on the coordinates would bend the runs
            np.testing.assert_array_equal(seen.sees, all_relations(ring)[0])


def test_views_that_are_followed_in_small_handfuls_see_the_same(monkeypatch):
    for ring in (blob(60, 2), subdivided(comb(4), 3)):
        ground = triangulate(ring)
        whole = visibility(ground)
        with monkeypatch.context() as patch:
            patch.setattr("starskel.visibility.views.BLOCK", 16)
            parts = visibility(ground)
        np.testing.assert_array_equal(whole.sees, parts.sees)
        np.testing.assert_array_equal(whole.diagonal, parts.diagonal)


def test_it_stops_when_told_to():
    with pytest.raises(Cancelled):
        visibility(triangulate(blob(60)), Task(should_stop=lambda: True))


def test_triangles_with_corners_inside_the_ring_are_refused():
    square = points_of(np.array([(0, 0), (2, 0), (2, 2), (0, 2)], dtype=float)).with_free(
        np.array([(1.0, 1.0)])
    )
    triangles = np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])
    twins = np.array([-1, 5, 10, -1, 8, 1, -1, 11, 4, -1, 2, 7])
    with pytest.raises(ValueError, match="4 triangles cannot tile rings of 4 vertices"):
        visibility(Triangulation(square, Rings.of([range(4)]), triangles, twins))


@pytest.mark.parametrize("angle", [0.1, 1.0, 4.0])
def test_turning_a_ring_of_straight_runs_changes_nothing(angle):
    ring = subdivided(two_opt(10, 3), 4)
    still, moved = (visibility(triangulate(r)) for r in (ring, turned(ring, angle)))
    np.testing.assert_array_equal(still.sees, moved.sees)
    np.testing.assert_array_equal(still.diagonal, moved.diagonal)


@pytest.mark.parametrize("seed", range(6))
def test_places_see_what_rational_arithmetic_says(seed):
    ring = two_opt(12, seed, 5)
    ground = triangulate(ring)
    corners = ring[ground.triangles]
    places = weighted(corners)
    seen = visibility_from(ground, places, np.arange(len(places)) % len(corners))
    exact = rational(ring)
    for row, place in enumerate(rational(places)):
        expected = [relations(len(ring), v, [*exact, place], ring=exact) for v in range(len(ring))]
        np.testing.assert_array_equal(np.stack([seen.sees[row], seen.diagonal[row]], axis=1), expected)


def weighted(corners):
    """Two places in each triangle, in multiples of 1/4, so that views graze vertices exactly."""
    return np.concatenate(
        [np.einsum("w,fwx->fx", w, corners) for w in ((0.5, 0.25, 0.25), (0.25, 0.25, 0.5))]
    )


def test_from_a_place_outside_its_triangle_nothing_is_seen():
    ring = comb(3)
    ground = triangulate(ring)
    seen = visibility_from(ground, np.array([(-5.0, 0.5), *ring[:1]]), np.array([0, 0]))
    assert not seen.sees.any()
    assert not seen.diagonal.any()
