"""The easing as a curve whose two handles are dragged, or moved by the arrow keys."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.model.point import Point
from app.view.painting.drawing import painting, pen, polygon_of
from app.view.painting.theme import Theme, theme_of
from app.view.timeline.player import Player
from starskel.easing import Easing

MARGIN = 16.0
"""Pixels round the unit square: room for handles on its edge and for the words."""

NUDGE = 0.05
"""How far an arrow key moves a handle."""

ARROWS = {
    Qt.Key.Key_Left: (-NUDGE, 0.0),
    Qt.Key.Key_Right: (NUDGE, 0.0),
    Qt.Key.Key_Up: (0.0, NUDGE),
    Qt.Key.Key_Down: (0.0, -NUDGE),
}

COUNT = 49
"""Points of the curve that is painted."""


class EasingCurve(QWidget):
    """Time to the right, t upwards; a dot shows the moment of the player."""

    edited = Signal(object, int)
    """The easing as it is to be, and the number of the gesture: what one drag does is undone at once."""

    def __init__(self, player: Player) -> None:
        super().__init__()
        self._player = player
        self.handle = 0
        self._dragged = False
        self._gesture = 0
        self.setObjectName("easing-curve")
        self.setAccessibleName(self.tr("Easing curve"))
        self.setToolTip(self.tr("Drag a handle; arrow keys move it, Space takes the other one"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        player.t_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        return QSize(220, 220)

    def on_screen(self, at: Point) -> QPointF:
        """Give the pixel of a point of the unit square."""
        square = self._square()
        return QPointF(square.left() + at[0] * square.width(), square.bottom() - at[1] * square.height())

    def _square(self) -> QRectF:
        return QRectF(self.rect()).adjusted(MARGIN, MARGIN, -MARGIN, -MARGIN)

    def _handles(self) -> tuple[Point, Point]:
        return self._player.easing.first, self._player.easing.second

    def _move_to(self, at: Point) -> None:
        handles = list(self._handles())
        handles[self.handle] = at
        self.edited.emit(Easing(*handles), self._gesture)

    # pointer and keys

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take the nearer handle to where the pointer is."""
        ways = [(self.on_screen(at) - event.position()).manhattanLength() for at in self._handles()]
        self.handle = ways.index(min(ways))
        self._gesture += 1
        self._dragged = True
        self._follow(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._dragged:
            self._follow(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._dragged = False
        self._gesture += 1

    def _follow(self, event: QMouseEvent) -> None:
        square, place = self._square(), event.position()
        self._move_to(
            ((place.x() - square.left()) / square.width(), (square.bottom() - place.y()) / square.height())
        )

    def keyPressEvent(self, event: QKeyEvent) -> None:
        way = ARROWS.get(Qt.Key(event.key()))
        if way is not None:
            x, y = self._handles()[self.handle]
            self._move_to((x + way[0], y + way[1]))
        elif event.key() == Qt.Key.Key_Space:
            self.handle = 1 - self.handle
            self._gesture += 1
            self.update()
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self.update()

    # painting

    def paintEvent(self, event: QPaintEvent) -> None:
        with painting(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._paint(painter, theme_of(self.palette()))

    def _paint(self, painter: QPainter, theme: Theme) -> None:
        square = self._square()
        painter.fillRect(square, QColor(theme.base))
        painter.setPen(pen(theme.edge))
        painter.drawRect(square)
        painter.drawLine(square.bottomLeft(), square.topRight())
        self._paint_words(painter, theme, square)
        paint_curve(painter, theme, square, self._player.easing, 2.5)
        ends = (0.0, 0.0), (1.0, 1.0)
        for number, (end, at) in enumerate(zip(ends, self._handles(), strict=True)):
            held = self.hasFocus() and number == self.handle
            painter.setPen(pen(theme.muted, 1.0))
            painter.drawLine(self.on_screen(end), self.on_screen(at))
            painter.setPen(pen(theme.accent, 2.0))
            painter.setBrush(QColor(theme.accent if held else theme.base))
            painter.drawEllipse(self.on_screen(at), 6.0, 6.0)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme.text))
        t = self._player.t
        painter.drawEllipse(self.on_screen((self._player.easing.time(t), t)), 3.5, 3.5)

    def _paint_words(self, painter: QPainter, theme: Theme, square: QRectF) -> None:
        font = painter.font()
        font.setPointSizeF(8.0)
        painter.setFont(font)
        painter.setPen(QColor(theme.muted))
        inner = square.adjusted(4, 2, -4, -2)
        painter.drawText(inner, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom, self.tr("time"))
        painter.drawText(inner, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop, "t")


def paint_curve(painter: QPainter, theme: Theme, square: QRectF, easing: Easing, width: float) -> None:
    """Paint an easing into a square."""
    points = np.array(easing.points(COUNT)) * (square.width(), -square.height())
    points += (square.left(), square.bottom())
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(pen(theme.accent, width))
    painter.drawPolyline(polygon_of(points))
