"""The picture behind a shape, as it is placed: whole, or only what of it is inside the shape."""

from collections.abc import Sequence
from math import log2

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPainterPath, QTransform

from app.view.painting.camera import Camera
from app.view.painting.drawing import polygon_of
from app.view.painting.pictures import image_of
from starskel.arrays import Floats
from starskel.files.projects.picture import Picture

FAINT = 0.3
"""How much of what is cut off is seen while a cropped picture is placed."""


def paint_backdrop(
    painter: QPainter, camera: Camera, picture: Picture, rings: Sequence[Floats], *, faintly: bool
) -> None:
    """Paint a picture.

    Parameters
    ----------
    painter : QPainter
    camera : Camera
    picture : Picture
    rings : sequence of (n, 2) arrays
        The outlines of the shape and of its holes, on the screen.
    faintly : bool
        Whether what is cut off can be seen all the same, since the picture is being placed.
    """
    cropped = picture.cropped and len(rings) > 0
    if not cropped or faintly:
        _paint_whole(painter, camera, picture, picture.opacity * (FAINT if cropped else 1.0))
    if cropped:
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setClipPath(_inside(rings))
        _paint_whole(painter, camera, picture, picture.opacity)
        painter.restore()


def _paint_whole(painter: QPainter, camera: Camera, picture: Picture, opacity: float) -> None:
    corners = camera.to_screen(np.array([(0, 0, 1), (1, 0, 1), (0, 1, 1)]) @ picture.placement.T)
    right, down = corners[1] - corners[0], corners[2] - corners[0]
    image = image_of(picture.content, _halvings(picture.content, float(np.hypot(*right))))
    if image.isNull():
        return
    right, down = right / image.width(), down / image.height()
    painter.save()
    painter.setOpacity(opacity)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setTransform(QTransform(*right.tolist(), *down.tolist(), *corners[0].tolist()), combine=True)
    painter.drawImage(0, 0, image)
    painter.restore()


def _halvings(content: bytes, width: float) -> int:
    """Give how often a picture is to be halved before it is drawn so wide: Qt looks at four pixels only."""
    return max(0, int(log2(max(image_of(content).width(), 1) / max(width, 1.0))))


def _inside(rings: Sequence[Floats]) -> QPainterPath:
    """Give what lies in an odd number of rings: holes are no part of it."""
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for ring in rings:
        path.addPolygon(polygon_of(ring))
        path.closeSubpath()
    return path
