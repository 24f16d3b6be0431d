"""The blends that are on the screen, and the memory of those that were."""

from PySide6.QtCore import QObject, Signal, Slot

from app.compute.computer import Computer
from app.compute.request import Failure, MethodState, Proposal, Request, Result, Subject
from app.model.marks import Marks
from starskel import METHODS
from starskel.blending import COMPARED
from starskel.polygon import Polygon

REMEMBERED = 40
"""So many results are kept besides those shown: undo, and a gesture given up, compute nothing anew."""


UNHURRIED = frozenset({"certified"})
"""Methods too slow to follow a gesture; they are computed when it ends."""

LARGE = 8_000
"""What has more vertices is blended when that is asked for, not before: it takes minutes and much memory."""

USUAL_METHODS = tuple(method for method in COMPARED if method not in UNHURRIED)
"""What is compared until the user chooses: every method that is quick."""

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
    suggested = Signal(object, object)
    """A Proposal, and the marks that were asked for by it."""
    restarted = Signal()
    """The computation ended by a fault and was begun anew."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.steps: tuple[States, ...] = ({},)
        self._subjects: tuple[Subject | None, ...] = (None,)
        self._first = 0
        self._asked: frozenset[Subject] = frozenset()
        self._memory: dict[tuple[str, Subject], Result] = {}
        self._computer = Computer(self)
        self._computer.delivered.connect(self._take)
        self._computer.suggested.connect(self._pass_on)
        self._computer.restarted.connect(self.restarted)
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
        return self.fresh_of(self._first)

    def fresh_of(self, step: int) -> tuple[Result, ...]:
        """Give the blends of any step as it is now."""
        states = self.steps[step].values() if step < len(self.steps) else ()
        return tuple(state.fresh for state in states if state.fresh is not None)

    @property
    def held(self) -> int:
        """How many vertices the first step has, where they are too many to be blended unasked."""
        subject = self._subjects[self._first]
        return subject.size if subject is not None and self._waits(subject) else 0

    def _waits(self, subject: Subject) -> bool:
        return subject.size > LARGE and subject not in self._asked

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

    def suggest(self, source: Polygon, target: Polygon, count: int) -> None:
        """Ask for so many marks of two polygons; blends that are under way are gone on with after it."""
        self._computer.suggest(Proposal(source, target, count))

    def recompute(self) -> None:
        """Compute all of them anew, the large ones as well."""
        self._asked = frozenset(subject for subject in self._subjects if subject is not None)
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
        subject = subjects[step]
        if subject is None:
            return {method: MethodState() for method in methods}
        return {method: self._state(step, subject, method, len(subjects)) for method in methods}

    def _state(self, step: int, subject: Subject, method: str, count: int) -> MethodState:
        """Give what holds; else, while steps are as many as before, the old, which is better than nothing."""
        own = subject.of(method)
        known = self.steps[step].get(method, MethodState()) if count == len(self.steps) else MethodState()
        for former, states in zip(self._subjects, self.steps, strict=True):
            if former is not None and former.of(method) == own and method in states:
                known = states[method]
                break
        else:
            known = known.outdated()
        remembered = self._memory.get((method, own))
        return known.after(remembered) if known.stale and remembered is not None else known

    def _wanted(self, live: bool) -> tuple[Request, ...]:
        """Give what to compute: the first step, those after, those before it; of a gesture the first."""
        order = [*range(self._first, len(self.steps)), *range(self._first)]
        found: dict[Subject, Request] = {}
        for step in order[:1] if live else order:
            subject, states = self._subjects[step], self.steps[step]
            # the simplest first, so that there is something to see at once; in a gesture there already is
            known = (m for m in (states if live else METHODS) if m in states)
            methods = tuple(m for m in known if _is_wanted(m, states[m], live))
            if subject is not None and methods and not self._waits(subject):
                found.setdefault(subject, Request(subject, methods, live))
        return tuple(found.values())

    @Slot(object, object)
    def _take(self, subject: Subject, outcome: Result | Failure) -> None:
        behind = self._computer.behind
        # a gesture has gone on where it is behind: what comes late is still nearer to it than what is shown
        places = [self._first] if behind else self._places(subject.of(outcome.method), outcome.method)
        for states in (self.steps[place] for place in places):
            if outcome.method in states:
                states[outcome.method] = states[outcome.method].after(outcome, stale=behind)
        self.changed.emit()
        if isinstance(outcome, Result) and not behind:
            self._remember(subject.of(outcome.method), outcome)

    @Slot(object, object)
    def _pass_on(self, proposal: Proposal, marks: Marks) -> None:
        """Give suggested marks on; unless that begins something new, go on with what it interrupted."""
        self.suggested.emit(proposal, marks)
        if not self.busy and (wanted := self._wanted(live=False)):
            self._computer.request(*wanted)

    def _places(self, subject: Subject, method: str) -> list[int]:
        return [k for k, own in enumerate(self._subjects) if own is not None and own.of(method) == subject]

    def _remember(self, subject: Subject, result: Result) -> None:
        self._memory[result.method, subject] = result
        spare = [key for key in self._memory if not self._places(key[1], key[0])]
        for key in spare[: max(len(spare) - REMEMBERED, 0)]:
            del self._memory[key]


def _is_wanted(method: str, state: MethodState, live: bool) -> bool:
    """Tell whether to compute: what failed would fail again; what a gesture left unsettled is taken up."""
    if state.error is not None:
        return False
    return (state.stale and method not in UNHURRIED) if live else (state.stale or not state.settled)
