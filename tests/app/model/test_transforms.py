import numpy as np

from app.model import transforms
from app.model.transforms import Box, box_of

POINTS = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 2.0)])


def test_a_box_is_the_smallest_around_points() -> None:
    box = box_of(POINTS)
    assert (box.low, box.high, box.middle, box.size) == ((0, 0), (4, 2), (2, 1), (4, 2))
    assert box.at(0.5, 1) == (2, 2)
    assert box.contains((4, 2))
    assert not box.contains((4, 2.1))
    assert box.wider(1) == Box((-1, -1), (5, 3))


def test_scaling_keeps_what_it_is_about() -> None:
    assert transforms.scaled(POINTS, (4, 0), (2, 3)).tolist() == [[-4, 0], [4, 0], [4, 6]]


def test_scaling_by_less_than_nothing_mirrors() -> None:
    assert transforms.scaled(POINTS, (2, 1), (-1, 1)).tolist() == [[4, 0], [0, 0], [0, 2]]


def test_turning_is_counter_clockwise() -> None:
    np.testing.assert_allclose(
        transforms.turned(POINTS, (4, 0), np.pi / 2), [[4, -4], [4, 0], [2, 0]], atol=1e-12
    )
