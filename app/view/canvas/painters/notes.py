"""Words on a canvas: its caption, how to begin, and why something was refused."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import shapely
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter

from app.model.marks import Side
from app.tools.tool import Tool
from app.tools.toolbox import TOOLS
from app.view.painting.drawing import pen
from app.view.painting.pins import cross_at
from app.view.painting.theme import Theme
from app.view.wording import words
from app.view.wording.counts import COUNTS
from starskel.arrays import Floats

translate = QCoreApplication.translate

INSET = 10.0

NOTICE_FLAGS = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter

NOTICE = 340.0
"""Width of a notice, in pixels."""

VEIL = 3000.0
"""So many pixels farther away is as bad as lying over the inside of the shape with all of the notice."""

NOTICE_MARGIN = 24.0
"""Pixels between a notice and what it is about."""


def paint_caption(painter: QPainter, theme: Theme, side: Side, name: str, count: int) -> None:
    """Write the name of the canvas in its upper left corner, with a dot in the shape's colour."""
    painter.setFont(_sized(painter.font(), 10.0, bold=True))
    painter.setPen(theme.side(side))
    painter.setBrush(theme.side(side))
    painter.drawEllipse(QPointF(17, 18), 4.5, 4.5)
    painter.setPen(QColor(theme.text))
    painter.drawText(QPointF(29, 22), name)
    if count:
        shift = painter.fontMetrics().horizontalAdvance(name)
        painter.setFont(_sized(painter.font(), 9.0))
        painter.setPen(QColor(theme.muted))
        painter.drawText(QPointF(39 + shift, 22), COUNTS.vertices(count))


def how_to_draw(tool: Tool) -> str:
    """Tell how an empty canvas is filled with the tool in hand."""
    if tool.name == "draw":
        return translate("Canvas", "Click to set each vertex; click the first one again to close.")
    if tool.name in ("select", "mark", "picture"):
        return translate("Canvas", "Take a tool from the left, drop a picture to draw over, or open a file.")
    return words.hint(TOOLS[tool.name].hint)  # not what to do with the shape just made on the other canvas


def paint_line(painter: QPainter, theme: Theme, frame: QRectF, text: str) -> None:
    """Say something in a line at the lower edge of a canvas."""
    painter.setPen(QColor(theme.text))
    painter.setFont(_sized(painter.font(), 10.0, bold=True))
    flags = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignBottom
    painter.drawText(frame.adjusted(20, 0, -20, -10), flags, text)


def paint_invitation(painter: QPainter, theme: Theme, frame: QRectF, heading: str, how: str) -> None:
    """Say in an empty canvas what belongs there, and how to begin."""
    painter.setPen(QColor(theme.text))
    painter.setFont(_sized(painter.font(), 13.0, bold=True))
    painter.drawText(frame.adjusted(20, 0, -20, -26), Qt.AlignmentFlag.AlignCenter, heading)
    painter.setPen(QColor(theme.muted))
    painter.setFont(_sized(painter.font(), 10.0))
    below = frame.adjusted(20, frame.height() / 2 + 6, -20, 0)
    flags = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
    painter.drawText(below, flags, how)


@dataclass(frozen=True, eq=False)
class KeptClear:
    """What a notice must not hide.

    Attributes
    ----------
    concerned : sequence of QPointF
        What it is about; the nearer to it the better.
    labels : sequence of QRectF
        Labels of pins.
    ring : (n, 2) array
        The shape on the screen, of which little may be hidden.
    """

    concerned: Sequence[QPointF] = ()
    labels: Sequence[QRectF] = ()
    ring: Floats = field(default_factory=lambda: np.empty((0, 2)))


def paint_notice(painter: QPainter, theme: Theme, frame: QRectF, text: str, clear: KeptClear) -> None:
    """Write why something was refused, beside what it is about."""
    size = _notice_size(painter, frame, text)
    box = notice_box(*size, frame.adjusted(INSET, 36, -INSET, -INSET), clear)
    _paint_plate(painter, theme, box, theme.refused)
    cross_at(painter, QPointF(box.left() + 16, box.center().y()), QColor(theme.refused), 4.5)
    painter.setPen(QColor(theme.text))
    painter.drawText(box.adjusted(32, 0, -10, 0), NOTICE_FLAGS, text)


