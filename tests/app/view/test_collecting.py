"""Where cycles are found: in the window's thread, whatever other threads do."""

import gc
import math
import threading
import weakref
from collections.abc import Callable

import pytest
from PySide6.QtWidgets import QDialog, QLabel, QVBoxLayout
from pytestqt.qtbot import QtBot

from app.view.collecting import collect_where_due, collecting_here


@pytest.fixture(autouse=True)
def as_python_does(garbage_left_to_this_thread: None) -> None:
    """Begin as the program does, where any thread collects."""
    gc.enable()


class Cycle:
    """A thing that holds itself."""

    def __init__(self) -> None:
        self.itself = self


class Forgotten(QDialog):
    """A dialog that was closed and is part of a cycle, as one with a method as a callback is."""

    def __init__(self) -> None:
        super().__init__()
        self.again = self.exec
        QVBoxLayout(self).addWidget(QLabel("a field"))


def in_another_thread(act: Callable[[], object]) -> None:
    thread = threading.Thread(target=act)
    thread.start()
    thread.join()


def leave_garbage(count: int = 20_000) -> None:
    for _ in range(count):
        Cycle()


def test_a_forgotten_dialog_is_destroyed_in_the_thread_of_the_window(qapp, qtbot: QtBot) -> None:  # type: ignore[no-untyped-def]
    destroyed: list[int] = []
    with collecting_here():
        dialog = Forgotten()
        weakref.finalize(dialog, lambda: destroyed.append(threading.get_ident()))
        del dialog
        in_another_thread(leave_garbage)
        assert not destroyed
        for _ in range(2):  # it is in an older generation by now
            qtbot.waitUntil(lambda: gc.get_count()[0] < gc.get_threshold()[0])
            in_another_thread(leave_garbage)
        gc.collect()
    assert destroyed == [threading.get_ident()]


def test_what_a_thread_leaves_is_collected_while_it_works_on(qapp, qtbot: QtBot) -> None:  # type: ignore[no-untyped-def]
    collected = threading.Event()
    ended = threading.Event()

    def work() -> None:
        weakref.finalize(Cycle(), collected.set)
        while not collected.is_set() and not ended.is_set():
            leave_garbage(100)

    with collecting_here():
        thread = threading.Thread(target=work)
        thread.start()
        qtbot.waitUntil(collected.is_set)
        ended.set()
        thread.join()


@pytest.mark.parametrize("generation", [0, 1, 2])
def test_old_garbage_is_collected_as_seldom_as_python_does(generation: int) -> None:
    """It is collected after some ten younger collections each; until then it costs nothing."""
    gone: list[bool] = []
    gc.disable()
    try:
        gc.collect()
        cycle = Cycle()
        weakref.finalize(cycle, gone.append, True)
        for younger in range(generation):
            gc.collect(younger)
        del cycle
        rounds = 0
        while not gone:
            leave_garbage(gc.get_threshold()[0] + 1)
            collect_where_due()
            rounds += 1
    finally:
        gc.enable()
    due = gc.get_threshold()[1 : generation + 1]
    assert math.prod(due) <= rounds <= math.prod(each + 3 for each in due)


def test_afterwards_python_collects_as_usual(qapp) -> None:  # type: ignore[no-untyped-def]
    with collecting_here():
        assert not gc.isenabled()
    assert gc.isenabled()
    assert not gc.get_freeze_count()
