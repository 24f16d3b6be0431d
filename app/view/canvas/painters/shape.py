"""The shape on a canvas: its parts, the vertices of the one worked on, and what of them is selected."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor

from app.model.clipping import chosen_parts
from app.model.parts import stacked
from app.view.canvas.painters.gesture import square
from app.view.canvas.painters.paint_context import PaintContext
from app.view.painting.drawing import faded, pen, point_of, ring_of
from app.view.painting.parts import paint_region, regions
from starskel.files.projects.key_shape import Part

MANY = 30
"""Selected vertices are drawn smaller from so many on."""


def paint_shape(context: PaintContext) -> None:
    """Paint the part worked on, and all parts where there are several."""
    document, worked_on = context.document, context.document.part(context.side)
    parts = document.shape(context.side).parts
    alone = len(parts) == (worked_on is not None)
    if not alone:
        _paint_parts(context, parts, worked_on)
    if len(context.screen):
        replaced = context.replaced
        width = 1.0 if context.crowded else 1.5  # wider, 2,000 smooth edges take a hundred times as long
        context.painter.setPen(pen(faded(context.colour, 0.35 if replaced else 1.0), width))
        context.painter.setBrush(faded(context.colour, (0.07 if replaced else 0.22) if alone else 0.0))
        context.painter.drawPolygon(ring_of(context.screen), Qt.FillRule.WindingFill)


def _paint_parts(context: PaintContext, parts: Sequence[Part], worked_on: int | None) -> None:
    """Paint all parts that are shown, and the outlines of those that are not worked on."""
    shape = context.document.shape(context.side).shape
    rings = [context.camera.to_screen(part.ring.vertices) for part in parts]
    shown = [part.visible or number == worked_on for number, part in enumerate(parts)]
    if worked_on is not None:
        rings[worked_on] = context.screen
    order = stacked(context.document, context.side)
    for outline, holes in sorted(regions(shape.outer, shown), key=lambda region: order.index(region[0])):
        colour = QColor(parts[outline].colour or context.theme.side(context.side))
        context.painter.setPen(Qt.PenStyle.NoPen)
        context.painter.setBrush(faded(colour, 0.22 if worked_on in (outline, *holes) else 0.13))
        paint_region(context.painter, rings[outline], [rings[hole] for hole in holes])
    context.painter.setBrush(Qt.BrushStyle.NoBrush)
    selection = context.session.selection
    several = selection.side == context.side and bool(selection.links)
    chosen = chosen_parts(context.document, selection) if several else ()
    for number, ring in enumerate(rings):
        if shown[number] and number != worked_on:
            colour = QColor(parts[number].colour or context.theme.side(context.side))
            context.painter.setPen(pen(faded(colour, 0.7), 1.0))
            if number in chosen:
                context.painter.setPen(pen(context.theme.accent, 2.5))
            context.painter.drawPolygon(ring_of(ring))


def paint_vertices(context: PaintContext) -> None:
    """Paint the vertices of the part worked on that are in sight, the first one filled."""
    if not len(context.screen) or context.replaced or context.crowded:
        return
    context.painter.setPen(pen(context.colour, 1.5))
    context.painter.setBrush(QColor(context.theme.base))
    low, high = (-3.0, -3.0), (context.camera.width + 3, context.camera.height + 3)
    shown = ((context.screen >= low) & (context.screen <= high)).all(axis=1)
    for place in context.screen[shown]:
        context.painter.drawRect(square(place, 2.5))
    context.painter.setBrush(context.colour)  # filled: where the vertices begin to count
    context.painter.drawRect(square(context.screen[0], 2.5))


def paint_selection(context: PaintContext) -> None:
    """Show what is selected, and what a press would take; above the pins, which may stand there too."""
    selected = () if context.replaced else context.session.selection.on(context.side)
    context.painter.setPen(pen(context.theme.base, 1.0))
    context.painter.setBrush(QColor(context.theme.accent))
    half = 4.5 if len(selected) < MANY else 3.0
    for vertex in selected:
        context.painter.drawRect(square(context.screen[vertex], half))
    context.painter.setBrush(Qt.BrushStyle.NoBrush)
    context.painter.setPen(pen(context.theme.accent, 2.0))
    if context.overlay.vertex is not None:
        context.painter.drawEllipse(point_of(context.screen[context.overlay.vertex]), 7.5, 7.5)
    if context.overlay.insertion is not None:
        place = context.on_screen(context.overlay.insertion)
        context.painter.drawLine(place - QPointF(4, 0), place + QPointF(4, 0))
        context.painter.drawLine(place - QPointF(0, 4), place + QPointF(0, 4))
