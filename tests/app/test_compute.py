"""The worker, with blends that take as long as the test wants."""

import threading
from collections.abc import Iterator

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app import compute
from app.compute import AT_ONCE, Computer, Failure, Request, Result, Watched
from starskel import Cancelled, InvalidPolygon, Polygon, blend, measure

SQUARE = Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])
REQUEST = Request(SQUARE, SQUARE, (), ("vertex", "edge-angle"))


class Collector:
    def __init__(self, computer: Computer) -> None:
        self.outcomes: list[Result | Failure] = []
        self.progress: list[float] = []
        computer.delivered.connect(self._take)
        computer.progressed.connect(self._advance)

    def _take(self, request: Request, outcome: Result | Failure) -> None:
        self.outcomes.append(outcome)

    def _advance(self, method: str, fraction: float) -> None:
        self.progress.append(fraction)


@pytest.fixture
def computer(qapp) -> Iterator[Computer]:  # type: ignore[no-untyped-def]
    computer = Computer()
    yield computer
    computer.close()


@pytest.fixture
def slow(monkeypatch: pytest.MonkeyPatch) -> dict[str, threading.Event]:
    """Make every blend wait until it is let go or told to stop."""
    events = {"begun": threading.Event(), "go": threading.Event(), "stopped": threading.Event()}

    def slow_blend(pair, *, method, decomposition, progress, should_stop):  # type: ignore[no-untyped-def]
        events["begun"].set()
        for _ in range(1000):
            if should_stop():
                events["stopped"].set()
                raise Cancelled
            if events["go"].wait(0.005):
                return blend(pair, method=method)
        raise AssertionError("neither let go nor told to stop")

    monkeypatch.setattr(compute, "blend", slow_blend)
    return events


def test_every_method_is_delivered_as_soon_as_it_is_there(computer: Computer, qtbot: QtBot) -> None:
    seen = Collector(computer)
    computer.request(REQUEST)
    assert computer.busy
    qtbot.waitUntil(lambda: not computer.busy)
    assert [outcome.method for outcome in seen.outcomes] == ["vertex", "edge-angle"]
    assert all(isinstance(outcome, Result) for outcome in seen.outcomes)
    assert seen.progress == sorted(seen.progress)


def test_the_newest_request_wins(computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event]) -> None:
    seen = Collector(computer)
    computer.request(Request(SQUARE, SQUARE, (), ("edge-angle",)))
    assert slow["begun"].wait(5)
    for _ in range(20):
        computer.request(Request(SQUARE, SQUARE, (), ("edge-angle",)))
    computer.request(Request(SQUARE, SQUARE, ((0, 1),), ("vertex",)))
    assert slow["stopped"].wait(5)
    slow["go"].set()
    qtbot.waitUntil(lambda: not computer.busy)
    (outcome,) = seen.outcomes
    assert isinstance(outcome, Result)
    assert outcome.method == "vertex"
    assert outcome.blend.pair.marks == ((0, 1),)


def test_what_an_old_request_still_delivers_is_dropped(
    computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event]
) -> None:
    """The old result is finished and under way to the window when the new request comes."""
    seen = Collector(computer)
    slow["go"].set()
    computer.request(Request(SQUARE, SQUARE, (), ("edge-angle",)))
    assert slow["begun"].wait(5)
    computer.request(Request(SQUARE, SQUARE, (), ("vertex",)))
    qtbot.waitUntil(lambda: not computer.busy)
    assert [outcome.method for outcome in seen.outcomes] == ["vertex"]


def test_cancel_stops_the_worker_and_delivers_nothing(
    computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event]
) -> None:
    seen = Collector(computer)
    computer.request(REQUEST)
    assert slow["begun"].wait(5)
    computer.cancel()
    assert not computer.busy
    assert slow["stopped"].wait(5)
    qtbot.wait(20)
    assert seen.outcomes == []


def test_errors_come_back_as_values_and_the_next_method_still_runs(
    computer: Computer, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(pair, *, method, **rest):  # type: ignore[no-untyped-def]
        if method == "vertex":
            raise InvalidPolygon("something is wrong", "mend it")
        return blend(pair, method=method)

    monkeypatch.setattr(compute, "blend", failing)
    seen = Collector(computer)
    computer.request(REQUEST)
    qtbot.waitUntil(lambda: not computer.busy)
    first, second = seen.outcomes
    assert isinstance(first, Failure)
    assert isinstance(first.error, InvalidPolygon)
    assert isinstance(second, Result)


def test_a_fault_in_the_library_does_not_end_the_worker(
    computer: Computer, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def broken(pair, **rest):  # type: ignore[no-untyped-def]
        raise ZeroDivisionError

    monkeypatch.setattr(compute, "blend", broken)
    seen = Collector(computer)
    computer.request(REQUEST)
    qtbot.waitUntil(lambda: not computer.busy)
    assert all(isinstance(outcome, Failure) for outcome in seen.outcomes)
    assert "ZeroDivisionError" in capsys.readouterr().err
    monkeypatch.undo()
    computer.request(REQUEST)
    qtbot.waitUntil(lambda: len(seen.outcomes) == 4)
    assert isinstance(seen.outcomes[-1], Result)


def test_closing_stops_a_running_computation(
    qapp,
    slow: dict[str, threading.Event],  # type: ignore[no-untyped-def]
) -> None:
    computer = Computer()
    computer.request(REQUEST)
    assert slow["begun"].wait(5)
    computer.close()
    assert slow["stopped"].is_set()


def test_the_decomposition_is_computed_once_for_all_methods(computer: Computer, qtbot: QtBot) -> None:
    seen = Collector(computer)
    computer.request(Request(SQUARE, SQUARE, (), ("star-skeleton", "stitched")))
    qtbot.waitUntil(lambda: not computer.busy)
    first, second = (outcome.blend for outcome in seen.outcomes if isinstance(outcome, Result))
    assert first.decomposition is not None
    assert first.decomposition is second.decomposition


def test_a_newer_edit_stops_the_measuring_between_two_handfuls_of_frames() -> None:
    """Frames of large shapes take longer than the edit may have to wait."""
    angles = np.linspace(0, 2 * np.pi, AT_ONCE // 10, endpoint=False)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    whole = blend(circle, 2 * circle, marks=[(0, 0)], method="vertex")
    asked: list[None] = []

    def go_on() -> None:
        asked.append(None)
        if len(asked) == 4:
            raise Cancelled

    with pytest.raises(Cancelled):
        measure(Watched(whole, go_on))
    assert len(asked) == 4


def test_being_watched_changes_no_frame() -> None:
    whole = blend(SQUARE, SQUARE, marks=[(0, 2)], method="stitched")
    times = np.linspace(0, 1, 33)
    watched = Watched(whole, lambda: None)
    np.testing.assert_array_equal(watched.frames(times), whole.frames(times))
    assert measure(watched).area_deviation == measure(whole).area_deviation


def test_the_box_holds_all_frames(computer: Computer, qtbot: QtBot) -> None:
    seen = Collector(computer)
    computer.request(Request(SQUARE, Polygon([(20, 0), (24, 0), (24, 30)]), (), ("vertex",)))
    qtbot.waitUntil(lambda: not computer.busy)
    (outcome,) = seen.outcomes
    assert isinstance(outcome, Result)
    assert outcome.box.tolist() == [[0, 0], [24, 30]]
