"""What may lie over or under a frame: ways through time, frames before and after, numbers."""

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter

from app.view.drawing import faded, pen, polygon_of
from app.view.theme import Theme
from starskel.predicates import Floats

GHOSTS = 9
"""So many frames of a blend are shown at once by onion skin, both ends included."""

WAYS = 80
"""At most so many vertices show their ways through time; of more, evenly chosen ones do."""


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
    painter.setPen(pen(faded(theme.muted, 0.8), 1.0))
    step = -(-samples.shape[1] // WAYS)
    for way in np.moveaxis(samples[:, ::step], 1, 0):
        painter.drawPolyline(polygon_of(way))


def paint_ghosts(painter: QPainter, theme: Theme, samples: Floats) -> None:
    """Paint the outlines of frames evenly spread over time, each in the colour of its moment."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for share in np.linspace(0, 1, GHOSTS).tolist():
        painter.setPen(pen(faded(theme.between(share), 0.55), 1.0))
        painter.drawPolygon(polygon_of(samples[round(share * (len(samples) - 1))]))


def paint_numbers(painter: QPainter, theme: Theme, places: Floats, numbers: list[str]) -> None:
    """Write numbers beside vertices on the screen; of those that would lie on another, the first is shown."""
    font = painter.font()
    font.setPointSizeF(8.0)
    painter.setFont(font)
    painter.setPen(QColor(theme.text))
    metrics = painter.fontMetrics()
    taken: set[tuple[int, int]] = set()
    width, height = metrics.horizontalAdvance("000") + 2, metrics.height()
    for (x, y), number in zip(places.tolist(), numbers, strict=True):
        cell = int(x // width), int(y // height)
        if number and cell not in taken:
            taken.add(cell)
            painter.drawText(QPointF(x + 5, y - 4), number)
