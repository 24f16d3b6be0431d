from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from starskel.predicates import folds_back, orientation, segments_meet


def exact_orientation(a, b, c) -> int:
    (ax, ay), (bx, by), (cx, cy) = ((Fraction(float(x)), Fraction(float(y))) for x, y in (a, b, c))
    turn = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)
    return (turn > 0) - (turn < 0)


def agrees(a, b, c) -> None:
    expected = [exact_orientation(*points) for points in zip(a, b, c, strict=True)]
    np.testing.assert_array_equal(orientation(a, b, c), expected)


@pytest.mark.parametrize("scale", [1.0, 0.1, 1e-6, 1e6])
@pytest.mark.parametrize("shift", [0.0, 0.1, 1e6])
def test_orientation_is_exact_on_grids(scale, shift):
    points = np.random.default_rng(1).integers(0, 4, (500, 3, 2)) * scale + shift
    agrees(*points.transpose(1, 0, 2))


def test_orientation_is_exact_for_points_that_all_but_lie_on_a_line():
    rng = np.random.default_rng(2)
    a, b = rng.random((2, 500, 2))
    c = a + rng.random((500, 1)) * (b - a)
    assert {-1, 1} == set(orientation(a, b, c).tolist())
    agrees(a, b, c)


coordinate = st.floats(-1e100, 1e100, allow_subnormal=False).filter(lambda x: x == 0 or abs(x) > 1e-100)
point = st.tuples(coordinate, coordinate)


@given(point, point, point)
def test_orientation_is_exact_for_any_floats(a, b, c):
    agrees(*(np.array([p]) for p in (a, b, c)))


def test_orientation_broadcasts_and_takes_single_points():
    a, b, c = np.array([0.0, 0.0]), np.array([1.0, 0.0]), np.array([[0.0, 1.0], [2.0, 0.0], [0.0, -1.0]])
    np.testing.assert_array_equal(orientation(a, b, c), [1, 0, -1])
    assert orientation(a, b, c[1]) == 0


@pytest.mark.parametrize(
    ("ends", "meet"),
    [
        ([(0, 0), (2, 2), (0, 2), (2, 0)], True),
        ([(0, 0), (2, 0), (1, 0), (1, 3)], True),
        ([(0, 0), (2, 0), (1, 0), (3, 0)], True),
        ([(0, 0), (2, 0), (0, 1), (2, 1)], False),
        ([(0, 0), (2, 2), (2, 1.9), (3, 0)], False),
    ],
)
def test_segments_meet(ends, meet):
    a, b, c, d = np.array(ends, dtype=float)[:, None]
    assert segments_meet(a, b, c, d).item() is meet
    assert segments_meet(c, d, b, a).item() is meet


def test_a_spike_folds_back_and_a_straight_run_does_not():
    a, b = np.array([[0.1, 0.1]]), np.array([[0.3, 0.3]])
    assert folds_back(a, b, np.array([[0.2, 0.2]])).item()
    assert not folds_back(a, b, np.array([[0.4, 0.4]])).item()
    assert not folds_back(a, b, np.array([[0.1, 0.2]])).item()
