"""Marks must be vertices of the polygons and go round both in the same order."""

import operator
from collections.abc import Iterable

import numpy as np

from starskel.errors import InvalidMarks, told
from starskel.polygon import Polygon

Mark = tuple[int, int]


def as_marks(given: Iterable[tuple[int, int]]) -> tuple[Mark, ...]:
    """Give the marks as pairs of integers.

    Raises
    ------
    InvalidMarks
        Where something else is given.
    """
    try:
        return tuple((operator.index(i), operator.index(j)) for i, j in given)
    except (TypeError, ValueError):
        raise InvalidMarks(
            told("the marks are not pairs of vertices"),
            told("give each mark as (vertex of the source, vertex of the target), counted from 0"),
        ) from None


def checked_marks(source: Polygon, target: Polygon, marks: tuple[Mark, ...]) -> list[Mark]:
    """Give the marks as indices of the polygons' own vertices, in the order round the source.

    Raises
    ------
    InvalidMarks
        Where a vertex does not exist or is marked twice, or the orders round the two polygons disagree.
    """
    for side, polygon in enumerate((source, target)):
        _check_range(polygon, marks, side)
        _check_repeats(marks, side)
    own = [(source.vertex_of(i), target.vertex_of(j)) for i, j in marks]
    in_order = sorted(own)
    ends = np.array([j for _, j in in_order], dtype=np.intp)
    if np.count_nonzero(np.roll(ends, -1) < ends) > 1:
        _refuse_order(own, marks)
    return in_order


def _check_range(polygon: Polygon, marks: tuple[Mark, ...], side: int) -> None:
    name = (told("source"), told("target"))[side]
    for number, mark in enumerate(marks):
        if not 0 <= mark[side] < len(polygon):
            raise InvalidMarks(
                told(
                    "mark {number} names vertex {vertex} of the {name}, which has {count}",
                    number=number,
                    vertex=mark[side],
                    name=name,
                    count=len(polygon),
                ),
                told("give a vertex from 0 to {last}", last=len(polygon) - 1),
                marks=[mark],
            )


def _check_repeats(marks: tuple[Mark, ...], side: int) -> None:
    name = (told("source"), told("target"))[side]
    first: dict[int, int] = {}
    for number, mark in enumerate(marks):
        earlier = first.setdefault(mark[side], number)
        if earlier != number:
            raise InvalidMarks(
                told(
                    "marks {earlier} and {number} both name vertex {vertex} of the {name}",
                    earlier=earlier,
                    number=number,
                    vertex=mark[side],
                    name=name,
                ),
                told("remove one of them"),
                marks=[marks[earlier], mark],
            )


def _refuse_order(own: list[Mark], marks: tuple[Mark, ...]) -> None:
    first, second = _conflict(own)
    raise InvalidMarks(
        told(
            "marks {first} {a} and {second} {b} come in one order round the source"
            " and in the other round the target",
            first=first,
            a=marks[first],
            second=second,
            b=marks[second],
        ),
        told("remove or move one of them"),
        marks=[marks[first], marks[second]],
    )


def _conflict(own: list[Mark]) -> Mark:
    """Find the first mark that does not fit those before it, and that one of these which it has passed.

    Of its neighbours round the source, that is the one nearer, in marks, to its place round the target.
    """
    for number in range(2, len(own)):
        by_source = sorted(range(number), key=lambda k: own[k][0])
        by_target = sorted(range(number), key=lambda k: own[k][1])
        after_source = _next(own, by_source, number, side=0)
        after_target = _next(own, by_target, number, side=1)
        forward = (by_source.index(after_target) - by_source.index(after_source)) % number
        if forward:
            passed = after_source if 2 * forward <= number else by_source[by_source.index(after_source) - 1]
            return passed, number
    raise AssertionError("the marks are in order")


def _next(own: list[Mark], in_order: list[int], number: int, side: int) -> int:
    """Give the mark that follows after this one, cyclically, among those in order."""
    return next((k for k in in_order if own[k][side] > own[number][side]), in_order[0])
