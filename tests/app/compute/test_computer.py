"""The worker, with blends that take as long as the test wants."""

import threading
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.compute import Computer, Failure, Request, Result, Subject, job
from app.compute.request import Proposal
from starskel import Cancelled, InvalidPolygon, Polygon, blend
from tests.app.compute.subjects import subject
from tests.families import two_opt

SQUARE = Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])
REQUEST = Request(subject(SQUARE, SQUARE), ("vertex", "edge-angle"))


class Collector:
    def __init__(self, computer: Computer) -> None:
        self.outcomes: list[Result | Failure] = []
        self.progress: list[float] = []
        computer.delivered.connect(self._take)
        computer.progressed.connect(self._advance)

    def _take(self, subject: Subject, outcome: Result | Failure) -> None:
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

    def slow_blend(pair, *, method, should_stop, **rest):  # type: ignore[no-untyped-def]
        events["begun"].set()
        for _ in range(1000):
            if should_stop():
                events["stopped"].set()
                raise Cancelled
            if events["go"].wait(0.005):
                return blend(pair, method=method)
        raise AssertionError("neither let go nor told to stop")

    monkeypatch.setattr(job, "blend", slow_blend)
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
    computer.request(Request(subject(SQUARE, SQUARE), ("edge-angle",)))
    assert slow["begun"].wait(5)
    for _ in range(20):
        computer.request(Request(subject(SQUARE, SQUARE), ("edge-angle",)))
    computer.request(Request(subject(SQUARE, SQUARE, ((0, 1),)), ("vertex",)))
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
    computer.request(Request(subject(SQUARE, SQUARE), ("edge-angle",)))
    assert slow["begun"].wait(5)
    computer.request(Request(subject(SQUARE, SQUARE), ("vertex",)))
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

    monkeypatch.setattr(job, "blend", failing)
    seen = Collector(computer)
    computer.request(REQUEST)
    qtbot.waitUntil(lambda: not computer.busy)
    first, second = seen.outcomes
    assert isinstance(first, Failure)
    assert isinstance(first.error, InvalidPolygon)
    assert isinstance(second, Result)


def test_a_fault_in_the_library_does_not_end_the_worker(
    computer: Computer, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def broken(pair, **rest):  # type: ignore[no-untyped-def]
        raise ZeroDivisionError

    monkeypatch.setattr(job, "blend", broken)
    seen = Collector(computer)
    computer.request(REQUEST)
    qtbot.waitUntil(lambda: not computer.busy)
    assert all(isinstance(outcome, Failure) for outcome in seen.outcomes)
    assert "ZeroDivisionError" in caplog.text
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
    computer.request(Request(subject(SQUARE, SQUARE), ("star-skeleton", "stitched")))
    qtbot.waitUntil(lambda: not computer.busy)
    first, second, _ = (outcome.blend for outcome in seen.outcomes if isinstance(outcome, Result))
    assert first.decomposition is not None
    assert first.decomposition is second.decomposition


def test_the_box_holds_all_frames(computer: Computer, qtbot: QtBot) -> None:
    seen = Collector(computer)
    computer.request(Request(subject(SQUARE, Polygon([(20, 0), (24, 0), (24, 30)])), ("vertex",)))
    qtbot.waitUntil(lambda: not computer.busy)
    (outcome,) = seen.outcomes
    assert isinstance(outcome, Result)
    assert outcome.box.tolist() == [[0, 0], [24, 30]]


def live(x: float, *methods: str) -> Request:
    """A moment of a gesture that drags a corner."""
    return Request(subject(SQUARE, Polygon([(0, 0), (10, 0), (10, x), (0, 10)])), methods, live=True)


def test_a_gesture_does_not_end_its_own_requests_and_only_the_newest_waits(
    computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event]
) -> None:
    seen = Collector(computer)
    for x in (11, 12, 13, 14):
        computer.request(live(x, "edge-angle"))
    assert computer.behind
    slow["go"].set()
    qtbot.waitUntil(lambda: not computer.busy)
    corners = [outcome.blend.pair.target[2, 1] for outcome in seen.outcomes if isinstance(outcome, Result)]
    assert corners == [11, 14]
    assert not slow["stopped"].is_set()


def test_methods_that_gave_way_come_first_the_next_time(
    computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.compute.computer.PATIENCE", 0.0)
    seen = Collector(computer)
    computer.request(live(11, "vertex", "edge-angle"))
    assert slow["begun"].wait(5)
    computer.request(live(12, "vertex", "edge-angle"))
    slow["go"].set()
    qtbot.waitUntil(lambda: not computer.busy)
    assert [outcome.method for outcome in seen.outcomes] == ["vertex", "edge-angle", "vertex"]


def test_the_end_of_a_gesture_does_not_wait(
    computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event]
) -> None:
    seen = Collector(computer)
    for x in (11, 12):
        computer.request(live(x, "edge-angle"))
    assert slow["begun"].wait(5)
    computer.request(Request(subject(SQUARE, SQUARE), ("vertex",)))
    assert slow["stopped"].wait(5)
    slow["go"].set()
    qtbot.waitUntil(lambda: not computer.busy)
    assert [outcome.method for outcome in seen.outcomes] == ["vertex"]


