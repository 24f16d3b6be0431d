"""Marks kept in step with the vertices that they name."""

from collections.abc import Callable, Collection
from typing import Literal

from starskel.correspondence.marks import Mark

Side = Literal["source", "target"]
Marks = tuple[Mark, ...]

Renumbering = Callable[[int], int | None]
"""Which number each vertex of a shape has now, None where it is no more."""

SIDES: tuple[Side, Side] = ("source", "target")


def other(side: Side) -> Side:
    """Give the opposite side."""
    return "target" if side == "source" else "source"


def end(mark: Mark, side: Side) -> int:
    """Give the vertex that the mark names on this side."""
    return mark[SIDES.index(side)]


def with_end(mark: Mark, side: Side, vertex: int) -> Mark:
    """Give the mark with another vertex on this side."""
    return (vertex, mark[1]) if side == "source" else (mark[0], vertex)


def mark_at(marks: Marks, side: Side, vertex: int) -> int | None:
    """Give the index of the mark that names this vertex, if there is one."""
    return next((k for k, mark in enumerate(marks) if end(mark, side) == vertex), None)


def witness(marks: Marks, first: Mark, second: Mark) -> Mark | None:
    """Give a third mark which shows that two come in different orders round the two shapes."""
    others = (mark for mark in marks if mark not in (first, second))
    return next(
        (mark for mark in others if _turns(mark, first, second, 0) != _turns(mark, first, second, 1)), None
    )


def _turns(a: Mark, b: Mark, c: Mark, side: int) -> bool:
    """Tell whether three marks follow each other in this order, counter-clockwise."""
    return (a[side] < b[side]) + (b[side] < c[side]) + (c[side] < a[side]) == 2


def followed(marks: Marks, side: Side, renumbered: Renumbering) -> Marks:
    """Give the marks after the vertices of one side were renumbered; None takes a mark along."""
    return tuple(
        with_end(mark, side, vertex) for mark in marks if (vertex := renumbered(end(mark, side))) is not None
    )


def composed(first: Marks, second: Marks) -> Marks:
    """Give the marks that lead by way of a shape between; those that end there are left out."""
    onward = dict(second)
    return tuple((source, onward[middle]) for source, middle in first if middle in onward)


def after_insertion(vertex: int) -> Renumbering:
    """Renumber vertices after a new one took this index."""
    return lambda v: v + (v >= vertex)


def after_deletion(vertices: Collection[int]) -> Renumbering:
    """Renumber vertices after these are gone."""
    return lambda v: None if v in vertices else v - sum(gone < v for gone in vertices)
