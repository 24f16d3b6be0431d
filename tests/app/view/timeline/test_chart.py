import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.view.timeline.chart_layout import LANE, ChartLayout
from app.view.wording.verdicts import Span, crossing_spans, next_crossing
from starskel.files.projects.examples import example
from starskel.quality import Report
from starskel.quality.report import Crossing
from tests.app.driver import LEFT, PLAIN, Driver

NOWHERE = np.empty((0, 2))


def report(*frames: int, natural: tuple[int, ...] = (), between: tuple[float, ...] = ()) -> Report:
    times = np.linspace(0, 1, 101)
    crossings = [Crossing(k / 100, k, NOWHERE, k in natural) for k in frames]
    crossings += [Crossing(t, None, NOWHERE, False) for t in between]
    even = np.ones(101)
    return Report(times, tuple(crossings), True, even, even, even - 1, even - 1, 0.0, (), 0.0, None)


def test_crossing_frames_in_a_row_are_one_stretch() -> None:
    assert crossing_spans(report(3, 4, 5, 40)) == [Span(0.03, 0.05, False), Span(0.4, 0.4, False)]
    assert crossing_spans(report()) == []


def test_natural_crossings_are_stretches_of_their_own() -> None:
    spans = crossing_spans(report(3, 4, 5, 6, natural=(4, 5)))
    assert spans == [Span(0.03, 0.03, False), Span(0.04, 0.05, True), Span(0.06, 0.06, False)]


def test_a_crossing_between_frames_has_no_width() -> None:
    assert crossing_spans(report(between=(0.123,))) == [Span(0.123, 0.123, False)]


def test_the_next_crossing_is_that_of_any_blend_and_goes_round() -> None:
    reports = [report(10, 11, 50), report(30)]
    assert next_crossing(reports, 0.0) == 0.1
    assert next_crossing(reports, 0.1) == 0.3
    assert next_crossing(reports, 0.5) == 0.1
    assert next_crossing([report()], 0.5) is None


def test_the_parts_of_the_chart_lie_below_one_another() -> None:
    places = ChartLayout(400, ChartLayout.least_height(3), 8, 3)
    assert places.area.bottom() < places.lengths.top() < places.lengths.bottom() < places.lane(0).top()
    assert places.lane(2).bottom() <= places.height
    assert [places.lane_at(places.lane(k).center().y()) for k in range(3)] == [0, 1, 2]
    assert places.lane_at(places.lane(2).bottom() + LANE) is None
    assert places.t(places.x(0.3)) == pytest.approx(0.3)


@pytest.fixture
def arm(driver: Driver) -> Driver:
    driver.session.show_project(example("arm"))
    driver.wait_for_blends()
    return driver


def test_a_click_on_a_crossing_stops_there(arm: Driver) -> None:
    chart, player = arm.window.timeline.chart, arm.window.player
    number = arm.document.methods.index("vertex")
    result = arm.session.blends.results["vertex"].result
    assert result is not None
    span = crossing_spans(result.report)[0]
    player.play()
    beside = round(chart.places.x(span.start)) - 4
    QTest.mouseClick(chart, LEFT, PLAIN, QPoint(beside, round(chart.places.lane(number).center().y())))
    assert not player.playing
    assert player.t == pytest.approx(span.start)


def test_x_goes_from_crossing_to_crossing(arm: Driver) -> None:
    reports = [result.report for result in arm.session.blends.fresh]
    arm.key(Qt.Key.Key_X)
    first = arm.window.player.t
    assert first == next_crossing(reports, 0.0)
    arm.key(Qt.Key.Key_X)
    assert arm.window.player.t == next_crossing(reports, first)


def test_commas_and_points_step_through_the_frames(arm: Driver) -> None:
    for key, t in ((Qt.Key.Key_Period, 0.01), (Qt.Key.Key_Period, 0.02), (Qt.Key.Key_Comma, 0.01)):
        arm.key(key)
        assert arm.window.player.t == pytest.approx(t)
