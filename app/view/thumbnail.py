"""Small pictures of shapes."""

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter

from app.view.camera import Camera
from app.view.drawing import faded, pen, polygon_of
from starskel.predicates import Floats

MARGIN = 4.0
"""Pixels left free around the shape."""


def paint_thumbnail(painter: QPainter, box: QRectF, vertices: Floats, colour: QColor) -> None:
    """Paint a shape as large as it fits in a box."""
    if not len(vertices):
        return
    camera = Camera().resized(box.width(), box.height()).fitting(vertices, MARGIN)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(box.topLeft())
    painter.setPen(pen(colour, 1.2))
    painter.setBrush(faded(colour, 0.3))
    painter.drawPolygon(polygon_of(camera.to_screen(vertices)), Qt.FillRule.WindingFill)
    painter.restore()
