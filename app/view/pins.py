"""Pins: the marks as numbered, lettered labels that stand off the outline."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from app.view import words
from app.view.drawing import pen, point_of
from starskel.predicates import Floats

STANDOFF = 22.0
"""Pixels from the vertex to the middle of its label."""


def outward(ring: Floats, vertex: int) -> Floats:
    """Give the direction out of a counter-clockwise ring at a vertex, as a unit vector."""
    before, here, after = (ring[(vertex + k) % len(ring)] for k in (-1, 0, 1))
    along = _unit(here - before) + _unit(after - here)
    if not np.hypot(*along) > 1e-6:  # a spike: straight ahead
        return _unit(here - before)
    return _unit(np.array([along[1], -along[0]]))


def paint_pin(painter: QPainter, place: Floats, direction: Floats, index: int, colour: str) -> None:
    """Paint the label of a mark beside its vertex.

    Parameters
    ----------
    place : (2,) array
        The vertex on the screen.
    direction : (2,) array
        A unit vector on the screen, towards the label.
    index : int
        The mark's index; its label counts from 1 and a.
    """
    paint_label(painter, place, direction, words.mark(index), colour)


def paint_label(painter: QPainter, place: Floats, direction: Floats, text: str, colour: str) -> None:
    """Paint a label with white writing, tied to a place by a short line."""
    font = QFont(painter.font())
    font.setBold(True)
    font.setPointSizeF(9.0)
    painter.setFont(font)
    width = QFontMetricsF(font).horizontalAdvance(text) + 12
    middle = point_of(place + direction * (STANDOFF + abs(direction[0]) * (width / 2 - 9)))
    box = QRectF(middle.x() - width / 2, middle.y() - 9, width, 18)
    painter.setPen(pen(colour, 2.0))
    painter.drawLine(point_of(place), middle)
    painter.setBrush(QColor("white"))
    painter.drawEllipse(point_of(place), 4.0, 4.0)
    painter.setPen(pen("white", 1.0))
    painter.setBrush(QColor(colour))
    painter.drawRoundedRect(box, 9, 9)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


def cross_at(painter: QPainter, place: QPointF, colour: QColor, size: float = 6.0) -> None:
    """Paint a diagonal cross."""
    painter.setPen(pen(colour, 2.5))
    painter.drawLine(place + QPointF(-size, -size), place + QPointF(size, size))
    painter.drawLine(place + QPointF(-size, size), place + QPointF(size, -size))


def _unit(vector: Floats) -> Floats:
    length = np.hypot(*vector)
    return vector / length if length > 0 else vector
