"""What stands at a shape: pins of marks, the place a part grows from, the way of the vertex pointed at."""

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor

from app.model.marks import end
from app.model.point import as_point
from app.view.canvas.painters.paint_context import PaintContext
from app.view.painting.drawing import pen
from app.view.painting.frame_layers import paint_way
from app.view.painting.pins import Pin, outward, paint_pins
from app.view.wording import words
from starskel.arrays import Floats

DIAMOND = (QPointF(0, -8), QPointF(8, 0), QPointF(0, 8), QPointF(-8, 0))


def paint_marks(context: PaintContext) -> list[QRectF]:
    """Paint the pins of all marks; give where their labels are."""
    ends = {index: end(mark, context.side) for index, mark in enumerate(context.document.marks)}
    if context.overlay.pin is not None:
        vertex, index = context.overlay.pin
        ends[index] = vertex
    return paint_pins(context.painter, [_pin(context, vertex, index) for index, vertex in ends.items()])


def _pin(context: PaintContext, vertex: int, index: int) -> Pin:
    colour = context.theme.pins[index % len(context.theme.pins)]
    return Pin(context.screen[vertex], away(context, vertex), words.mark(index), colour)


def away(context: PaintContext, vertex: int) -> Floats:
    """Give the direction out of the shape on the screen, where y runs down."""
    direction: Floats = outward(context.ring, vertex) * (1, -1)
    return direction


def paint_growth(context: PaintContext) -> None:
    """Show where the part worked on grows from or shrinks to, if it has no partner here."""
    document, results = context.document, context.session.blends.fresh
    if document.pair.ends == (None, None) or document.part(context.side) is not None:
        return
    place = document.pair.place
    if place is None and results:
        rings = results[0].rings_at(0.0 if context.side == "source" else 1.0)
        place = as_point(rings[document.link].mean(axis=0))
    if place is not None:
        middle = context.on_screen(place)
        context.painter.setPen(pen(context.theme.accent, 2.0))
        context.painter.setBrush(QColor(context.theme.base))
        context.painter.drawPolygon([middle + step for step in DIAMOND])
        context.painter.drawPoint(middle)
        context.painter.setPen(QColor(context.theme.text))
        context.painter.drawText(middle + QPointF(14, 4), words.growth(context.side))


def paint_trace(context: PaintContext) -> None:
    """Show the partner of the vertex pointed at, and the way from the one to the other."""
    matched, pointed = context.session.matched_vertex, context.session.pointed
    if matched is None or pointed is None:
        return
    way = context.session.blends.fresh[0].samples[context.document.link][:, matched.row]
    paint_way(context.painter, context.theme, context.camera.to_screen(way))
    context.painter.setPen(pen(context.theme.accent, 2.5))
    context.painter.setBrush(QColor(context.theme.base))
    place = context.on_screen(matched.place(context.side))
    if matched.vertex(context.side) is None:  # it has no vertex here: the correspondence inserts one
        context.painter.drawPolygon([place + step for step in DIAMOND])
    else:
        context.painter.drawEllipse(place, 7.5, 7.5)
