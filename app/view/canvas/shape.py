"""The shape on a canvas: its parts, the vertices of the one worked on, and what of them is selected."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor

from app.model.clipping import chosen_parts
from app.model.parts import stacked
from app.view.canvas.gesture import square
from app.view.canvas.stage import Stage
from app.view.painting.drawing import faded, pen, point_of, polygon_of
from app.view.painting.parts import paint_region, regions
from starskel.files.key_shape import Part

MANY = 30
"""Selected vertices are drawn smaller from so many on."""


def paint_shape(stage: Stage) -> None:
    """Paint the part worked on, and all parts where there are several."""
    document, worked_on = stage.document, stage.document.part(stage.side)
    parts = document.shape(stage.side).parts
    alone = len(parts) == (worked_on is not None)
    if not alone:
        _paint_parts(stage, parts, worked_on)
    if len(stage.screen):
        replaced = stage.replaced
        width = 1.0 if stage.crowded else 1.5  # wider, 2,000 smooth edges take a hundred times as long
        stage.painter.setPen(pen(faded(stage.colour, 0.35 if replaced else 1.0), width))
        stage.painter.setBrush(faded(stage.colour, (0.07 if replaced else 0.22) if alone else 0.0))
        stage.painter.drawPolygon(polygon_of(stage.screen), Qt.FillRule.WindingFill)


def _paint_parts(stage: Stage, parts: Sequence[Part], worked_on: int | None) -> None:
    """Paint all parts that are shown, and the outlines of those that are not worked on."""
    shape = stage.document.shape(stage.side).shape
    rings = [stage.camera.to_screen(part.ring.vertices) for part in parts]
    shown = [part.visible or number == worked_on for number, part in enumerate(parts)]
    if worked_on is not None:
        rings[worked_on] = stage.screen
    order = stacked(stage.document, stage.side)
    for outline, holes in sorted(regions(shape.outer, shown), key=lambda region: order.index(region[0])):
        colour = QColor(parts[outline].colour or stage.theme.side(stage.side))
        stage.painter.setPen(Qt.PenStyle.NoPen)
        stage.painter.setBrush(faded(colour, 0.22 if worked_on in (outline, *holes) else 0.13))
        paint_region(stage.painter, rings[outline], [rings[hole] for hole in holes])
    stage.painter.setBrush(Qt.BrushStyle.NoBrush)
    selection = stage.session.selection
    several = selection.side == stage.side and bool(selection.links)
    chosen = chosen_parts(stage.document, selection) if several else ()
    for number, ring in enumerate(rings):
        if shown[number] and number != worked_on:
            colour = QColor(parts[number].colour or stage.theme.side(stage.side))
            stage.painter.setPen(pen(faded(colour, 0.7), 1.0))
            if number in chosen:
                stage.painter.setPen(pen(stage.theme.accent, 2.5))
            stage.painter.drawPolygon(polygon_of(ring))


def paint_vertices(stage: Stage) -> None:
    """Paint the vertices of the part worked on that are in sight, the first one filled."""
    if not len(stage.screen) or stage.replaced or stage.crowded:
        return
    stage.painter.setPen(pen(stage.colour, 1.5))
    stage.painter.setBrush(QColor(stage.theme.base))
    low, high = (-3.0, -3.0), (stage.camera.width + 3, stage.camera.height + 3)
    shown = ((stage.screen >= low) & (stage.screen <= high)).all(axis=1)
    for place in stage.screen[shown]:
        stage.painter.drawRect(square(place, 2.5))
    stage.painter.setBrush(stage.colour)  # filled: where the vertices begin to count
    stage.painter.drawRect(square(stage.screen[0], 2.5))


def paint_selection(stage: Stage) -> None:
    """Show what is selected, and what a press would take; above the pins, which may stand there too."""
    selected = () if stage.replaced else stage.session.selection.on(stage.side)
    stage.painter.setPen(pen(stage.theme.base, 1.0))
    stage.painter.setBrush(QColor(stage.theme.accent))
    half = 4.5 if len(selected) < MANY else 3.0
    for vertex in selected:
        stage.painter.drawRect(square(stage.screen[vertex], half))
    stage.painter.setBrush(Qt.BrushStyle.NoBrush)
    stage.painter.setPen(pen(stage.theme.accent, 2.0))
    if stage.overlay.vertex is not None:
        stage.painter.drawEllipse(point_of(stage.screen[stage.overlay.vertex]), 7.5, 7.5)
    if stage.overlay.insertion is not None:
        place = stage.on_screen(stage.overlay.insertion)
        stage.painter.drawLine(place - QPointF(4, 0), place + QPointF(4, 0))
        stage.painter.drawLine(place - QPointF(0, 4), place + QPointF(0, 4))
