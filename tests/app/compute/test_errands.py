"""Errands, with work that takes as long as the test wants."""

import threading
from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.compute.errands import Errands, Outcome
from starskel.errors import StarskelError
from starskel.task import Task


@pytest.fixture
def errands(qapp) -> Iterator[Errands]:  # type: ignore[no-untyped-def]
    errands = Errands()
    yield errands
    errands.close()


def collected(errands: Errands) -> list[Outcome]:
    found: list[Outcome] = []
    errands.done.connect(found.append)
    return found


def test_what_came_of_it_is_told_with_its_progress(errands: Errands, qtbot: QtBot) -> None:
    found, steps = collected(errands), []
    errands.progressed.connect(steps.append)

    def work(task: Task) -> str:
        task.reach(0.5)
        return threading.current_thread().name

    errands.do(work)
    assert errands.busy
    qtbot.waitUntil(lambda: len(found) == 1)
    assert found[0].value != threading.main_thread().name
    assert steps == [0.5]
    assert not errands.busy


def test_the_newest_stops_the_one_before(errands: Errands, qtbot: QtBot) -> None:
    found, begun, stopped = collected(errands), threading.Event(), threading.Event()

    def endless(task: Task) -> None:
        begun.set()
        try:
            while True:
                task.reach(0)
        finally:
            stopped.set()

    errands.do(endless)
    assert begun.wait(5)
    errands.do(lambda task: "second")
    qtbot.waitUntil(lambda: bool(found))
    assert stopped.is_set()
    assert [outcome.value for outcome in found] == ["second"]


def test_errors_come_back_as_values(errands: Errands, qtbot: QtBot, caplog) -> None:  # type: ignore[no-untyped-def]
    found = collected(errands)
    for error in (StarskelError("no", "do"), ZeroDivisionError("what nobody foresaw")):

        def fail(task: Task, error: Exception = error) -> None:
            raise error

        errands.do(fail)
        qtbot.waitUntil(lambda: not errands.busy)
    assert [str(outcome.error) for outcome in found] == ["no; do", "what nobody foresaw"]
    assert "ZeroDivisionError" in caplog.text  # for whoever is to mend it


def test_cancelled_nothing_comes_of_it(errands: Errands, qtbot: QtBot) -> None:
    found, begun, go = collected(errands), threading.Event(), threading.Event()

    def wait(task: Task) -> str:
        begun.set()
        go.wait(5)
        return "late"

    errands.do(wait)
    assert begun.wait(5)
    errands.cancel()
    go.set()
    qtbot.wait(50)
    assert found == []
