import numpy as np
import pytest

from starskel.decomposition.clipping import boxes, cut_along

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


@pytest.mark.parametrize("counts", [(1, 3, 0), (0, 0, 2), (4, 1, 1)])
def test_each_cell_is_cut_along_its_own_lines(counts):
    rng = np.random.default_rng(sum(counts))
    ends = rng.uniform(0, 2, (2, sum(counts), 2)).view(np.complex128)[..., 0]
    first = np.cumsum(counts) - counts
    together = cut_along(boxes(np.tile(SQUARE, 3), np.array([0, 4, 8])), tuple(ends), first, np.array(counts))
    for cell, (begun, count) in enumerate(zip(first, counts, strict=True)):
        alone = boxes(SQUARE, np.array([0]))
        for line in range(begun, begun + count):
            alone = alone.left_of(ends[0, [line]], ends[1, [line]])
        np.testing.assert_allclose(together.measured()[1][cell], alone.measured()[1][0])
