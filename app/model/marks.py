"""Marks kept in step with the vertices that they name."""

from collections.abc import Collection
from typing import Literal

from starskel.errors import InvalidMarks

Side = Literal["source", "target"]
Mark = tuple[int, int]
Marks = tuple[Mark, ...]

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


def after_insertion(marks: Marks, side: Side, vertex: int) -> Marks:
    """Give the marks after a new vertex took this index."""
    ends = (end(mark, side) for mark in marks)
    return tuple(with_end(mark, side, v + (v >= vertex)) for mark, v in zip(marks, ends, strict=True))


def after_deletion(marks: Marks, side: Side, vertices: Collection[int]) -> Marks:
    """Give the marks after these vertices are gone, and their marks with them."""
    return tuple(
        with_end(mark, side, v - sum(gone < v for gone in vertices))
        for mark in marks
        if (v := end(mark, side)) not in vertices
    )


def add(marks: Marks, new: Mark) -> Marks:
    """Add a mark at the end.

    Raises
    ------
    InvalidMarks
        Naming the new mark and the one that it conflicts with.
    """
    for mark in marks:
        if mark == new:
            raise InvalidMarks(f"the mark {new} is set already", "choose other vertices", [mark])
        for side in SIDES:
            if end(mark, side) == end(new, side):
                raise InvalidMarks(
                    f"vertex {end(new, side)} of the {side} has a mark already, {mark}",
                    "remove that mark first, or choose another vertex",
                    [mark, new],
                )
    _check_between(marks, new)
    return (*marks, new)


def check(marks: Marks) -> None:
    """Check that the marks go round both shapes in the same order.

    Raises
    ------
    InvalidMarks
        Naming two marks in conflict.
    """
    checked: Marks = ()
    for mark in marks:
        checked = add(checked, mark)


def _check_between(marks: Marks, new: Mark) -> None:
    """Check that the new mark lies between the same two marks on both sides."""
    if len(marks) < 2:
        return
    around = sorted(marks, key=lambda mark: end(mark, "target"))
    before = _last_before(marks, new, "source")
    gap = around.index(before)
    ahead = (around.index(_last_before(marks, new, "target")) - gap) % len(marks)
    if not ahead:
        return
    # of the marks that stand in the way, name the next one, by the shorter way round
    passed = around[(gap + 1) % len(marks)] if 2 * ahead < len(marks) else before
    raise InvalidMarks(
        f"the marks {passed} and {new} cross: going round, they come in different orders on the two shapes",
        "move one of the two, or remove it",
        [passed, new],
    )


def _last_before(marks: Marks, new: Mark, side: Side) -> Mark:
    ordered = sorted(marks, key=lambda mark: end(mark, side))
    return ordered[sum(end(mark, side) < end(new, side) for mark in ordered) - 1]
