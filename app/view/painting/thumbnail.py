"""Small pictures of shapes."""

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter

from app.view.painting.camera import Camera
from app.view.painting.drawing import faded, pen
from app.view.painting.parts import paint_region, regions
from starskel.files.key_shape import KeyShape

MARGIN = 4.0
"""Pixels left free around the shape."""


def paint_thumbnail(painter: QPainter, box: QRectF, shape: KeyShape, colour: QColor) -> None:
    """Paint a shape as large as it fits in a box; parts without a colour of their own have this one."""
    if not shape.parts:
        return
    rings = [ring.vertices for ring in shape.rings]
    camera = Camera().resized(box.width(), box.height()).fitting(np.concatenate(rings), MARGIN)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(box.topLeft())
    for outline, holes in regions(shape.shape.outer, [part.visible for part in shape.parts]):
        own = QColor(shape.parts[outline].colour or colour)
        painter.setPen(pen(own, 1.2))
        painter.setBrush(faded(own, 0.3))
        around, *inside = (camera.to_screen(rings[k]) for k in (outline, *holes))
        paint_region(painter, around, inside)
    painter.restore()
