"""The sheet that compares methods: a row for each, with its verdict, its figures and its frames."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from starskel.quality import Report, ShapeReport
from starskel.sheet import style
from starskel.sheet.cell import cross_sign, layers_sign, tick_sign
from starskel.sheet.drawing import Colour, Drawing, Item, Label, Line, Place
from starskel.sheet.keyframe import Keyframe
from starskel.sheet.rows import Grid, paper
from starskel.sheet.style import Look
from starskel.sheet.words import Kind, figures, kind_of, verdict

_TITLE = 34.0
_HEAD = 20.0
_LINE = 12.0
_SIGN = 4.0

_SIGNS: dict[Kind, tuple[Callable[[Place, float], Iterator[Item]], Colour]] = {
    "simple": (tick_sign, style.SIMPLE),
    "natural": (layers_sign, style.NATURAL),
    "harmful": (cross_sign, style.CROSSING),
}


@dataclass(frozen=True, eq=False)
class Row:
    """What a method made of a pair.

    Attributes
    ----------
    name : str
        The method.
    kind : "simple", "natural" or "harmful"
        Whether frames meet themselves, and how.
    verdict : str
        The same in words, saying when frames do.
    figures : tuple of str
        What else was measured, a line each.
    frames : tuple of Keyframe
        The frames to show, at the same times in every row.
    """

    name: str
    kind: Kind
    verdict: str
    figures: tuple[str, ...]
    frames: tuple[Keyframe, ...]

    @classmethod
    def of(cls, name: str, report: Report | ShapeReport, frames: tuple[Keyframe, ...]) -> "Row":
        """Give the row of a method that was measured."""
        return cls(name, kind_of(report), verdict(report), figures(report), frames)


SHEET = Look(paper=style.PAPER)
"""How a sheet looks where nothing else is asked for."""


def comparison_sheet(title: str, rows: Sequence[Row], titled: bool = True, look: Look = SHEET) -> Drawing:
    """Give the rows under one another, all in one scale, and the title on top if it is to be seen."""
    grid = Grid.of([frame for row in rows for frame in row.frames], look)
    text = (2 + max(len(row.figures) for row in rows)) * _LINE
    pitch = max(grid.height, text) + look.gap
    columns = len(rows[0].frames)
    left = look.margin + _heading_width(rows) + look.gap
    width = left + columns * (grid.width + look.gap) - look.gap + look.margin
    head, letters = (_TITLE, style.TITLE_SIZE) if titled else (_HEAD, style.TEXT_SIZE)
    height = look.margin + head + len(rows) * pitch + look.margin - look.gap / 2
    middles = [left + column * (grid.width + look.gap) + grid.width / 2 for column in range(columns)]
    base = height - look.margin - letters

    def items() -> Iterator[Item]:
        yield from paper(width, height, look)
        if titled:
            yield Label(title, (look.margin, base), style.TITLE_SIZE, style.INK, bold=True)
        for x, frame in zip(middles, rows[0].frames, strict=True):
            yield Label(f"t = {frame.t:.3g}", (x, base), style.TEXT_SIZE, style.FAINT, "middle")
        for number, row in enumerate(rows):
            top = height - look.margin - head - number * pitch
            yield Line(np.array([[look.margin, top], [width - look.margin, top]]), style.HAIRLINE)
            y = top - pitch / 2
            yield from _heading(row, look.margin, y + text / 2)
            for column, (x, frame) in enumerate(zip(middles, row.frames, strict=True)):
                yield grid.cell(f"{row.name}-{column}", frame, (x, y))

    return Drawing(title, width, height, tuple(items()))


def _heading_width(rows: Sequence[Row]) -> float:
    """Give room for the longest line; the letters of the face are half as wide as high, in the mean."""
    lines = [line for row in rows for line in (row.verdict, *row.figures)]
    return 3 * _SIGN + 0.5 * style.TEXT_SIZE * max(24, *map(len, lines))


def _heading(row: Row, left: float, top: float) -> Iterator[Item]:
    base = top - style.NAME_SIZE
    yield Label(row.name, (left, base), style.NAME_SIZE, style.INK, bold=True)
    sign, colour = _SIGNS[row.kind]
    base -= _LINE * 1.15
    yield from sign((left + _SIGN, base + 0.36 * style.TEXT_SIZE), _SIGN)
    yield Label(row.verdict, (left + 3 * _SIGN, base), style.TEXT_SIZE, colour)
    for figure in row.figures:
        base -= _LINE
        yield Label(figure, (left, base), style.TEXT_SIZE, style.FAINT)
