"""What a canvas shows: the shape, its vertices and pins, the gesture under way, and what was refused."""

import numpy as np
from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPalette

from app.model.marks import Side, end, mark_at
from app.session import Session
from app.tools.tool import Overlay, Segment
from app.view import words
from app.view.camera import Camera
from app.view.drawing import faded, pen, point_of, polygon_of
from app.view.pins import cross_at, outward, paint_label, paint_pin
from app.view.theme import theme_of
from starskel.predicates import Floats

translate = QCoreApplication.translate

CROWDED = 7.0
"""Vertices nearer to each other than so many pixels, on average, are not shown one by one."""


class CanvasPainter:
    """Paints one canvas once."""

    def __init__(
        self, painter: QPainter, palette: QPalette, camera: Camera, session: Session, side: Side
    ) -> None:
        self._painter = painter
        self._theme = theme_of(palette)
        self._camera = camera
        self._session = session
        self._side: Side = side
        self._overlay: Overlay = session.overlay(side)
        self._colour = self._theme.side(side)
        stored = session.document.vertices(side)
        self._ring: Floats = stored if self._overlay.ring is None else self._overlay.ring
        self._screen = camera.to_screen(self._ring)

    def paint(self) -> None:
        """Paint everything, from the ground up."""
        self._painter.fillRect(self._frame(), QColor(self._theme.base))
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_shape()
        self._paint_vertices()
        self._paint_pins()
        self._paint_path()
        self._paint_box()
        self._paint_refusal()
        self._paint_caption()
        self._paint_invitation()

    def _frame(self) -> QRectF:
        return QRectF(0, 0, self._camera.width, self._camera.height)

    # the document

    def _paint_shape(self) -> None:
        if not len(self._screen):
            return
        replaced = bool(self._overlay.path)  # the shape that closing the path would replace
        self._painter.setPen(pen(faded(self._colour, 0.35 if replaced else 1.0), 1.5))
        self._painter.setBrush(faded(self._colour, 0.07 if replaced else 0.22))
        self._painter.drawPolygon(polygon_of(self._screen), Qt.FillRule.WindingFill)

    def _paint_vertices(self) -> None:
        selected = self._session.selection.on(self._side)
        self._painter.setPen(pen(self._colour, 1.5))
        self._painter.setBrush(QColor(self._theme.base))
        if not self._crowded() and not self._overlay.path:
            for place in self._screen:
                self._painter.drawRect(_square(place, 2.5))
        self._painter.setPen(pen(self._theme.base, 1.0))
        self._painter.setBrush(QColor(self._theme.accent))
        for vertex in selected:
            if vertex < len(self._screen):
                self._painter.drawRect(_square(self._screen[vertex], 4.5))
        self._paint_hover()

    def _crowded(self) -> bool:
        if len(self._screen) < 40:
            return False
        ways = np.diff(self._screen, axis=0, append=self._screen[:1])
        return float(np.hypot(*ways.T).mean()) < CROWDED

    def _paint_hover(self) -> None:
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.setPen(pen(self._theme.accent, 2.0))
        if self._overlay.vertex is not None:
            self._painter.drawEllipse(point_of(self._screen[self._overlay.vertex]), 7.5, 7.5)
        if self._overlay.insertion is not None:
            place = point_of(self._camera.to_screen(np.array(self._overlay.insertion)))
            self._painter.drawLine(place - QPointF(4, 0), place + QPointF(4, 0))
            self._painter.drawLine(place - QPointF(0, 4), place + QPointF(0, 4))

    def _paint_pins(self) -> None:
        moved = self._overlay.pin
        for index, mark in enumerate(self._session.document.marks):
            if moved is None or moved[1] != index:
                self._paint_pin(end(mark, self._side), index)
        if moved is not None:
            self._paint_pin(*moved)

    def _paint_pin(self, vertex: int, index: int) -> None:
        pins = self._theme.pins
        paint_pin(self._painter, self._screen[vertex], self._away(vertex), index, pins[index % len(pins)])

    def _away(self, vertex: int) -> Floats:
        """Give the direction out of the shape on the screen, where y runs down."""
        direction: Floats = outward(self._ring, vertex) * (1, -1)
        return direction

    # the gesture

    def _paint_path(self) -> None:
        path = self._overlay.path
        if not path:
            return
        screen = self._camera.to_screen(np.array(path))
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(faded(self._colour, 0.15))
        self._painter.drawPolygon(polygon_of(screen))
        self._painter.setPen(pen(self._colour, 2.0))
        self._painter.drawPolyline(polygon_of(screen[:-1]))
        self._painter.setPen(pen(self._colour, 1.5, Qt.PenStyle.DashLine))
        self._painter.drawLine(point_of(screen[-2]), point_of(screen[-1]))
        self._painter.setPen(pen(self._colour, 1.5))
        self._painter.setBrush(QColor(self._theme.base))
        for place in screen[1:-1]:
            self._painter.drawRect(_square(place, 3.0))
        self._paint_first_vertex(screen)

    def _paint_first_vertex(self, screen: Floats) -> None:
        """Show the vertex that closes the path: larger, filled when the pointer is on it."""
        closing = self._theme.accent if self._overlay.closes else self._colour
        self._painter.setPen(pen(closing, 2.0))
        self._painter.setBrush(QColor(self._theme.accent if self._overlay.closes else self._theme.base))
        self._painter.drawEllipse(point_of(screen[0]), 6.0, 6.0)

    def _paint_box(self) -> None:
        if self._overlay.box is None:
            return
        first, second = (point_of(corner) for corner in self._camera.to_screen(np.array(self._overlay.box)))
        self._painter.setPen(pen(self._theme.accent, 1.0, Qt.PenStyle.DashLine))
        self._painter.setBrush(faded(self._theme.accent, 0.1))
        self._painter.drawRect(QRectF(first, second).normalized())

    # what was refused

    def _paint_refusal(self) -> None:
        refusal = self._session.refusal
        if refusal is None:
            return
        for mark in refusal.marks:
            self._paint_refused_pin(end(mark, self._side), mark in self._session.document.marks)
        if refusal.side != self._side:
            return
        red = QColor(self._theme.refused)
        self._painter.setPen(pen(red, 3.0))
        for segment in refusal.segments:
            self._paint_segment(segment)
        if refusal.place is not None:
            cross_at(self._painter, point_of(self._camera.to_screen(np.array(refusal.place))), red)
        self._paint_notice(words.reason(refusal.error, self._session.document))

    def _paint_segment(self, segment: Segment) -> None:
        start, stop = self._camera.to_screen(np.array(segment))
        self._painter.drawLine(point_of(start), point_of(stop))

    def _paint_refused_pin(self, vertex: int, known: bool) -> None:
        """Ring the vertex in red; the new mark has no number yet."""
        place = self._screen[vertex]
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.setPen(pen(self._theme.refused, 3.0))
        self._painter.drawEllipse(point_of(place), 11.0, 11.0)
        taken = mark_at(self._session.document.marks, self._side, vertex) is not None
        if not known and not taken:
            paint_label(self._painter, place, self._away(vertex), "✕", self._theme.refused)

    def _paint_notice(self, text: str) -> None:
        """Write the reason on the lower edge, where it hides little of the shape."""
        self._painter.setFont(_sized(self._painter.font(), 10.0))
        margin = 10.0
        room = self._frame().adjusted(2 * margin + 22, margin, -2 * margin, -margin)
        flags = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        needed = self._painter.boundingRect(room, flags, text)
        box = QRectF(
            margin,
            room.bottom() - needed.height() - 14,
            self._frame().width() - 2 * margin,
            needed.height() + 14,
        )
        self._painter.setPen(pen(self._theme.refused, 1.5))
        self._painter.setBrush(QColor(self._theme.base))
        self._painter.drawRoundedRect(box, 5, 5)
        cross_at(self._painter, QPointF(box.left() + 16, box.center().y()), QColor(self._theme.refused), 4.5)
        self._painter.setPen(QColor(self._theme.text))
        self._painter.drawText(box.adjusted(32, 0, -10, 0), flags, text)

    # words

    def _paint_caption(self) -> None:
        painter = self._painter
        painter.setFont(_sized(painter.font(), 10.0, bold=True))
        painter.setPen(self._colour)
        painter.setBrush(self._colour)
        painter.drawEllipse(QPointF(17, 18), 4.5, 4.5)
        painter.setPen(QColor(self._theme.text))
        name = words.side(self._side)
        painter.drawText(QPointF(29, 22), name)
        if len(self._screen):
            shift = painter.fontMetrics().horizontalAdvance(name)
            painter.setFont(_sized(painter.font(), 9.0))
            painter.setPen(QColor(self._theme.muted))
            count = translate("Canvas", "%n vertices", "", len(self._ring))
            painter.drawText(QPointF(29 + shift + 10, 22), count)

    def _paint_invitation(self) -> None:
        """Say in an empty canvas how to begin."""
        if len(self._screen) or self._overlay.path:
            return
        painter = self._painter
        lines = self._invitation()
        painter.setPen(QColor(self._theme.text))
        painter.setFont(_sized(painter.font(), 13.0, bold=True))
        middle = self._frame().adjusted(20, 0, -20, -26)
        painter.drawText(middle, Qt.AlignmentFlag.AlignCenter, lines[0])
        painter.setPen(QColor(self._theme.muted))
        painter.setFont(_sized(painter.font(), 10.0))
        below = self._frame().adjusted(20, self._frame().height() / 2 + 6, -20, 0)
        flags = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
        painter.drawText(below, flags, lines[1])

    def _invitation(self) -> tuple[str, str]:
        heading = (
            translate("Canvas", "Draw the source shape here")
            if self._side == "source"
            else translate("Canvas", "Draw the target shape here")
        )
        if self._session.tool.name == "draw":
            return heading, translate(
                "Canvas", "Click to set each vertex; click the first one again to close."
            )
        return heading, translate("Canvas", "Press D for the drawing tool, or Ctrl+O to open a file.")


def _square(place: Floats, half: float) -> QRectF:
    return QRectF(place[0] - half, place[1] - half, 2 * half, 2 * half)


def _sized(font: QFont, points: float, *, bold: bool = False) -> QFont:
    sized = QFont(font)
    sized.setPointSizeF(points)
    sized.setBold(bold)
    return sized
