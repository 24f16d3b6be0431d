"""The picture with the outline that is traced in it, to be looked at closely."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from app.model.marks import Side
from app.model.placing import corners_of
from app.view.canvas.canvas import NOTCH
from app.view.canvas.painters.backdrop import paint_backdrop
from app.view.painting.camera import Camera
from app.view.painting.drawing import faded, painting, pen, polygon_of
from app.view.painting.theme import theme_of
from starskel.arrays import Floats
from starskel.files.projects.picture import Picture

MARGIN = 16.0
"""Pixels left free around the picture."""

MANY = 400
"""Outlines of more vertices are shown without them."""


class TracePreview(QWidget):
    """Shows a picture as it is placed; the wheel zooms, dragging moves what is seen."""

    def __init__(self, picture: Picture, side: Side) -> None:
        super().__init__()
        self._picture = replace(picture, opacity=1.0, cropped=False)
        self._side: Side = side
        self._rings: Sequence[Floats] = ()
        self._camera = Camera()
        self._fits = True
        self._held: QPointF | None = None
        self.setMinimumSize(360, 300)
        self.setCursor(Qt.CursorShape.OpenHandCursor)
        self.setToolTip(self.tr("The wheel zooms, dragging moves the picture"))

    def show_rings(self, rings: Sequence[Floats]) -> None:
        """Show other outlines, (n, 2) arrays in document units."""
        self._rings = rings
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        theme = theme_of(self.palette())
        with painting(self) as painter:
            painter.fillRect(self.rect(), QColor(theme.base))
            paint_backdrop(painter, self._camera, self._picture, (), faintly=False)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            screen = [self._camera.to_screen(ring) for ring in self._rings]
            for colour, width in ((faded(theme.base, 0.8), 4.0), (theme.side(self._side), 1.6)):
                painter.setPen(pen(colour, width))
                for ring in screen:
                    painter.drawPolygon(polygon_of(ring))
            if sum(map(len, screen)) <= MANY:
                painter.setPen(pen(theme.side(self._side), 5.0))
                for ring in screen:
                    painter.drawPoints(polygon_of(ring))

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._camera = self._camera.resized(self.width(), self.height())
        if self._fits:
            self._camera = self._camera.fitting(corners_of(self._picture), MARGIN)

    def wheelEvent(self, event: QWheelEvent) -> None:
        place, factor = event.position(), NOTCH ** (event.angleDelta().y() / 120)
        self._look(self._camera.zoomed(factor, place.x(), place.y()))
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._held = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held is not None:
            way = event.position() - self._held
            self._held = event.position()
            self._look(self._camera.panned(way.x(), way.y()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held = None

    def _look(self, camera: Camera) -> None:
        self._fits = False
        self._camera = camera
        self.update()
