"""Words on a canvas: its caption, how to begin, and why something was refused."""

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter

from app.model.marks import Side
from app.view import words
from app.view.drawing import pen
from app.view.pins import cross_at
from app.view.theme import Theme

translate = QCoreApplication.translate

INSET = 10.0


def paint_caption(painter: QPainter, theme: Theme, side: Side, count: int) -> None:
    """Write the name of the canvas in its upper left corner, with a dot in the shape's colour."""
    painter.setFont(_sized(painter.font(), 10.0, bold=True))
    painter.setPen(theme.side(side))
    painter.setBrush(theme.side(side))
    painter.drawEllipse(QPointF(17, 18), 4.5, 4.5)
    painter.setPen(QColor(theme.text))
    name = words.side(side)
    painter.drawText(QPointF(29, 22), name)
    if count:
        shift = painter.fontMetrics().horizontalAdvance(name)
        painter.setFont(_sized(painter.font(), 9.0))
        painter.setPen(QColor(theme.muted))
        painter.drawText(QPointF(39 + shift, 22), translate("Canvas", "%n vertices", "", count))


def paint_invitation(painter: QPainter, theme: Theme, frame: QRectF, side: Side, drawing: bool) -> None:
    """Say in an empty canvas how to begin; `drawing` tells whether the drawing tool is in hand."""
    heading = (
        translate("Canvas", "Draw the source shape here")
        if side == "source"
        else translate("Canvas", "Draw the target shape here")
    )
    how = (
        translate("Canvas", "Click to set each vertex; click the first one again to close.")
        if drawing
        else translate("Canvas", "Press D for the drawing tool, or Ctrl+O to open a file.")
    )
    painter.setPen(QColor(theme.text))
    painter.setFont(_sized(painter.font(), 13.0, bold=True))
    painter.drawText(frame.adjusted(20, 0, -20, -26), Qt.AlignmentFlag.AlignCenter, heading)
    painter.setPen(QColor(theme.muted))
    painter.setFont(_sized(painter.font(), 10.0))
    below = frame.adjusted(20, frame.height() / 2 + 6, -20, 0)
    flags = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
    painter.drawText(below, flags, how)


def paint_notice(painter: QPainter, theme: Theme, frame: QRectF, text: str, concerned: list[QPointF]) -> None:
    """Write why something was refused; on the lower edge, unless that hides what it is about."""
    painter.setFont(_sized(painter.font(), 10.0))
    flags = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
    room = frame.adjusted(INSET + 32, 0, -INSET - 10, 0)
    height = painter.boundingRect(room, flags, text).height() + 14
    box = QRectF(INSET, frame.bottom() - INSET - height, frame.width() - 2 * INSET, height)
    if any(place.y() > box.top() - 20 for place in concerned):
        box.moveTop(frame.top() + 36)
    painter.setPen(pen(theme.refused, 1.5))
    painter.setBrush(QColor(theme.base))
    painter.drawRoundedRect(box, 5, 5)
    cross_at(painter, QPointF(box.left() + 16, box.center().y()), QColor(theme.refused), 4.5)
    painter.setPen(QColor(theme.text))
    painter.drawText(box.adjusted(32, 0, -10, 0), flags, text)


def _sized(font: QFont, points: float, *, bold: bool = False) -> QFont:
    sized = QFont(font)
    sized.setPointSizeF(points)
    sized.setBold(bold)
    return sized