def test_what_is_wanted_later_is_computed_when_there_is_nothing_else_to_do(
    computer: Computer, qtbot: QtBot
) -> None:
    later = Request(subject(SQUARE, SQUARE, ((0, 1),)), ("vertex",))
    subjects: list[Subject] = []
    computer.delivered.connect(lambda subject, outcome: subjects.append(subject))
    computer.request(REQUEST, later)
    qtbot.waitUntil(lambda: not computer.busy)
    assert subjects == [REQUEST.subject, REQUEST.subject, later.subject]


def test_a_new_request_takes_the_place_of_what_was_wanted_later(
    computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event]
) -> None:
    seen = Collector(computer)
    computer.request(REQUEST, REQUEST, REQUEST)
    assert slow["begun"].wait(5)
    computer.request(Request(subject(SQUARE, SQUARE), ("vertex",)))
    slow["go"].set()
    qtbot.waitUntil(lambda: not computer.busy)
    assert [outcome.method for outcome in seen.outcomes] == ["vertex"]


def crossing() -> Subject:
    """Shapes whose first blend crosses itself, and which settle soon."""
    return subject(Polygon(two_opt(12, 0)), Polygon(two_opt(12, 1000)), tuple((k, k) for k in range(12)))


def test_the_first_blend_is_shown_at_once_and_better_ones_follow(computer: Computer, qtbot: QtBot) -> None:
    seen = Collector(computer)
    computer.request(Request(crossing(), ("vertex", "stitched", "edge-angle")))
    qtbot.waitUntil(lambda: not computer.busy, timeout=20_000)
    results = [outcome for outcome in seen.outcomes if isinstance(outcome, Result)]
    methods = [result.method for result in results]
    assert methods[:3] == ["vertex", "stitched", "edge-angle"]
    assert len(methods) > 4
    assert set(methods[3:]) == {"stitched"}
    stitched = [results[1], *results[3:]]
    assert [result.settled for result in stitched] == [False] * (len(stitched) - 1) + [True]
    assert not stitched[0].report.simple
    assert stitched[-1].report.simple
    assert seen.progress == sorted(seen.progress)


def test_a_gesture_under_way_shows_the_first_blend_only(computer: Computer, qtbot: QtBot) -> None:
    seen = Collector(computer)
    computer.request(Request(crossing(), ("stitched",), live=True))
    qtbot.waitUntil(lambda: not computer.busy)
    (outcome,) = seen.outcomes
    assert isinstance(outcome, Result)
    assert not outcome.settled


def test_a_fault_in_the_worker_puts_another_in_its_place_and_fails_what_killed_it(
    computer: Computer, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What a job does not catch itself: here the job cannot even be made."""

    def broken(*_: object) -> None:
        raise ZeroDivisionError("in the worker")

    monkeypatch.setattr("app.compute.computer._job_class", lambda: broken)
    seen = Collector(computer)
    with qtbot.captureExceptions() as faults, qtbot.waitSignal(computer.restarted):
        computer.request(REQUEST)
    qtbot.waitUntil(lambda: len(faults) == 1)
    assert not computer.busy
    assert [outcome.method for outcome in seen.outcomes] == list(REQUEST.methods)
    assert all(isinstance(outcome, Failure) for outcome in seen.outcomes)
    monkeypatch.undo()
    computer.request(REQUEST)
    qtbot.waitUntil(lambda: not computer.busy)
    assert all(isinstance(outcome, Result) for outcome in seen.outcomes[2:])
    assert len(seen.outcomes) == 4


def test_a_fault_of_an_old_request_does_not_take_the_newest_along(
    computer: Computer, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[object] = []
    real_job = job.BlendJob

    def first_broken(*given: object) -> object:
        made.append(given)
        if len(made) == 1:
            computer.request(REQUEST)  # from the worker's thread, only so that it surely comes in between
            raise ZeroDivisionError("in the worker")
        return real_job(*given)  # type: ignore[arg-type]

    monkeypatch.setattr("app.compute.computer._job_class", lambda: first_broken)
    seen = Collector(computer)
    with qtbot.captureExceptions(), qtbot.waitSignal(computer.restarted):
        computer.request(REQUEST)
    qtbot.waitUntil(lambda: not computer.busy)
    assert [type(outcome) for outcome in seen.outcomes] == [Result, Result]


def test_a_thread_that_ends_is_begun_anew_and_its_request_done(
    computer: Computer, qtbot: QtBot, slow: dict[str, threading.Event]
) -> None:
    seen = Collector(computer)
    computer.request(REQUEST)
    assert slow["begun"].wait(5)
    computer._thread.quit()
    slow["go"].set()
    with qtbot.waitSignal(computer.restarted):
        pass
    qtbot.waitUntil(lambda: not computer.busy)
    assert {type(outcome) for outcome in seen.outcomes} == {Result}
    assert {outcome.method for outcome in seen.outcomes} == set(REQUEST.methods)


def test_a_fault_while_marks_are_suggested_leaves_nothing_busy(
    computer: Computer, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object, **__: object) -> None:
        raise ZeroDivisionError("in the worker")

    monkeypatch.setattr("starskel.suggest_marks", broken)
    with qtbot.captureExceptions(), qtbot.waitSignal(computer.restarted):
        computer.suggest(Proposal(SQUARE, SQUARE, 3))
    assert not computer.busy
