"""What a canvas shows, from the ground up."""

import numpy as np
from PySide6.QtGui import QColor, QPainter

from app.model import parts
from app.view.canvas.painters.backdrop import paint_backdrop
from app.view.canvas.painters.gesture import GesturePainter
from app.view.canvas.painters.markings import paint_growth, paint_marks, paint_trace
from app.view.canvas.painters.notes import (
    how_to_draw,
    paint_caption,
    paint_invitation,
    paint_line,
    paint_news,
)
from app.view.canvas.painters.paint_context import PaintContext
from app.view.canvas.painters.refusal import paint_refusal
from app.view.canvas.painters.shape import MANY, paint_selection, paint_shape, paint_vertices
from app.view.painting.display import Layers
from app.view.painting.drawing import faded, lines_of, pen, point_of
from app.view.painting.frame_layers import paint_numbers
from app.view.painting.structure import StructurePainter
from app.view.wording import words
from app.view.wording.counts import COUNTS

CLOSEST = 8.0
"""Lines of the grid are no nearer to each other than so many pixels."""


def paint_canvas(context: PaintContext, layers: Layers) -> None:
    """Paint everything, from the ground up."""
    context.painter.fillRect(context.frame, QColor(context.theme.base))
    _paint_backdrop(context)
    _paint_grid(context)
    context.painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint_shape(context)
    _paint_structure(context, layers)
    paint_vertices(context)
    if layers.numbers:
        _paint_numbers(context)
    labels = paint_marks(context)
    paint_growth(context)
    paint_trace(context)
    paint_selection(context)
    GesturePainter(context.painter, context.theme, context.camera, context.colour).paint(context.overlay)
    _paint_words(context)
    paint_refusal(context, labels)
    _paint_news(context)


def _paint_news(context: PaintContext) -> None:
    """Tell what the last edit brought with it."""
    news, clear = context.session.news, context.screen[:: len(context.screen) // MANY + 1]
    if news and context.side == context.session.selection.side:
        shape = [point_of(place) for place in clear]
        paint_news(context.painter, context.theme, context.frame, COUNTS.news(news), shape)


def _paint_backdrop(context: PaintContext) -> None:
    picture = context.overlay.picture or context.document.picture(context.side)
    if picture is None:
        return
    rings = [context.camera.to_screen(ring.vertices) for ring in context.document.shape(context.side).rings]
    if (part := context.document.part(context.side)) is not None:
        rings[part] = context.screen
    paint_backdrop(context.painter, context.camera, picture, rings, faintly=context.overlay.handles)


def _paint_grid(context: PaintContext) -> None:
    """Show the grid where it catches the pointer; where its lines would run together, every fifth."""
    snapping = context.session.settings.snapping
    if not snapping.grid:
        return
    spacing = snapping.spacing
    while spacing * context.camera.scale < CLOSEST:
        spacing *= 5
    (left, low), (right, top) = context.camera.seen.low, context.camera.seen.high
    across, upwards = (
        np.arange(np.ceil(a / spacing), b / spacing) * spacing for a, b in ((left, right), (low, top))
    )
    lines = [((x, low), (x, top)) for x in across] + [((left, y), (right, y)) for y in upwards]
    ends = context.camera.to_screen(np.array(lines).reshape(-1, 2, 2))
    context.painter.setPen(pen(faded(context.theme.edge, 0.6)))
    context.painter.drawLines(lines_of(ends[:, 0], ends[:, 1]))


def _paint_structure(context: PaintContext, layers: Layers) -> None:
    """Show how the shape is cut, where that is known of the shape as it is now."""
    if context.overlay.ring is None and not context.replaced:
        structure = StructurePainter(context.painter, context.theme, context.camera, layers)
        shown = [look.visible for look in parts.looks(context.document)]
        structure.paint_cut(context.session.blends.fresh, context.side, shown)


def _paint_numbers(context: PaintContext) -> None:
    numbers = [str(number) for number in range(len(context.screen))]
    paint_numbers(context.painter, context.theme, context.screen, numbers)


def _paint_words(context: PaintContext) -> None:
    document = context.document
    name = words.canvas(document, context.side)
    part, shape = document.part(context.side), document.shape(context.side)
    if len(shape) > 1 and part is not None:
        name = f"{name} \N{MIDDLE DOT} {words.part(shape.parts[part], part)}"
    paint_caption(context.painter, context.theme, context.side, name, len(context.ring))
    begun = context.replaced or context.overlay.trail is not None
    if shape.parts and document.pair.ends == (None, None) and not begun:
        paint_line(context.painter, context.theme, context.frame, words.new_part(context.side))
    elif shape.picture is not None and not shape.parts and not begun:  # words in the middle would hide it
        paint_line(context.painter, context.theme, context.frame, words.pictured())
    elif not shape.parts and not begun:
        how = how_to_draw(context.session.tool)
        heading = words.invitation(document, context.side)
        paint_invitation(context.painter, context.theme, context.frame, heading, how)
