"""The blends that are on the screen, and the memory of those that were."""

from PySide6.QtCore import QObject, Signal, Slot

from app.compute.computer import Computer
from app.compute.request import Failure, MethodState, Proposal, Request, Result, Subject
from starskel import METHODS

REMEMBERED = 40
"""So many results are kept besides those shown: undo, and a gesture given up, compute nothing anew."""


UNHURRIED = frozenset({"certified"})
"""Methods too slow to follow a gesture; they are computed when it ends."""

States = dict[str, MethodState]


class Blends(QObject):
    """Keeps the results of the methods that are shown in step with what is blended.

    Attributes
    ----------
    steps : tuple of dict of str to MethodState
        For each step, and in it for each method, what there is to show.
    """

    changed = Signal()
    progressed = Signal(str, float)
    busy_changed = Signal(bool)
    suggested = Signal(object)
    """Marks that were asked for."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.steps: tuple[States, ...] = ({},)
        self._subjects: tuple[Subject | None, ...] = (None,)
        self._first = 0
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
    def results(self) -> States:
        """For each method what there is to show of the step that comes first."""
        return self.steps[self._first]

    @property
    def fresh(self) -> tuple[Result, ...]:
        """The blends of the first step as it is now, in the order in which they are shown."""
        states = self.results.values()
        return tuple(state.result for state in states if state.result is not None and not state.stale)

    def show(
        self,
        subjects: tuple[Subject | None, ...],
        first: int,
        methods: tuple[str, ...],
        *,
        live: bool = False,
    ) -> None:
        """Have these methods blend these, one a step; results that hold are kept, the others computed.

        The step `first` is computed before all others. `live` says that a gesture under way changes it and
        more of the kind will follow.
        """
        same = subjects == self._subjects
        if live and same:
            return
        self.steps = tuple(self._states(step, subjects, methods) for step in range(len(subjects)))
        self._subjects, self._first = subjects, first
        wanted = self._wanted(live)
        if wanted:
            self._computer.request(*wanted)
        elif not same:
            self._computer.cancel()
        self.changed.emit()

    def suggest(self, count: int) -> None:
        """Ask for so many marks of the first step."""
        subject = self._subjects[self._first]
        if subject is not None:
            self._computer.suggest(Proposal(subject.source, subject.target, count))

    def recompute(self) -> None:
        """Compute all of them anew."""
        subjects, self._subjects = self._subjects, (None,) * len(self._subjects)
        self._memory.clear()
        self.show(subjects, self._first, tuple(self.results))

    def forget(self) -> None:
        """Show nothing until something else is blended."""
        self._subjects, self.steps, self._first = (None,), ({},), 0
        self._memory.clear()

    def cancel(self) -> None:
        """Stop computing."""
        self._computer.cancel()

    def close(self) -> None:
        """End the worker; to be called before the program ends."""
        self._computer.close()

    def _states(self, step: int, subjects: tuple[Subject | None, ...], methods: tuple[str, ...]) -> States:
        """Give what to show of a step; while steps are as many as before, the old is better than nothing."""
        subject = subjects[step]
        if subject is None:
            return {method: MethodState() for method in methods}
        known: States = {}
        if subject in self._subjects:
            known = self.steps[self._subjects.index(subject)]
        elif len(subjects) == len(self._subjects):
            known = {method: state.outdated() for method, state in self.steps[step].items()}
        return {method: self._state(known.get(method, MethodState()), method, subject) for method in methods}

    def _state(self, known: MethodState, method: str, subject: Subject) -> MethodState:
        remembered = self._memory.get((method, subject))
        return known.after(remembered) if known.stale and remembered is not None else known

    def _wanted(self, live: bool) -> tuple[Request, ...]:
        """Give what to compute: the first step, those after, those before it; of a gesture the first."""
        order = [*range(self._first, len(self.steps)), *range(self._first)]
        found: dict[Subject, Request] = {}
        for step in order[:1] if live else order:
            subject, states = self._subjects[step], self.steps[step]
            # the simplest method first, so that there is something to see at once
            stale = (method for method in METHODS if method in states and states[method].wanted)
            methods = tuple(method for method in stale if not (live and method in UNHURRIED))
            if subject is not None and methods:
                found.setdefault(subject, Request(subject, methods, live))
        return tuple(found.values())

    @Slot(object, object)
    def _take(self, subject: Subject, outcome: Result | Failure) -> None:
        behind = self._computer.behind
        # a gesture has gone on where it is behind: what comes late is still nearer to it than what is shown
        places = [self._first] if behind else [k for k, own in enumerate(self._subjects) if own == subject]
        for states in (self.steps[place] for place in places):
            if outcome.method in states:
                states[outcome.method] = states[outcome.method].after(outcome, stale=behind)
        self.changed.emit()
        if isinstance(outcome, Result) and not behind:
            self._remember(subject, outcome)

    def _remember(self, subject: Subject, result: Result) -> None:
        self._memory[result.method, subject] = result
        spare = [key for key in self._memory if key[1] not in self._subjects]
        for key in spare[: max(len(spare) - REMEMBERED, 0)]:
            del self._memory[key]
