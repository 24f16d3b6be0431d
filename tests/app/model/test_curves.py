import numpy as np
import pytest

from app.model.curves import flattened

CIRCLE = 0.5522847498
QUARTER = np.array([(1.0, 0.0), (1.0, CIRCLE), (CIRCLE, 1.0), (0.0, 1.0)])


@pytest.mark.parametrize("tolerance", [0.1, 0.01, 0.001])
def test_the_lines_stay_within_the_tolerance(tolerance: float) -> None:
    path = np.concatenate([QUARTER[:1], flattened(QUARTER, tolerance)])
    middles = (path[1:] + path[:-1]) / 2
    assert (
        1 - np.hypot(*middles.T)
    ).max() < tolerance + 3e-4  # the curve itself leaves the circle by as much
    coarser = flattened(QUARTER, 4 * tolerance)
    assert len(coarser) < len(path)


def test_a_straight_curve_is_one_line() -> None:
    assert flattened(np.array([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]), 0.01).tolist() == [[3, 3]]


def test_the_end_is_exact() -> None:
    assert flattened(QUARTER, 1e-9)[-1].tolist() == [0, 1]
