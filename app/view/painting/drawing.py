"""Painting, and arrays of points as what Qt paints."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import shiboken6
from PySide6.QtCore import QLineF, QPointF, QSize, Qt
from PySide6.QtGui import QColor, QPaintDevice, QPainter, QPen, QPixmap, QPolygonF
from PySide6.QtWidgets import QWidget

from starskel.arrays import Floats

_Memory: Any = shiboken6.VoidPtr  # its type information knows only the form without a size

FEW = 200
"""So many vertices are painted as they are."""

CELL = 0.125
"""Pixels between which no eye tells two places apart, on screens of double density either."""


@contextmanager
def painting(device: QPaintDevice) -> Iterator[QPainter]:
    """Paint, and end it whatever happens: a painter left open crashes the program later."""
    painter = QPainter(device)
    try:
        yield painter
    finally:
        painter.end()


def layer_for(widget: QWidget) -> QPixmap:
    """Give a transparent image for the whole of a widget, sharp on its screen."""
    return layer_of(widget.size(), widget.devicePixelRatioF())


def layer_of(size: QSize, ratio: float) -> QPixmap:
    """Give a transparent image of this size, with so many pixels to each of the widget's."""
    layer = QPixmap(size * ratio)
    layer.setDevicePixelRatio(ratio)
    layer.fill(Qt.GlobalColor.transparent)
    return layer


def polygon_of(points: Floats) -> QPolygonF:
    """Give an (n, 2) array as a Qt polygon, by one copy into its buffer instead of n calls."""
    polygon = QPolygonF()
    if not len(points):
        return polygon
    polygon.resize(len(points))
    # data() is the address of the first point; a polygon keeps its points as pairs of doubles
    memory = _Memory(polygon.data(), 16 * len(points), True)
    np.frombuffer(memory, dtype=np.float64).reshape(-1, 2)[:] = points
    return polygon


def ring_of(points: Floats) -> QPolygonF:
    """Give a ring on the screen as a Qt polygon; of vertices in a row that no eye tells apart, the first.

    Of 100,000 vertices the screen shows some thousands, and the others would take seconds to paint.
    """
    if len(points) > FEW:
        cells = np.floor(points / CELL)
        points = points[np.append(True, (cells[1:] != cells[:-1]).any(axis=1))]
    return polygon_of(points)


def point_of(row: Floats) -> QPointF:
    """Give one row of an array as a Qt point."""
    return QPointF(float(row[0]), float(row[1]))


def lines_of(starts: Floats, ends: Floats) -> list[QLineF]:
    """Give segments as Qt lines."""
    return [QLineF(*a, *b) for a, b in zip(starts.tolist(), ends.tolist(), strict=True)]


def pen(colour: QColor | str, width: float = 1.0, style: Qt.PenStyle = Qt.PenStyle.SolidLine) -> QPen:
    """Give a round pen."""
    return QPen(QColor(colour), width, style, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin)


def faded(colour: QColor | str, alpha: float) -> QColor:
    """Give a colour that lets through what is behind it."""
    result = QColor(colour)
    result.setAlphaF(alpha)
    return result
