"""What a canvas shows of the gesture under way: paths, figures, frames, and what catches the pointer."""

from math import atan2, degrees

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter

from app.model.point import Point
from app.tools.handles import TURN, handle_places
from app.tools.picture import picture_handles
from app.tools.tool import Catch, Overlay
from app.view.painting.camera import Camera
from app.view.painting.drawing import faded, pen, point_of, polygon_of, ring_of
from app.view.painting.theme import Theme
from app.view.wording import words
from starskel.arrays import Floats
from starskel.files.projects.picture import Picture


class GesturePainter:
    """Paints an overlay once, in the colour of its shape."""

    def __init__(self, painter: QPainter, theme: Theme, camera: Camera, colour: QColor) -> None:
        self._painter = painter
        self._theme = theme
        self._camera = camera
        self._colour = colour

    def paint(self, overlay: Overlay) -> None:
        """Paint everything, what is nearest to the pointer last."""
        if overlay.figure is not None:
            self._paint_figure(overlay.figure, overlay.beside)
        if overlay.trail is not None:
            self._paint_trail(overlay.trail)
        if overlay.path:
            self._paint_path(overlay)
        if overlay.frame is not None:
            self._paint_frame(overlay)
        if overlay.picture is not None and overlay.handles:
            self._paint_picture_frame(overlay.picture, overlay.handle)
        if overlay.box is not None:
            self._paint_box(overlay.box)
        if overlay.catch is not None and overlay.catch.kind:
            self._paint_catch(overlay.catch)
        if overlay.readout is not None:
            place, text = overlay.readout
            self._write(self._place(place) + QPointF(14, 26), words.figure(text))

    def _place(self, point: Point) -> QPointF:
        return point_of(self._camera.to_screen(np.array(point)))

    def _paint_figure(self, ring: Floats, beside: tuple[Floats, ...]) -> None:
        self._painter.setPen(pen(self._colour, 1.5))
        self._painter.setBrush(faded(self._colour, 0.22))
        self._painter.drawPolygon(ring_of(self._camera.to_screen(ring)), Qt.FillRule.WindingFill)
        self._painter.setPen(pen(faded(self._colour, 0.6), 1.0, Qt.PenStyle.DashLine))
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        for other in beside:
            self._painter.drawPolygon(ring_of(self._camera.to_screen(other)))

    def _paint_trail(self, trail: Floats) -> None:
        screen = self._camera.to_screen(trail)
        self._painter.setPen(pen(faded(self._theme.muted, 0.8), 1.0))
        self._painter.drawPolyline(polygon_of(screen))
        self._painter.setPen(pen(faded(self._theme.muted, 0.8), 1.0, Qt.PenStyle.DotLine))
        self._painter.drawLine(point_of(screen[-1]), point_of(screen[0]))

    def _paint_path(self, overlay: Overlay) -> None:
        screen = self._camera.to_screen(np.array(overlay.path))
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(faded(self._colour, 0.15))
        self._painter.drawPolygon(ring_of(screen))
        self._painter.setPen(pen(self._colour, 2.0))
        self._painter.drawPolyline(polygon_of(screen[:-1]))
        self._painter.setPen(pen(self._colour, 1.5, Qt.PenStyle.DashLine))
        self._painter.drawLine(point_of(screen[-2]), point_of(screen[-1]))
        self._painter.setPen(pen(self._colour, 1.5))
        self._painter.setBrush(QColor(self._theme.base))
        for place in screen[1:-1]:
            self._painter.drawRect(square(place, 3.0))
        self._paint_first_vertex(screen[0], closes=overlay.closes)

    def _paint_first_vertex(self, place: Floats, *, closes: bool) -> None:
        """Show the vertex that closes the path: larger, filled when the pointer is on it."""
        self._painter.setPen(pen(self._theme.accent if closes else self._colour, 2.0))
        self._painter.setBrush(QColor(self._theme.accent if closes else self._theme.base))
        self._painter.drawEllipse(point_of(place), 6.0, 6.0)

    def _paint_frame(self, overlay: Overlay) -> None:
        """Show the frame around what is selected, squares to scale it, a circle on a stalk to turn it."""
        assert overlay.frame is not None
        places = handle_places(overlay.frame, 1 / self._camera.scale, self._camera.seen)
        self._paint_handles(places, overlay.handle, Qt.PenStyle.SolidLine)

    def _paint_picture_frame(self, picture: Picture, held: str) -> None:
        """Show the frame of a picture, dashed, with the same handles."""
        places = picture_handles(picture, 1 / self._camera.scale, self._camera.seen)
        self._paint_handles(places, held, Qt.PenStyle.DashLine)

    def _paint_handles(self, handles: dict[str, Point], held: str, line: Qt.PenStyle) -> None:
        places = {name: self._place(at) for name, at in handles.items()}
        corners = ("south-west", "south-east", "north-east", "north-west")
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.setPen(pen(faded(self._theme.accent, 0.6), 1.0, line))
        self._painter.drawPolygon([places[name] for name in corners])
        turn = places[TURN]
        sides = sorted((places["north"], places["south"]), key=lambda side: (side - turn).manhattanLength())
        self._painter.drawLine(sides[0], turn)
        self._painter.setPen(pen(self._theme.accent, 1.5))
        for name, place in places.items():
            self._painter.setBrush(QColor(self._theme.accent if name == held else self._theme.base))
            if name == TURN:
                self._painter.drawEllipse(place, 5.0, 5.0)
            else:
                self._painter.drawRect(QRectF(place.x() - 4, place.y() - 4, 8, 8))

    def _paint_box(self, box: tuple[Point, Point]) -> None:
        self._painter.setPen(pen(self._theme.accent, 1.0, Qt.PenStyle.DashLine))
        self._painter.setBrush(faded(self._theme.accent, 0.1))
        self._painter.drawRect(QRectF(*(self._place(corner) for corner in box)).normalized())

    def _paint_catch(self, catch: Catch) -> None:
        """Show what catches the pointer: guides, a ring around the place, and a word."""
        place = self._place(catch.at)
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.setPen(pen(self._theme.accent, 1.0, Qt.PenStyle.DashLine))
        for start, end in catch.guides:
            self._painter.drawLine(self._place(start), self._place(end))
        self._painter.setPen(pen(self._theme.accent, 1.5))
        self._painter.drawEllipse(place, 6.0, 6.0)
        angle = round(_angle(catch)) if catch.kind == "angle" else 0
        self._write(place + QPointF(12, -10), words.catch(catch.kind, angle))

    def _write(self, place: QPointF, text: str) -> None:
        """Write on a plate of the ground's colour, so that it can be read on any shape."""
        font = QFont(self._painter.font())
        font.setPointSizeF(9.0)
        font.setBold(False)
        self._painter.setFont(font)
        box = QRectF(self._painter.fontMetrics().boundingRect(text)).translated(place).adjusted(-4, -2, 4, 2)
        room = QRectF(4, 4, self._camera.width - 8, self._camera.height - 8)
        box.moveLeft(min(box.left(), room.right() - box.width()))
        box.moveBottom(min(box.bottom(), room.bottom()))
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(faded(self._theme.base, 0.85))
        self._painter.drawRoundedRect(box, 3, 3)
        self._painter.setPen(QColor(self._theme.text))
        self._painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


def square(place: Floats, half: float) -> QRectF:
    """Give a square about a place on the screen."""
    return QRectF(place[0] - half, place[1] - half, 2 * half, 2 * half)


def _angle(catch: Catch) -> float:
    (start, end) = catch.guides[0]
    return degrees(atan2(end[1] - start[1], end[0] - start[0]))
