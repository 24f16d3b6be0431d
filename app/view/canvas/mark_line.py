"""The line from a mark that has been begun to the pointer, over both canvases."""

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, Qt, Slot
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QWidget

from app.model.marks import Side
from app.model.point import Point
from app.session import Session
from app.view.canvas.canvas import Canvas
from app.view.painting.drawing import painting, pen, point_of
from app.view.painting.theme import theme_of


class MarkLine(QWidget):
    """Lies over what holds the canvases and lets all events through."""

    def __init__(
        self, session: Session, canvases: Mapping[Side, Canvas], over: QWidget, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._parent = parent
        self._session = session
        self._canvases = canvases
        self._over = over
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        over.installEventFilter(self)
        session.changed.connect(self._follow)
        self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Move):
            self.setGeometry(QRect(self._over.mapTo(self._parent, QPoint()), self._over.size()))
        return super().eventFilter(watched, event)

    @Slot()
    def _follow(self) -> None:
        self.setVisible(self._ends() is not None)
        self.raise_()
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        ends = self._ends()
        if ends is None:
            return
        with painting(self) as painter:
            painter.setRenderHint(painter.RenderHint.Antialiasing)
            painter.setPen(pen(theme_of(self.palette()).accent, 2.0, Qt.PenStyle.DashLine))
            painter.drawLine(*ends)

    def _ends(self) -> tuple[QPointF, QPointF] | None:
        """Give where the line starts and ends, while there is one."""
        start = end = None
        for side, canvas in self._canvases.items():
            overlay = self._session.overlay(side)
            if overlay.pin is not None:
                ring = self._session.document.vertices(side)
                start = self._on_screen(
                    canvas, (float(ring[overlay.pin[0], 0]), float(ring[overlay.pin[0], 1]))
                )
            if overlay.line is not None:
                end = self._on_screen(canvas, overlay.line)
        return (start, end) if start is not None and end is not None else None

    def _on_screen(self, canvas: Canvas, place: Point) -> QPointF:
        corner = canvas.mapTo(self._over, QPoint())
        return point_of(canvas.camera.to_screen(np.array(place))) + QPointF(corner)
