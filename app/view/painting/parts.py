"""Shapes of several parts, painted: each part in its colour, with the holes in it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath

from app.model import parts
from app.model.document import Document
from app.view.painting.drawing import polygon_of
from app.view.painting.theme import Theme, mixed
from starskel.predicates import Floats


@dataclass(frozen=True)
class Look:
    """How a part looks on its way.

    Attributes
    ----------
    colours : (str, str)
        At the start and at the end; empty for the usual ones.
    visible : bool
        Whether it is shown.
    """

    colours: tuple[str, str] = ("", "")
    visible: bool = True

    def colour(self, theme: Theme, t: float) -> QColor:
        """Give the colour at t."""
        if self.colours == ("", ""):
            return theme.between(t)
        start, end = (given or usual for given, usual in zip(self.colours, theme.ends, strict=True))
        return mixed(QColor(start), QColor(end), t)


def looks_of(document: Document) -> tuple[Look, ...]:
    """Give how the part of each link looks; it is shown while one of both is to be seen."""
    return tuple(
        Look(parts.colours(document, number), parts.shown(document, number))
        for number in range(len(document.way.links))
    )


def regions(outer: Sequence[int], shown: Sequence[bool]) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Give each outline that is shown, and the holes in it that are."""
    for number, own in enumerate(outer):
        if own < 0 and shown[number]:
            yield number, tuple(k for k, owner in enumerate(outer) if owner == number and shown[k])


def paint_region(painter: QPainter, outline: Floats, holes: Sequence[Floats] = ()) -> None:
    """Paint an outline with the holes in it; what the outline covers twice is filled all the same."""
    if not holes:
        painter.drawPolygon(polygon_of(outline), Qt.FillRule.WindingFill)
        return
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.WindingFill)
    for ring in (outline, *(hole[::-1] for hole in holes)):
        path.addPolygon(polygon_of(ring))
        path.closeSubpath()
    painter.drawPath(path)
