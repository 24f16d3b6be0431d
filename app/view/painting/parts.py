"""Shapes of several parts, painted: each part in its colour, with the holes in it."""

from collections.abc import Iterator, Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath

from app.view.painting.drawing import ring_of
from app.view.painting.theme import Theme, mixed
from starskel.arrays import Floats
from starskel.sheet.style import PartLook


def colour_of(look: PartLook, theme: Theme, t: float) -> QColor:
    """Give the colour of a part at t: its own, else the usual one."""
    if look.colours == ("", ""):
        return theme.between(t)
    start, end = (own or usual for own, usual in zip(look.colours, theme.ends, strict=True))
    return mixed(QColor(start), QColor(end), t)


def regions(outer: Sequence[int], shown: Sequence[bool]) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Give each outline that is shown, and the holes in it that are."""
    for number, own in enumerate(outer):
        if own < 0 and shown[number]:
            yield number, tuple(k for k, owner in enumerate(outer) if owner == number and shown[k])


def paint_region(painter: QPainter, outline: Floats, holes: Sequence[Floats] = ()) -> None:
    """Paint an outline with the holes in it; what the outline covers twice is filled all the same."""
    if not holes:
        painter.drawPolygon(ring_of(outline), Qt.FillRule.WindingFill)
        return
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.WindingFill)
    for ring in (outline, *(hole[::-1] for hole in holes)):
        path.addPolygon(ring_of(ring))
        path.closeSubpath()
    painter.drawPath(path)