def paint_news(painter: QPainter, theme: Theme, frame: QRectF, text: str, clear: list[QPointF]) -> None:
    """Write what an edit brought with it, near to places that stay clear where there is room."""
    size = _notice_size(painter, frame, text)
    box = notice_box(*size, frame.adjusted(INSET, 36, -INSET, -INSET), KeptClear(clear))
    _paint_plate(painter, theme, box, theme.accent)
    painter.setPen(QColor(theme.text))
    painter.drawText(box.adjusted(32, 0, -10, 0), NOTICE_FLAGS, text)
    painter.setPen(QColor(theme.accent))
    painter.setFont(_sized(painter.font(), 12.0, bold=True))
    painter.drawText(QRectF(box.left() + 8, box.top(), 16, box.height()), Qt.AlignmentFlag.AlignCenter, "i")


def _notice_size(painter: QPainter, frame: QRectF, text: str) -> tuple[float, float]:
    """Set the font of a notice, and give the width and the height of its box."""
    painter.setFont(_sized(painter.font(), 10.0))
    width = min(NOTICE, frame.width() - 2 * INSET)
    return width, painter.boundingRect(QRectF(0, 0, width - 42, 0), NOTICE_FLAGS, text).height() + 14


def _paint_plate(painter: QPainter, theme: Theme, box: QRectF, edge: str) -> None:
    painter.setPen(pen(edge, 1.5))
    painter.setBrush(QColor(theme.base))
    painter.drawRoundedRect(box, 5, 5)


def notice_box(width: float, height: float, room: QRectF, clear: KeptClear) -> QRectF:
    """Give the box in the room that is near to what it is about, hides none of it and little of the shape.

    Where there is no such box, or nothing to be near to, it lies on the lower edge.
    """
    lefts = np.linspace(room.left(), max(room.right() - width, room.left()), 12)
    tops = np.linspace(room.top(), max(room.bottom() - height, room.top()), 12)
    boxes = [QRectF(x, y, width, height) for x in lefts.tolist() for y in tops.tolist()]
    beside = [box for box in boxes if not any(_near(box).contains(place) for place in clear.concerned)]
    free = [box for box in beside if not any(box.intersects(label) for label in clear.labels)] or beside
    if not free or not clear.concerned:
        return QRectF(room.left(), room.bottom() - height, width, height)
    ways = [_distance(box, clear.concerned) for box in free]
    return free[int(np.argmin(ways + VEIL * _covered(free, clear.ring)))]


def _distance(box: QRectF, places: Sequence[QPointF]) -> float:
    return sum((box.center() - place).manhattanLength() for place in places)


def _covered(boxes: Sequence[QRectF], ring: Floats) -> Floats:
    """Tell of boxes of one size how much of the shape each hides.

    Inside counts by the part of the box that lies over it, outline by how often it would cross the box: of a
    plain inside little is missed.
    """
    if len(ring) < 3:
        return np.zeros(len(boxes))
    shape = shapely.make_valid(shapely.polygons(ring))  # a gesture under way may cross itself
    plates = shapely.box(*np.array([(b.left(), b.top(), b.right(), b.bottom()) for b in boxes]).T)
    inside = shapely.area(shapely.intersection(plates, shape)) / shapely.area(plates)
    outline = shapely.length(shapely.intersection(plates, shapely.linearrings(ring)))
    return np.asarray(inside + outline / boxes[0].width())


def _near(box: QRectF) -> QRectF:
    return box.adjusted(-NOTICE_MARGIN, -NOTICE_MARGIN, NOTICE_MARGIN, NOTICE_MARGIN)


def _sized(font: QFont, points: float, *, bold: bool = False) -> QFont:
    sized = QFont(font)
    sized.setPointSizeF(points)
    sized.setBold(bold)
    return sized
