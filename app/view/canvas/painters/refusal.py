"""Why an edit was refused, at the place where it would have gone wrong."""

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor

from app.model.marks import end, mark_at
from app.view.canvas.painters.markings import away
from app.view.canvas.painters.notes import KeptClear, paint_notice
from app.view.canvas.painters.paint_context import PaintContext
from app.view.painting.drawing import pen, point_of
from app.view.painting.pins import Pin, cross_at, paint_pins
from app.view.wording import words


def paint_refusal(context: PaintContext, labels: list[QRectF]) -> None:
    """Mark what was refused and say why, away from the labels of pins."""
    refusal = context.session.refusal
    if refusal is None:
        return
    ends = {end(mark, context.side) for mark in refusal.marks}
    vertices = sorted(vertex for vertex in ends if vertex < len(context.screen))
    for vertex in vertices:
        _paint_refused_pin(context, vertex)
    if refusal.side != context.side and not refusal.marks:
        return
    red = QColor(context.theme.refused)
    context.painter.setPen(pen(red, 3.0))
    places = [context.on_screen(point) for segment in refusal.segments for point in segment]
    for start, stop in zip(places[::2], places[1::2], strict=True):
        context.painter.drawLine(start, stop)
    for place in refusal.places:
        places.append(context.on_screen(place))
        cross_at(context.painter, places[-1], red)
    places += [point_of(context.screen[vertex]) for vertex in vertices]
    reason = words.reason(refusal.error, context.document)
    clear = KeptClear(places, labels, context.screen)
    paint_notice(context.painter, context.theme, context.frame, reason, clear)


def _paint_refused_pin(context: PaintContext, vertex: int) -> None:
    """Ring the vertex in red; where the new mark has no pin yet, give it one without a number."""
    place = context.screen[vertex]
    context.painter.setBrush(Qt.BrushStyle.NoBrush)
    context.painter.setPen(pen(context.theme.refused, 3.0))
    context.painter.drawEllipse(point_of(place), 11.0, 11.0)
    begun = context.overlay.pin is not None and context.overlay.pin[0] == vertex
    if not begun and mark_at(context.document.marks, context.side, vertex) is None:
        paint_pins(context.painter, [Pin(place, away(context, vertex), "✕", context.theme.refused)])
