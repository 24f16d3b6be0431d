"""The blends that are on the screen, and the memory of those that were."""

from PySide6.QtCore import QObject, Signal, Slot

from app.compute.computer import Computer
from app.compute.request import Failure, MethodState, Proposal, Request, Result, Subject
from starskel import METHODS

REMEMBERED = 40
"""So many results are kept, so that undo, and a gesture given up, need not compute anew."""


UNHURRIED = frozenset({"certified"})
"""Methods too slow to follow a gesture; they are computed when it ends."""


class Blends(QObject):
    """Keeps the results of the methods that are shown in step with what is blended.

    Attributes
    ----------
    results : dict of str to MethodState
        For each method what there is to show.
    """

    changed = Signal()
    progressed = Signal(str, float)
    busy_changed = Signal(bool)
    suggested = Signal(object)
    """Marks that were asked for."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.results: dict[str, MethodState] = {}
        self._subject: Subject | None = None
        self._memory: dict[tuple[str, Subject], Result] = {}
        self._computer = Computer(self)
        self._computer.delivered.connect(self._take)
        self._computer.suggested.connect(self.suggested)
        self._computer.progressed.connect(self.progressed)
        self._computer.busy_changed.connect(self.busy_changed)

    @property
    def busy(self) -> bool:
        """Whether the worker is computing."""
        return self._computer.busy

    @property
    def fresh(self) -> tuple[Result, ...]:
        """The blends of the shapes as they are now, in the order in which they are shown."""
        states = self.results.values()
        return tuple(state.result for state in states if state.result is not None and not state.stale)

    def show(self, subject: Subject | None, methods: tuple[str, ...], *, live: bool = False) -> None:
        """Have these methods blend this, or nothing; results that hold are kept, what is missing is computed.

        `live` says that a gesture is under way and more of the kind will follow.
        """
        former, same = self._subject, subject == self._subject
        if live and same:
            return
        self._subject = subject
        if subject is None:
            self._computer.cancel()
            self.results = {method: MethodState() for method in methods}
        else:
            self.results = {method: self._state(method, subject, former) for method in methods}
            if wanted := self._wanted(live):
                self._computer.request(Request(subject, wanted, live))
            elif not same:
                self._computer.cancel()
        self.changed.emit()

    def suggest(self, count: int) -> None:
        """Ask for so many marks of what is blended."""
        if self._subject is not None:
            self._computer.suggest(Proposal(self._subject.source, self._subject.target, count))

    def recompute(self) -> None:
        """Compute all of them anew."""
        subject, self._subject = self._subject, None
        self._memory.clear()
        self.show(subject, tuple(self.results))

    def forget(self) -> None:
        """Show nothing until something else is blended."""
        self._subject, self.results = None, {}
        self._memory.clear()

    def cancel(self) -> None:
        """Stop computing."""
        self._computer.cancel()

    def close(self) -> None:
        """End the worker; to be called before the program ends."""
        self._computer.close()

    def _state(self, method: str, subject: Subject, former: Subject | None) -> MethodState:
        known = self.results.get(method, MethodState())
        if not known.stale and former is not None and former.of(method) == subject.of(method):
            return known
        remembered = self._memory.get((method, subject.of(method)))
        return known.outdated() if remembered is None else known.after(remembered)

    def _wanted(self, live: bool) -> tuple[str, ...]:
        """Give the methods to compute, the simplest first, so that there is something to see at once.

        During a gesture there is something to see, and the methods come in the order in which they are shown.
        What did not settle during a gesture is computed anew when it ends.
        """
        shown = [(method, self.results[method]) for method in METHODS if method in self.results]
        if live:
            following = (method for method in self.results if method not in UNHURRIED)
            return tuple(method for method in following if self.results[method].stale)
        return tuple(method for method, state in shown if state.stale or not state.settled)

    @Slot(object)
    def _take(self, outcome: Result | Failure) -> None:
        behind = self._computer.behind
        if outcome.method in self.results:
            self.results[outcome.method] = self.results[outcome.method].after(outcome, stale=behind)
            self.changed.emit()
        if isinstance(outcome, Result) and self._subject is not None and not behind:
            self._remember(self._subject, outcome)

    def _remember(self, subject: Subject, result: Result) -> None:
        self._memory[result.method, subject.of(result.method)] = result
        while len(self._memory) > REMEMBERED:
            del self._memory[next(iter(self._memory))]
