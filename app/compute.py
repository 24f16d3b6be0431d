"""Blends computed beside the window: frozen requests, one worker thread, the newest batch of them wins.

The window sets the newest generation before it sends a batch, and the worker compares it whenever the
library asks whether to stop. So an old batch ends within the library's promise (100 ms), and whatever it
still delivers carries an old generation and is dropped.
"""

import traceback
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PySide6.QtCore import QObject, QThread, Signal, Slot

from app.model.marks import Marks
from starskel import Blend, Correspondence, Decomposition, Report, blend, match, measure
from starskel.errors import Cancelled, StarskelError
from starskel.polygon import Polygon
from starskel.predicates import Floats

AT_ONCE = 1 << 15
"""So many points of frames are computed between two questions whether to stop."""

SAMPLES = np.linspace(0, 1, 21)
"""The moments that count for the box of a blend."""


@dataclass(frozen=True)
class Request:
    """What is to be blended, and how.

    Attributes
    ----------
    source, target : Polygon
        The shapes.
    marks : tuple of (int, int)
        What corresponds.
    methods : tuple of str
        The methods, in the order in which they are wanted.
    """

    source: Polygon
    target: Polygon
    marks: Marks
    methods: tuple[str, ...]


@dataclass(frozen=True)
class Batch:
    """Requests to be worked off in order.

    Attributes
    ----------
    requests : tuple of Request
    generation : int
        Grows from batch to batch.
    """

    requests: tuple[Request, ...]
    generation: int

    @property
    def size(self) -> int:
        """How many blends it asks for."""
        return sum(len(request.methods) for request in self.requests)


@dataclass(frozen=True, eq=False)
class Result:
    """A blend and what was measured of it.

    Attributes
    ----------
    method : str
    blend : Blend
    report : Report
    box : (2, 2) array
        The lower left and the upper right corner of all frames.
    """

    method: str
    blend: Blend
    report: Report
    box: Floats


@dataclass(frozen=True, eq=False)
class Failure:
    """Why there is no blend by this method."""

    method: str
    error: Exception


@dataclass(frozen=True, eq=False)
class MethodState:
    """What there is to show of one method.

    Attributes
    ----------
    result : Result or None
        The last good one.
    error : Exception or None
        Why there is no newer one.
    stale : bool
        Whether the shapes have changed since.
    """

    result: Result | None = None
    error: Exception | None = None
    stale: bool = True

    @property
    def wanted(self) -> bool:
        """Whether it is worth computing: what failed would fail again."""
        return self.stale and self.error is None

    def outdated(self) -> "MethodState":
        """Mark it stale; the last good blend stays."""
        return replace(self, error=None, stale=True)

    def after(self, outcome: Result | Failure) -> "MethodState":
        """Take in what the worker delivered."""
        if isinstance(outcome, Result):
            return MethodState(outcome, stale=False)
        return replace(self, error=outcome.error)


class Worker(QObject):
    """Works off batches, in its own thread."""

    delivered = Signal(int, object, object)
    progressed = Signal(int, str, float)
    finished = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.newest = 0  # set by the window, read here: one int, so no lock

    @Slot(object)
    def work(self, batch: Batch) -> None:
        done = 0
        try:
            for request in batch.requests:
                job = Job(self, batch, request, done)
                for method in request.methods:
                    self.delivered.emit(batch.generation, request, job.outcome(method))
                done += len(request.methods)
        except Cancelled:
            return
        self.finished.emit(batch.generation)


