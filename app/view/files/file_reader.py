"""File reader: reads files beside the window, one at a time; the newest takes the place of the others."""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot

from app.compute.errands import Errands, Outcome, Work
from starskel.errors import StarskelError

Take = Callable[[Any], None]
"""What is to become of what was read."""

Refuse = Callable[[StarskelError], None]
"""What is to be done where it cannot be read."""


class FileReader(QObject):
    """Reads one file after another for whoever asks, and says how far it is."""

    begun = Signal(str)
    """The name of the file that is being read."""
    progressed = Signal(float)
    ended = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._take: Take = _drop
        self._refuse: Refuse = _drop
        self._errands = Errands(self)
        self._errands.done.connect(self._finish)
        self._errands.progressed.connect(self.progressed)

    @property
    def busy(self) -> bool:
        """Whether a file is being read."""
        return self._errands.busy

    def read(self, name: str, work: Work, take: Take, refuse: Refuse) -> None:
        """Read a file instead of the one that is being read.

        Parameters
        ----------
        name : str
            What the file is called.
        work : callable
            Reads it, in the thread of the reader; it gets a `Task`.
        take, refuse : callable
            Called in the thread of the window with what was read, or with the error.
        """
        self._take, self._refuse = take, refuse
        self.begun.emit(name)
        self._errands.do(work)

    @Slot()
    def cancel(self) -> None:
        """Give up what is being read; nothing comes of it."""
        if self.busy:
            self._errands.cancel()
            self.ended.emit()

    def close(self) -> None:
        """End the thread; to be called before the program ends."""
        self._errands.close()

    @Slot(object)
    def _finish(self, outcome: Outcome) -> None:
        self.ended.emit()
        if isinstance(outcome.error, StarskelError):
            self._refuse(outcome.error)
        elif outcome.error is not None:
            raise outcome.error
        else:
            self._take(outcome.value)


def _drop(_: object) -> None:
    """Do nothing, before anything has been asked for."""
