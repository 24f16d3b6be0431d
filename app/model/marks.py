"""Marks kept in step with the vertices that they name."""

from collections.abc import Collection
from typing import Literal

from starskel.correspondence.marks import Mark

Side = Literal["source", "target"]
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


def witness(marks: Marks, first: Mark, second: Mark) -> Mark | None:
    """Give a third mark which shows that two come in different orders round the two shapes."""
    others = (mark for mark in marks if mark not in (first, second))
    return next(
        (mark for mark in others if _turns(mark, first, second, 0) != _turns(mark, first, second, 1)), None
    )


def _turns(a: Mark, b: Mark, c: Mark, side: int) -> bool:
    """Tell whether three marks follow each other in this order, counter-clockwise."""
    return (a[side] < b[side]) + (b[side] < c[side]) + (c[side] < a[side]) == 2


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
