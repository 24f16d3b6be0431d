import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.model.easing import PRESETS
from starskel.easing import Easing

SHARES = [k / 20 for k in range(21)]

every_preset = pytest.mark.parametrize(
    "easing", [easing for _, easing in PRESETS], ids=[n for n, _ in PRESETS]
)


@every_preset
def test_t_runs_from_0_to_1_and_never_back(easing: Easing) -> None:
    ts = [easing.t(share) for share in SHARES]
    assert (ts[0], ts[-1]) == (0, 1)
    assert ts == sorted(ts)


@every_preset
def test_each_t_comes_at_its_time(easing: Easing) -> None:
    for t in SHARES:
        assert easing.t(easing.time(t)) == pytest.approx(t, abs=1e-9)


def test_even_means_exactly_even() -> None:
    assert all(Easing().t(share) == share for share in SHARES)


def test_easing_in_begins_slowly_and_easing_out_ends_slowly() -> None:
    presets = dict(PRESETS)
    assert presets["Ease in"].t(0.2) < 0.1
    assert presets["Ease out"].t(0.8) > 0.9
    assert presets["Ease in and out"].t(0.5) == pytest.approx(0.5)


def test_handles_stay_in_the_square() -> None:
    assert Easing((-1, 2), (0.5, 7)) == Easing((0, 1), (0.5, 1))


@given(st.tuples(*[st.floats(0, 1)] * 4))
def test_the_way_back_of_the_way_back_is_the_same(handles: tuple[float, ...]) -> None:
    easing = Easing(handles[:2], handles[2:])
    assert easing.reversed.reversed == easing


@every_preset
def test_the_way_back_is_the_way_reversed(easing: Easing) -> None:
    for share in SHARES:
        assert easing.reversed.t(share) == pytest.approx(1 - easing.t(1 - share), abs=1e-9)


def test_points_lie_on_the_curve() -> None:
    easing = Easing((0.4, 0.0), (0.6, 1.0))
    points = easing.points(9)
    assert (points[0], points[-1]) == ((0, 0), (1, 1))
    assert all(easing.t(time) == pytest.approx(t, abs=1e-9) for time, t in points)
