"""Keeper: keeps what is unsaved, a few seconds after each change, beside the window.

One thread does all that touches the disk, one thing after another: so nothing waits for a slow disk, and a
record that is done away with is not written again by what was under way.
"""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from functools import partial

from PySide6.QtCore import QObject, QTimer, Signal, Slot

from app.model.filing import project_of
from app.recovery.places import Place
from app.recovery.record import Record, write_record
from app.session import Session
from starskel.errors import StarskelError

DELAY = 2000
"""Milliseconds from a change to the writing of it, and from a failure to the next try."""

PATIENCE = 5.0
"""Seconds that a program about to crash waits for the disk."""


class Keeper(QObject):
    """Writes a record of the session's document while that is unsaved, and clears it when it is saved."""

    failed = Signal(object)
    """The error for which the document could not be kept; None when that is over."""
    _missed = Signal()

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._place: Place | None = None
        self._error: StarskelError | None = None
        self._written: object = None
        self._closed = False
        self._disk = ThreadPoolExecutor(1, "recovery")
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(DELAY)
        self._timer.timeout.connect(self._write)
        self._missed.connect(self._retry)
        session.document_changed.connect(self._follow)

    def keep_now(self) -> bool:
        """Keep the document at once, whatever happens next; True where there is nothing to lose any more."""
        if not self._session.unsaved or (self._session.document is self._written and self._error is None):
            return True
        try:
            self._write().result(PATIENCE)
        except (TimeoutError, RuntimeError):
            return False
        return self._error is None

    def adopt(self, place: Place) -> None:
        """Go on with a record that was found; it is that of the document from now on."""
        self._do(self._clear)
        self._do(partial(self._take, place))

    def close(self) -> None:
        """Clear the record and end; to be called when the document is saved or given up."""
        if self._closed:
            return
        self._closed = True
        self._session.document_changed.disconnect(self._follow)
        self._timer.stop()
        self._do(self._clear)
        self._disk.shutdown()

    @Slot()
    def _follow(self) -> None:
        if not self._session.unsaved:
            self._timer.stop()
            self._do(self._clear)
        elif self._session.document is not self._written and not self._timer.isActive():
            self._timer.start()

    @Slot()
    def _retry(self) -> None:
        """Try again soon, though nothing has changed: there may be room on the disk by then."""
        if self._session.unsaved and not self._closed:
            self._timer.start()

    @Slot()
    def _write(self) -> "Future[None]":
        session = self._session
        self._written = session.document
        record = Record(project_of(session.document, ""), session.file)
        return self._do(partial(self._put, record))

    def _do(self, job: Callable[[], None]) -> "Future[None]":
        return self._disk.submit(job)

    # in the thread of the disk

    def _put(self, record: Record) -> None:
        former = self._error
        try:
            if self._place is None or not self._place.held:
                self._place = Place.new()
            write_record(self._place.path, record)
            self._error = None
        except StarskelError as error:
            self._error = error
            self._missed.emit()
        if str(self._error) != str(former):
            self.failed.emit(self._error)

    def _take(self, place: Place) -> None:
        self._place = place

    def _clear(self) -> None:
        if self._place is not None:
            self._place.clear()
            self._place = None