class Job:
    """A request being worked off: what its methods share is computed once.

    `done` counts the blends of the batch that were ready before.
    """

    def __init__(self, worker: Worker, batch: Batch, request: Request, done: int) -> None:
        self._worker = worker
        self._batch = batch
        self._request = request
        self._done = done
        self._pair: Correspondence | None = None
        self._decomposition: Decomposition | None = None
        self._percent = -1

    def outcome(self, method: str) -> Result | Failure:
        """Blend by one method, and measure.

        Raises
        ------
        Cancelled
            If a newer request has come.
        """
        try:
            self._report(method, 0.0)
            made = self._blend(method)
            self._report(method, 1.0)
            watched = Watched(made, self._go_on)
            return Result(method, made, measure(watched), _box(watched))
        except Cancelled:
            raise
        except Exception as error:  # whatever it is, the window shows it; the thread lives on
            if not isinstance(error, StarskelError):
                traceback.print_exception(error)
            return Failure(method, error)

    def _blend(self, method: str) -> Blend:
        if self._pair is None:
            request = self._request
            self._pair = match(request.source, request.target, request.marks, should_stop=self._is_old)
        made = blend(
            self._pair,
            method=method,
            decomposition=self._decomposition,
            progress=partial(self._report, method),
            should_stop=self._is_old,
        )
        self._decomposition = made.decomposition or self._decomposition
        return made

    def _go_on(self) -> None:
        if self._is_old():
            raise Cancelled

    def _is_old(self) -> bool:
        return self._worker.newest != self._batch.generation

    def _report(self, method: str, fraction: float) -> None:
        """Report whole percents of the batch; the library may call far more often."""
        self._go_on()
        done = self._done + self._request.methods.index(method) + fraction
        percent = int(100 * done / self._batch.size)
        if percent != self._percent:
            self._percent = percent
            self._worker.progressed.emit(self._batch.generation, method, percent / 100)


class Watched(Blend):
    """A blend whose frames come a few at a time, so that whoever measures it can be stopped.

    `go_on` is called between them and raises where it should not go on.
    """

    def __init__(self, whole: Blend, go_on: Callable[[], None]) -> None:
        super().__init__(whole.pair)
        self._whole = whole
        self._go_on = go_on

    def negative_lengths(self, ts: ArrayLike) -> NDArray[np.bool_]:
        return self._whole.negative_lengths(ts)

    def _frames(self, ts: Floats) -> Floats:
        step = max(1, AT_ONCE // len(self.pair))
        return np.concatenate([self._some(ts[k : k + step]) for k in range(0, len(ts), step)])

    def _some(self, ts: Floats) -> Floats:
        self._go_on()
        return self._whole.frames(ts)


def _box(blended: Blend) -> Floats:
    points = blended.frames(SAMPLES).reshape(-1, 2)
    return np.array([points.min(axis=0), points.max(axis=0)])


class Computer(QObject):
    """The window's end of the worker: sends requests, passes on what still matters."""

    delivered = Signal(object, object)
    """A request, and a Result or a Failure of one of its methods."""
    progressed = Signal(str, float)
    busy_changed = Signal(bool)
    _requested = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.busy = False
        self._worker = Worker()
        self._thread = QThread(self)
        self._worker.moveToThread(self._thread)
        self._requested.connect(self._worker.work)
        self._worker.delivered.connect(self._deliver)
        self._worker.progressed.connect(self._progress)
        self._worker.finished.connect(self._finish)
        self._thread.start()

    def request(self, *requests: Request) -> None:
        """Compute these in order instead of whatever is being computed."""
        self._worker.newest += 1
        self._set_busy(True)
        self._requested.emit(Batch(requests, self._worker.newest))

    def cancel(self) -> None:
        """Stop computing; nothing more is delivered."""
        self._worker.newest += 1
        self._set_busy(False)

    def close(self) -> None:
        """Stop and end the thread; to be called before the program ends."""
        self.cancel()
        self._thread.quit()
        self._thread.wait()

    @Slot(int, object, object)
    def _deliver(self, generation: int, request: Request, outcome: Result | Failure) -> None:
        if generation == self._worker.newest:
            self.delivered.emit(request, outcome)

    @Slot(int, str, float)
    def _progress(self, generation: int, method: str, fraction: float) -> None:
        if generation == self._worker.newest:
            self.progressed.emit(method, fraction)

    @Slot(int)
    def _finish(self, generation: int) -> None:
        if generation == self._worker.newest:
            self._set_busy(False)

    def _set_busy(self, busy: bool) -> None:
        if busy != self.busy:
            self.busy = busy
            self.busy_changed.emit(busy)
