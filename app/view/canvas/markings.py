"""What stands at a shape: pins of marks, the place a part grows from, the way of the vertex pointed at."""

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor

from app.model.marks import end
from app.model.point import as_point
from app.view.canvas.stage import Stage
from app.view.painting.drawing import pen
from app.view.painting.frame_layers import paint_way
from app.view.painting.pins import Pin, outward, paint_pins
from app.view.wording import words
from starskel.arrays import Floats

DIAMOND = (QPointF(0, -8), QPointF(8, 0), QPointF(0, 8), QPointF(-8, 0))


def paint_marks(stage: Stage) -> list[QRectF]:
    """Paint the pins of all marks; give where their labels are."""
    ends = {index: end(mark, stage.side) for index, mark in enumerate(stage.document.marks)}
    if stage.overlay.pin is not None:
        vertex, index = stage.overlay.pin
        ends[index] = vertex
    return paint_pins(stage.painter, [_pin(stage, vertex, index) for index, vertex in ends.items()])


def _pin(stage: Stage, vertex: int, index: int) -> Pin:
    colour = stage.theme.pins[index % len(stage.theme.pins)]
    return Pin(stage.screen[vertex], away(stage, vertex), words.mark(index), colour)


def away(stage: Stage, vertex: int) -> Floats:
    """Give the direction out of the shape on the screen, where y runs down."""
    direction: Floats = outward(stage.ring, vertex) * (1, -1)
    return direction


def paint_growth(stage: Stage) -> None:
    """Show where the part worked on grows from or shrinks to, if it has no partner here."""
    document, results = stage.document, stage.session.blends.fresh
    if document.pair.ends == (None, None) or document.part(stage.side) is not None:
        return
    place = document.pair.place
    if place is None and results:
        rings = results[0].rings_at(0.0 if stage.side == "source" else 1.0)
        place = as_point(rings[document.link].mean(axis=0))
    if place is not None:
        middle = stage.on_screen(place)
        stage.painter.setPen(pen(stage.theme.accent, 2.0))
        stage.painter.setBrush(QColor(stage.theme.base))
        stage.painter.drawPolygon([middle + step for step in DIAMOND])
        stage.painter.drawPoint(middle)
        stage.painter.setPen(QColor(stage.theme.text))
        stage.painter.drawText(middle + QPointF(14, 4), words.growth(stage.side))


def paint_trace(stage: Stage) -> None:
    """Show the partner of the vertex pointed at, and the way from the one to the other."""
    matched, pointed = stage.session.matched_vertex, stage.session.pointed
    if matched is None or pointed is None:
        return
    way = stage.session.blends.fresh[0].samples[stage.document.link][:, matched.row]
    paint_way(stage.painter, stage.theme, stage.camera.to_screen(way))
    stage.painter.setPen(pen(stage.theme.accent, 2.5))
    stage.painter.setBrush(QColor(stage.theme.base))
    place = stage.on_screen(matched.place(stage.side))
    if matched.vertex(stage.side) is None:  # it has no vertex here: the correspondence inserts one
        stage.painter.drawPolygon([place + step for step in DIAMOND])
    else:
        stage.painter.drawEllipse(place, 7.5, 7.5)
