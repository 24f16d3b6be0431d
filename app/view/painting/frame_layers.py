"""What may lie over or under a frame: ways through time, frames before and after, numbers."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter

from app.view.painting.drawing import faded, pen, polygon_of, ring_of
from app.view.painting.theme import Theme
from starskel.arrays import Floats

GHOSTS = 9
"""So many frames of a blend are shown at once by onion skin, both ends included."""

WAYS = 80
"""At most so many vertices show their ways through time; of more, evenly chosen ones do."""

MOST_NUMBERS = 120
"""So many numbers are written at most in one view."""


def paint_way(painter: QPainter, theme: Theme, way: Floats) -> None:
    """Paint the way of one vertex, with a dot at every tenth of the time."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(pen(theme.accent, 1.5))
    painter.drawPolyline(polygon_of(way))
    painter.setPen(pen(theme.accent, 4.0))
    painter.drawPoints(polygon_of(way[:: (len(way) - 1) // 10]))


def paint_ways(painter: QPainter, theme: Theme, samples: Floats) -> None:
    """Paint the ways of all vertices, or of evenly chosen ones, for samples of shape (k, n, 2)."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(pen(faded(theme.muted, 0.5), 1.0))
    step = -(-samples.shape[1] // WAYS)
    for way in np.moveaxis(samples[:, ::step], 1, 0):
        painter.drawPolyline(polygon_of(way))


def paint_ghosts(painter: QPainter, theme: Theme, samples: Floats) -> None:
    """Paint the outlines of frames evenly spread over time, each in the colour of its moment."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for share in np.linspace(0, 1, GHOSTS).tolist():
        painter.setPen(pen(faded(theme.between(share), 0.55), 1.0))
        painter.drawPolygon(ring_of(samples[round(share * (len(samples) - 1))]))


def paint_numbers(painter: QPainter, theme: Theme, ring: Floats, numbers: Sequence[str]) -> None:
    """Write numbers outside the vertices of a ring on the screen; those that find no room are left out."""
    if not len(ring):
        return
    font = painter.font()
    font.setPointSizeF(8.0)
    painter.setFont(font)
    painter.setPen(QColor(theme.text))
    height = painter.fontMetrics().height()
    taken: list[QRectF] = []
    for place, way, number in zip(ring, _outwards(ring), numbers, strict=True):
        width = painter.fontMetrics().horizontalAdvance(number)
        middle = place + way * (6 + np.array([width, height - 4]) / 2)
        box = QRectF(middle[0] - width / 2, middle[1] - height / 2, width, height)
        if number and len(taken) < MOST_NUMBERS and not any(box.intersects(other) for other in taken):
            taken.append(box)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, number)


def _outwards(ring: Floats) -> Floats:
    """Give for each vertex of a ring, which runs clockwise as y runs down, the way out of it."""
    along = np.roll(ring, -1, axis=0) - np.roll(ring, 1, axis=0)
    ways = np.stack([-along[:, 1], along[:, 0]], axis=1)
    return np.asarray(ways / np.maximum(np.hypot(*ways.T), 1e-9)[:, None])
