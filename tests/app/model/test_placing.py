from math import pi, remainder, tau

import numpy as np
import pytest

from app.model import placing
from app.tools.handles import CORNERS
from starskel.files.projects.picture import Picture

TURNS = (0.0, 0.4, -2.0, pi)


def picture(rotation: float) -> Picture:
    return Picture(b"", (3.0, 1.0), (4.0, 2.0), rotation=rotation)


def test_shares_are_where_the_turned_frame_has_them() -> None:
    assert placing.place_on(picture(0), 0, 0) == pytest.approx((1, 0))
    assert placing.place_on(picture(pi / 2), 1, 1) == pytest.approx((2, 3))
    assert placing.corners_of(picture(pi))[0].tolist() == pytest.approx([5, 2])


@pytest.mark.parametrize("rotation", TURNS)
def test_what_is_on_a_picture_turns_with_it(rotation: float) -> None:
    for x, y, there in ((0.02, 0.03, True), (0.98, 0.5, True), (1.05, 0.5, False), (0.5, -0.1, False)):
        assert placing.holds(picture(rotation), placing.place_on(picture(rotation), x, y)) == there


@pytest.mark.parametrize("rotation", TURNS)
@pytest.mark.parametrize("handle", CORNERS)
def test_a_dragged_handle_follows_and_what_is_opposite_stays(rotation: float, handle: str) -> None:
    before, (x, y) = picture(rotation), CORNERS[handle]
    to = placing.place_on(before, 2 * x - 0.5, 2 * y - 0.5)
    after = placing.stretched(before, (x, y), to, 0.1, free=True)
    np.testing.assert_allclose(placing.place_on(after, x, y), to)
    opposite = placing.place_on(before, 1 - x, 1 - y)
    np.testing.assert_allclose(placing.place_on(after, 1 - x, 1 - y), opposite, atol=1e-12)
    assert after.rotation == before.rotation


@pytest.mark.parametrize("rotation", TURNS)
def test_a_corner_keeps_the_proportions_however_far_it_is_dragged(rotation: float) -> None:
    before = picture(rotation)
    for to in ((9.0, 4.0), (-30.0, -20.0), placing.place_on(before, 0, 0)):
        after = placing.stretched(before, (1, 1), to, 0.1)
        assert after.size[0] == pytest.approx(2 * after.size[1])
        assert min(after.size) >= 0.1 - 1e-12
        np.testing.assert_allclose(placing.place_on(after, 0, 0), placing.place_on(before, 0, 0), atol=1e-12)


def test_turns_add_up_and_stay_within_half_a_turn() -> None:
    turned = picture(3.0)
    for _ in range(10):
        turned = placing.turned(turned, 1.0)
    assert abs(turned.rotation) <= pi
    assert remainder(turned.rotation - 13.0, tau) == pytest.approx(0, abs=1e-12)
    assert turned.middle == (3.0, 1.0)
