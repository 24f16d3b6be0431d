"""The worker thread and the window's end of it.

The window sets the newest generation before it sends a request, and the worker compares it whenever the
library asks whether to stop. So an old request ends within the library's promise (100 ms), and whatever it
still delivers carries an old generation and is dropped.

Requests of a gesture under way come faster than they can be worked off. If each ended the one before, none
would ever be finished; so the newest of them waits until the one being worked off gives way.
"""

from dataclasses import replace
from importlib import import_module
from time import monotonic
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

import starskel
from app.compute.request import Failure, Proposal, Request, Result
from app.compute.threads import thread_named
from app.model.marks import Marks
from starskel.errors import Cancelled, StarskelError, told

if TYPE_CHECKING:
    from app.compute.job import BlendJob

_FAULT = StarskelError(
    told("a fault in the program ended the computation"), told("change the shapes a little, or press F5")
)

PATIENCE = 0.05
"""Seconds after which a request of a gesture gives way to a newer one, as soon as a method is done."""


def _job_class() -> "type[BlendJob]":
    """Give the class that computes; it is loaded in the worker's thread, so that the window opens sooner."""
    chosen: type[BlendJob] = import_module("app.compute.job").BlendJob
    return chosen


class Worker(QObject):
    """Works off requests, in its own thread."""

    delivered = Signal(int, object)
    progressed = Signal(int, str, float)
    finished = Signal(int, object)
    """A generation, and the methods that gave way to a newer request."""
    suggested = Signal(object, object)
    died = Signal(int)
    """A generation whose work ended by a fault; what comes after it would find a worker in pieces."""

    def __init__(self, newest: int = 0) -> None:
        super().__init__()
        # both are set by the window and read here, and are single values: no lock
        self.newest = newest
        self.hurried = False

    @Slot(object)
    def work(self, request: Request) -> None:
        try:
            self._work(request)
        except BaseException:
            self.died.emit(request.generation)
            raise

    def _work(self, request: Request) -> None:
        begun = monotonic()

        def is_old() -> bool:
            return self.newest != request.generation

        def report(method: str, fraction: float) -> None:
            self.progressed.emit(request.generation, method, fraction)

        job = _job_class()(request, is_old, report)
        left = list(request.methods)
        try:
            while left and not (self.hurried and monotonic() - begun > PATIENCE):
                self.delivered.emit(request.generation, job.outcome(left.pop(0)))
            for outcome in () if request.live else job.improvements():
                self.delivered.emit(request.generation, outcome)
        except Cancelled:
            return
        self.finished.emit(request.generation, tuple(left))

    @Slot(object)
    def suggest(self, proposal: Proposal) -> None:
        def is_old() -> bool:
            return self.newest != proposal.generation

        try:
            marks = starskel.suggest_marks(
                proposal.source, proposal.target, proposal.count, should_stop=is_old
            )
        except Cancelled:
            return
        except BaseException:
            self.died.emit(proposal.generation)
            raise
        self.suggested.emit(proposal, tuple(marks))


