"""Small pictures of shapes."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QPainter

from app.view.painting.camera import Camera
from app.view.painting.drawing import faded, pen
from app.view.painting.parts import paint_region, regions
from starskel.files.projects.key_shape import KeyShape
from starskel.shapes.shape import Shape

MARGIN = 4.0
"""Pixels left free around the shape."""


def paint_thumbnail(painter: QPainter, box: QRectF, shape: KeyShape, colour: QColor) -> None:
    """Paint a shape as large as it fits in a box; parts without a colour of their own have this one."""
    if shape.parts:
        colours = [QColor(part.colour or colour) for part in shape.parts]
        _paint(painter, box, shape.shape, colours, [part.visible for part in shape.parts])


def paint_shape(painter: QPainter, box: QRectF, shape: Shape, colour: QColor) -> None:
    """Paint a shape as large as it fits in a box, all of it in one colour."""
    _paint(painter, box, shape, [colour] * len(shape), [True] * len(shape))


def _paint(
    painter: QPainter, box: QRectF, shape: Shape, colours: Sequence[QColor], shown: Sequence[bool]
) -> None:
    rings = [ring.vertices for ring in shape.rings]
    camera = Camera().resized(box.width(), box.height()).fitting(np.concatenate(rings), MARGIN)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(box.topLeft())
    for outline, holes in regions(shape.outer, shown):
        painter.setPen(pen(colours[outline], 1.2))
        painter.setBrush(faded(colours[outline], 0.3))
        around, *inside = (camera.to_screen(rings[k]) for k in (outline, *holes))
        paint_region(painter, around, inside)
    painter.restore()
