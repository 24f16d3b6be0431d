"""Results: what there is to show of each step of a document, and what is still to be computed."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

from app.compute import Failure, MethodState, Request, Result
from app.model.document import Document
from app.model.marks import Marks
from starskel import METHODS
from starskel.polygon import Polygon

States = Mapping[str, MethodState]


class Pair(NamedTuple):
    """What the blends of a step follow from."""

    source: Polygon | None
    target: Polygon | None
    marks: Marks


@dataclass(frozen=True)
class Results:
    """For each step its pair, and for each method of the document what there is to show of it.

    Attributes
    ----------
    pairs : tuple of Pair
    states : tuple of mappings of str to MethodState
    """

    pairs: tuple[Pair, ...] = ()
    states: tuple[States, ...] = ()

    def following(self, document: Document) -> "Results":
        """Give the results after an edit: those of pairs that are still there hold, wherever they are now.

        The others are stale; where no step came or went they stay to be seen until there are newer ones.
        """
        pairs = _pairs(document)
        states = tuple(self._former(pair, step, len(pairs)) for step, pair in enumerate(pairs))
        shown = tuple({m: former.get(m, MethodState()) for m in document.methods} for former in states)
        return Results(pairs, shown)

    def outdated(self) -> "Results":
        """Let none of them hold."""
        return replace(self, states=tuple(_outdated(states) for states in self.states))

    def after(self, request: Request, outcome: Result | Failure) -> "Results":
        """Take in what the worker delivered, wherever its pair is."""
        pair = Pair(request.source, request.target, request.marks)
        taken = tuple(
            {**states, outcome.method: states[outcome.method].after(outcome)}
            if own == pair and outcome.method in states
            else states
            for own, states in zip(self.pairs, self.states, strict=True)
        )
        return replace(self, states=taken)

    def wanted(self, first: int) -> tuple[Request, ...]:
        """Give what is to be computed: this step first, then those that follow, then those before it.

        The simplest methods come first, so that there is something to see at once.
        """
        order = [*range(first, len(self.pairs)), *range(first)]
        found: dict[Pair, Request] = {}
        for step in order:
            pair, states = self.pairs[step], self.states[step]
            methods = tuple(m for m in METHODS if m in states and states[m].wanted)
            if pair.source is not None and pair.target is not None and methods:
                found.setdefault(pair, Request(pair.source, pair.target, pair.marks, methods))
        return tuple(found.values())

    def _former(self, pair: Pair, step: int, count: int) -> States:
        if pair in self.pairs:
            return self.states[self.pairs.index(pair)]
        if pair.source is None or pair.target is None or len(self.pairs) != count:
            return {}
        return _outdated(self.states[step])


def _pairs(document: Document) -> tuple[Pair, ...]:
    sequence = document.sequence
    ends = pairwise(sequence.shapes)
    return tuple(Pair(*shapes, marks) for shapes, marks in zip(ends, sequence.marks, strict=True))


def _outdated(states: States) -> States:
    return {method: state.outdated() for method, state in states.items()}
