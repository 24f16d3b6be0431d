"""Calls of Qt that give nothing take no reference to None along, as some pairs of Python and PySide6 do."""

import sys
from collections.abc import Callable

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QObject, Signal, Slot
from PySide6.QtWidgets import QWidget

CALLS = 20_000
"""Four times as many as end the program where each loses a reference."""


class Listener(QObject):
    """Has a signal that it hears, and handles events."""

    told = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.told.connect(self.hear)

    def tell(self, number: int) -> None:
        self.told.emit(number)

    @Slot(int)
    def hear(self, number: int) -> None:
        pass

    def customEvent(self, event: QEvent) -> None:  # noqa: N802 -- as Qt calls it
        pass


def setting() -> Callable[[int], object]:
    widget = QWidget()
    return lambda number: widget.setMinimumWidth(number % 100)


def emitting() -> Callable[[int], object]:
    return Listener().tell


def handling() -> Callable[[int], object]:
    listener = Listener()
    return lambda number: QCoreApplication.sendEvent(listener, QEvent(QEvent.Type.User))


@pytest.mark.parametrize("begin", [setting, emitting, handling])
def test_calls_that_give_nothing_keep_all_references_to_none(
    qapp: QCoreApplication, begin: Callable[[], Callable[[int], object]]
) -> None:
    call = begin()
    before = sys.getrefcount(None)
    for number in range(CALLS):
        call(number)
    assert sys.getrefcount(None) > before - CALLS // 100
