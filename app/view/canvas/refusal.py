"""Why an edit was refused, at the place where it would have gone wrong."""

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor

from app.model.marks import end, mark_at
from app.view.canvas.markings import away
from app.view.canvas.notes import KeptClear, paint_notice
from app.view.canvas.stage import Stage
from app.view.painting.drawing import pen, point_of
from app.view.painting.pins import Pin, cross_at, paint_pins
from app.view.wording import words


def paint_refusal(stage: Stage, labels: list[QRectF]) -> None:
    """Mark what was refused and say why, away from the labels of pins."""
    refusal = stage.session.refusal
    if refusal is None:
        return
    ends = {end(mark, stage.side) for mark in refusal.marks}
    vertices = sorted(vertex for vertex in ends if vertex < len(stage.screen))
    for vertex in vertices:
        _paint_refused_pin(stage, vertex)
    if refusal.side != stage.side and not refusal.marks:
        return
    red = QColor(stage.theme.refused)
    stage.painter.setPen(pen(red, 3.0))
    places = [stage.on_screen(point) for segment in refusal.segments for point in segment]
    for start, stop in zip(places[::2], places[1::2], strict=True):
        stage.painter.drawLine(start, stop)
    for place in refusal.places:
        places.append(stage.on_screen(place))
        cross_at(stage.painter, places[-1], red)
    places += [point_of(stage.screen[vertex]) for vertex in vertices]
    reason = words.reason(refusal.error, stage.document)
    clear = KeptClear(places, labels, stage.screen)
    paint_notice(stage.painter, stage.theme, stage.frame, reason, clear)


def _paint_refused_pin(stage: Stage, vertex: int) -> None:
    """Ring the vertex in red; where the new mark has no pin yet, give it one without a number."""
    place = stage.screen[vertex]
    stage.painter.setBrush(Qt.BrushStyle.NoBrush)
    stage.painter.setPen(pen(stage.theme.refused, 3.0))
    stage.painter.drawEllipse(point_of(place), 11.0, 11.0)
    begun = stage.overlay.pin is not None and stage.overlay.pin[0] == vertex
    if not begun and mark_at(stage.document.marks, stage.side, vertex) is None:
        paint_pins(stage.painter, [Pin(place, away(stage, vertex), "✕", stage.theme.refused)])
