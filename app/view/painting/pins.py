"""Pins: the marks as numbered, lettered labels that stand off the outline."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from app.view.painting.drawing import pen, point_of
from starskel.arrays import Floats

STANDOFFS = (22.0, 40.0, 58.0)
"""Pixels from the vertex to the middle of its label; the farther ones are for labels that find no room."""

TURNS = (0.0, 0.7, -0.7, 1.4, -1.4)
"""Angles by which a label leaves its direction, in radians, where it finds no room."""

CAPTION = QRectF(6, 6, 170, 24)
"""Where the name of the canvas stands."""

HEIGHT = 18.0


@dataclass(frozen=True, eq=False)
class Pin:
    """A label to be tied to a vertex.

    Attributes
    ----------
    place : (2,) array
        The vertex on the screen.
    direction : (2,) array
        A unit vector on the screen, towards the label.
    text : str
        What the label says.
    colour : str
        Its ground; the writing is white.
    """

    place: Floats
    direction: Floats
    text: str
    colour: str


def outward(ring: Floats, vertex: int) -> Floats:
    """Give the direction out of a counter-clockwise ring at a vertex, as a unit vector."""
    before, here, after = (ring[(vertex + k) % len(ring)] for k in (-1, 0, 1))
    along = _unit(here - before) + _unit(after - here)
    if not np.hypot(*along) > 1e-6:  # a spike: straight ahead
        return _unit(here - before)
    return _unit(np.array([along[1], -along[0]]))


def paint_pins(painter: QPainter, pins: Sequence[Pin]) -> list[QRectF]:
    """Paint pins, their labels clear of each other as far as there is room; give where the labels are."""
    font = QFont(painter.font())
    font.setBold(True)
    font.setPointSizeF(9.0)
    painter.setFont(font)
    room = QRectF(painter.window()).adjusted(3, 3, -3, -3)
    boxes: list[QRectF] = []
    for pin in pins:
        width = QFontMetricsF(font).horizontalAdvance(pin.text) + 12
        boxes.append(free_box(pin, width, room, [CAPTION, *boxes]))
    for pin, box in zip(pins, boxes, strict=True):
        painter.setPen(pen(pin.colour, 2.0))
        painter.drawLine(point_of(pin.place), box.center())
        painter.setBrush(QColor("white"))
        painter.drawEllipse(point_of(pin.place), 4.0, 4.0)
    for pin, box in zip(pins, boxes, strict=True):
        painter.setPen(pen("white", 1.0))
        painter.setBrush(QColor(pin.colour))
        painter.drawRoundedRect(box, HEIGHT / 2, HEIGHT / 2)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, pin.text)
    return boxes


def cross_at(painter: QPainter, place: QPointF, colour: QColor, size: float = 6.0) -> None:
    """Paint a diagonal cross."""
    painter.setPen(pen(colour, 2.5))
    painter.drawLine(place + QPointF(-size, -size), place + QPointF(size, size))
    painter.drawLine(place + QPointF(-size, size), place + QPointF(size, -size))


def free_box(pin: Pin, width: float, room: QRectF, taken: Sequence[QRectF]) -> QRectF:
    """Give the first box that is in the room and on no other, or the nearest one where there is none."""
    boxes = [_box(pin, width, standoff, turn) for standoff, turn in product(STANDOFFS, TURNS)]
    free = (box for box in boxes if room.contains(box) and not any(box.intersects(other) for other in taken))
    return next(free, boxes[0])


def _box(pin: Pin, width: float, standoff: float, turn: float) -> QRectF:
    x, y = pin.direction
    towards = np.array([x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)])
    sideways = abs(towards[0]) * (width - HEIGHT) / 2
    middle = point_of(pin.place + towards * (standoff + sideways))
    return QRectF(middle.x() - width / 2, middle.y() - HEIGHT / 2, width, HEIGHT)


def _unit(vector: Floats) -> Floats:
    length = np.hypot(*vector)
    return vector / length if length > 0 else vector
