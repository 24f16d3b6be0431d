import numpy as np

from starskel.decomposition.kernels.clipping import boxes

SQUARE = np.array([0, 2, 2 + 2j, 2j])


def test_what_lies_left_of_a_line_is_kept():
    squares = boxes(np.tile(SQUARE, 3), np.array([0, 4, 8]))
    kept = squares.left_of(np.array([1, 1 + 2j, 5 + 0j]), np.array([1 + 2j, 1, 5 + 2j]))
    centroids, areas = kept.measured()
    np.testing.assert_allclose(areas, (2, 2, 4))
    np.testing.assert_allclose(centroids, (0.5 + 1j, 1.5 + 1j, 1 + 1j))


def test_nothing_stays_where_all_lies_to_the_right():
    _, areas = boxes(SQUARE, np.array([0])).left_of(np.array([-1j]), np.array([-1j - 1])).measured()
    assert areas.tolist() == [0]
