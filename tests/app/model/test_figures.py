import numpy as np
import pytest

from app.model import figures
from starskel.outline import signed_areas
from starskel.polygon import Polygon


def test_a_rectangle_runs_counter_clockwise_whichever_corners_it_is_given_by() -> None:
    for corners in (((0, 0), (4, 2)), ((4, 2), (0, 0)), ((0, 2), (4, 0))):
        assert figures.rectangle(*corners).tolist() == [[0, 0], [4, 0], [4, 2], [0, 2]]


def test_an_ellipse_fills_its_box() -> None:
    ring = figures.ellipse((1, 2), (9, 6), 40)
    np.testing.assert_allclose(ring.min(axis=0), (1, 2))
    np.testing.assert_allclose(ring.max(axis=0), (9, 6))
    assert len(Polygon(ring)) == 40


@pytest.mark.parametrize("count", [3, 6, 17])
def test_a_regular_polygon_has_equal_edges_and_a_vertex_at_the_corner(count: int) -> None:
    ring = figures.regular_polygon((1, 1), (4, 5), count)
    np.testing.assert_allclose(ring[0], (4, 5))
    lengths = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
    np.testing.assert_allclose(lengths, lengths[0])
    assert signed_areas(ring) > 0


def test_a_star_has_points_and_inner_vertices_in_turn() -> None:
    ring = figures.star((0, 0), (0, 2), 5, 0.4)
    np.testing.assert_allclose(np.hypot(*ring.T), [2, 0.8] * 5)
    np.testing.assert_allclose(ring[0], (0, 2), atol=1e-12)
    assert len(Polygon(ring)) == 10
