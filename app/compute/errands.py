"""Errands: work of any kind done beside the window, one at a time; the newest takes the place of the others.

What is asked for is a callable that gets a `Task`: it reports how far it is, and asks whether to stop. It
runs in a thread of its own, so it holds frozen values and nothing that the window may change.
"""

import logging
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot

from app.compute.threads import thread_named
from starskel.errors import Cancelled, StarskelError
from starskel.task import Task

Work = Callable[[Task], Any]


@dataclass(frozen=True, eq=False)
class Outcome:
    """What came of an errand.

    Attributes
    ----------
    value : object
        What the work gave, None where it failed.
    error : Exception or None
        Why it failed.
    """

    value: Any = None
    error: Exception | None = None


class _Runner(QObject):
    """Runs errands, in its own thread."""

    done = Signal(int, object)
    progressed = Signal(int, float)

    def __init__(self) -> None:
        super().__init__()
        self.newest = 0
        """Set by the window and read here, a single value: no lock."""

    @Slot(int, object)
    def run(self, number: int, work: Work) -> None:
        if number != self.newest:
            return
        try:
            task = Task(
                lambda fraction: self.progressed.emit(number, fraction), lambda: self.newest != number
            )
            outcome = Outcome(work(task))
        except Cancelled:
            return
        except Exception as error:  # whatever it is, the window shows it; the thread lives on
            if not isinstance(error, StarskelError):
                logging.getLogger(__name__).error("an errand", exc_info=error)
            outcome = Outcome(error=error)
        self.done.emit(number, outcome)


class Errands(QObject):
    """The window's end: sends errands, passes on what came of the newest."""

    done = Signal(object)
    """An `Outcome`."""
    progressed = Signal(float)
    _asked = Signal(int, object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.busy = False
        self._runner = _Runner()
        self._thread = thread_named("errands", self)
        self._runner.moveToThread(self._thread)
        self._asked.connect(self._runner.run)
        self._runner.done.connect(self._take)
        self._runner.progressed.connect(self._report)

    def do(self, work: Work) -> None:
        """Do this instead of what is being done; the thread starts with the first errand."""
        if not self._thread.isRunning():
            self._thread.start()
        self._runner.newest += 1
        self.busy = True
        self._asked.emit(self._runner.newest, work)

    def cancel(self) -> None:
        """Stop what is being done; nothing comes of it."""
        self._runner.newest += 1
        self.busy = False

    def close(self) -> None:
        """Stop and end the thread; to be called before the program ends."""
        self.cancel()
        self._thread.quit()
        self._thread.wait()

    @Slot(int, object)
    def _take(self, number: int, outcome: Outcome) -> None:
        if number == self._runner.newest:
            self.busy = False
            self.done.emit(outcome)

    @Slot(int, float)
    def _report(self, number: int, fraction: float) -> None:
        if number == self._runner.newest:
            self.progressed.emit(fraction)