class Computer(QObject):
    """The window's end of the worker: sends requests, passes on what still matters."""

    delivered = Signal(object, object)
    """What was blended, and the Result or Failure of one method."""
    progressed = Signal(str, float)
    busy_changed = Signal(bool)
    suggested = Signal(object, object)
    """A Proposal and the marks."""
    restarted = Signal()
    """The worker died, and another one goes on in its place."""
    _requested = Signal(object)
    _proposed = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.busy = False
        self._running: Request | None = None
        self._waiting: Request | None = None
        self._later: list[Request] = []
        self._missing: set[str] = set()  # methods of the request being worked off that have given nothing yet
        self._begin(Worker())

    @property
    def behind(self) -> bool:
        """Whether what is being computed has been overtaken by a newer request, which waits."""
        return self._waiting is not None

    def request(self, request: Request, *later: Request) -> None:
        """Compute this instead of what is being computed; that of a gesture may first finish its method.

        What is wanted later is computed in order when there is nothing else to do.
        """
        self._later = list(later)
        if request.live and self._running is not None and self._running.live:
            self._waiting = request
            self._worker.hurried = True
        else:
            self._send(request)

    def suggest(self, proposal: Proposal) -> None:
        """Suggest marks instead of computing blends."""
        self.cancel()
        self._set_busy(True)
        self._proposed.emit(replace(proposal, generation=self._worker.newest))

    def cancel(self) -> None:
        """Stop computing; nothing more is delivered."""
        self._worker.newest += 1
        self._rest()

    def close(self) -> None:
        """Stop and end the thread; to be called before the program ends."""
        self.cancel()
        self._end()

    def _begin(self, worker: Worker) -> None:
        self._worker = worker
        self._thread = thread_named("blends", self)
        self._worker.moveToThread(self._thread)
        self._requested.connect(self._worker.work)
        self._proposed.connect(self._worker.suggest)
        self._worker.suggested.connect(self._suggest)
        self._worker.delivered.connect(self._deliver)
        self._worker.progressed.connect(self._progress)
        self._worker.finished.connect(self._finish)
        self._worker.died.connect(self._restart)
        self._thread.finished.connect(self._revive)
        self._thread.start()

    def _end(self) -> None:
        self._thread.finished.disconnect(self._revive)
        self._thread.quit()
        self._thread.wait()

    @Slot()
    def _revive(self) -> None:
        """Go on after the thread has ended, though nobody had told it to."""
        self._restart(-1)

    @Slot(int)
    def _restart(self, generation: int) -> None:
        """Put a new worker in the place of one that died, and have it work on; what killed it fails."""
        wanted = [request for request in (self._running, self._waiting) if request is not None] + self._later
        at_fault = wanted.pop(0) if wanted and generation == self._worker.newest else None
        missing = [method for method in at_fault.methods if method in self._missing] if at_fault else []
        self._end()
        self._thread.deleteLater()
        self._requested.disconnect()
        self._proposed.disconnect()
        self._begin(Worker(self._worker.newest + 1))
        self._rest()
        self.restarted.emit()
        if at_fault is not None:
            for method in missing:
                self.delivered.emit(at_fault.subject, Failure(method, _FAULT))
        if wanted:
            self.request(*wanted)

    def _send(self, request: Request) -> None:
        self._worker.newest += 1
        self._worker.hurried = False
        self._running, self._waiting = replace(request, generation=self._worker.newest), None
        self._missing = set(request.methods)
        self._set_busy(True)
        self._requested.emit(self._running)

    def _rest(self) -> None:
        self._running = self._waiting = None
        self._later = []
        self._set_busy(False)

    @Slot(int, object)
    def _deliver(self, generation: int, outcome: Result | Failure) -> None:
        if generation == self._worker.newest and self._running is not None:
            self._missing.discard(outcome.method)
            self.delivered.emit(self._running.subject, outcome)

    @Slot(object, object)
    def _suggest(self, proposal: Proposal, marks: Marks) -> None:
        if proposal.generation == self._worker.newest:
            self._rest()
            self.suggested.emit(proposal, marks)

    @Slot(int, str, float)
    def _progress(self, generation: int, method: str, fraction: float) -> None:
        if generation == self._worker.newest:
            self.progressed.emit(method, fraction)

    @Slot(int, object)
    def _finish(self, generation: int, left: tuple[str, ...]) -> None:
        """Go on with the request that waits; the methods that gave way to it are first in turn."""
        if generation != self._worker.newest:
            return
        if self._waiting is None and self._later:
            following, *self._later = self._later
            self._send(following)
        elif self._waiting is None:
            self._rest()
        else:
            others = tuple(method for method in self._waiting.methods if method not in left)
            kept = tuple(method for method in left if method in self._waiting.methods)
            self._send(replace(self._waiting, methods=kept + others))

    def _set_busy(self, busy: bool) -> None:
        if busy != self.busy:
            self.busy = busy
            self.busy_changed.emit(busy)
