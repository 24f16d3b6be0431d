"""What a canvas shows, from the ground up."""

import numpy as np
from PySide6.QtGui import QColor, QPainter

from app.model import parts
from app.view.canvas.backdrop import paint_backdrop
from app.view.canvas.gesture import GesturePainter
from app.view.canvas.markings import paint_growth, paint_marks, paint_trace
from app.view.canvas.notes import how_to_draw, paint_caption, paint_invitation, paint_line, paint_news
from app.view.canvas.refusal import paint_refusal
from app.view.canvas.shape import MANY, paint_selection, paint_shape, paint_vertices
from app.view.canvas.stage import Stage
from app.view.painting.display import Layers
from app.view.painting.drawing import faded, lines_of, pen, point_of
from app.view.painting.frame_layers import paint_numbers
from app.view.painting.structure import StructurePainter
from app.view.wording import words
from app.view.wording.counts import COUNTS

CLOSEST = 8.0
"""Lines of the grid are no nearer to each other than so many pixels."""


def paint_canvas(stage: Stage, layers: Layers) -> None:
    """Paint everything, from the ground up."""
    stage.painter.fillRect(stage.frame, QColor(stage.theme.base))
    _paint_backdrop(stage)
    _paint_grid(stage)
    stage.painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint_shape(stage)
    _paint_structure(stage, layers)
    paint_vertices(stage)
    if layers.numbers:
        _paint_numbers(stage)
    labels = paint_marks(stage)
    paint_growth(stage)
    paint_trace(stage)
    paint_selection(stage)
    GesturePainter(stage.painter, stage.theme, stage.camera, stage.colour).paint(stage.overlay)
    _paint_words(stage)
    paint_refusal(stage, labels)
    _paint_news(stage)


def _paint_news(stage: Stage) -> None:
    """Tell what the last edit brought with it."""
    news, clear = stage.session.news, stage.screen[:: len(stage.screen) // MANY + 1]
    if news and stage.side == stage.session.selection.side:
        shape = [point_of(place) for place in clear]
        paint_news(stage.painter, stage.theme, stage.frame, COUNTS.news(news), shape)


def _paint_backdrop(stage: Stage) -> None:
    picture = stage.overlay.picture or stage.document.picture(stage.side)
    if picture is None:
        return
    rings = [stage.camera.to_screen(ring.vertices) for ring in stage.document.shape(stage.side).rings]
    if (part := stage.document.part(stage.side)) is not None:
        rings[part] = stage.screen
    paint_backdrop(stage.painter, stage.camera, picture, rings, faintly=stage.overlay.handles)


def _paint_grid(stage: Stage) -> None:
    """Show the grid where it catches the pointer; where its lines would run together, every fifth."""
    snapping = stage.session.settings.snapping
    if not snapping.grid:
        return
    spacing = snapping.spacing
    while spacing * stage.camera.scale < CLOSEST:
        spacing *= 5
    (left, low), (right, top) = stage.camera.seen.low, stage.camera.seen.high
    across, upwards = (
        np.arange(np.ceil(a / spacing), b / spacing) * spacing for a, b in ((left, right), (low, top))
    )
    lines = [((x, low), (x, top)) for x in across] + [((left, y), (right, y)) for y in upwards]
    ends = stage.camera.to_screen(np.array(lines).reshape(-1, 2, 2))
    stage.painter.setPen(pen(faded(stage.theme.edge, 0.6)))
    stage.painter.drawLines(lines_of(ends[:, 0], ends[:, 1]))


def _paint_structure(stage: Stage, layers: Layers) -> None:
    """Show how the shape is cut, where that is known of the shape as it is now."""
    if stage.overlay.ring is None and not stage.replaced:
        structure = StructurePainter(stage.painter, stage.theme, stage.camera, layers)
        shown = [look.visible for look in parts.looks(stage.document)]
        structure.paint_cut(stage.session.blends.fresh, stage.side, shown)


def _paint_numbers(stage: Stage) -> None:
    numbers = [str(number) for number in range(len(stage.screen))]
    paint_numbers(stage.painter, stage.theme, stage.screen, numbers)


def _paint_words(stage: Stage) -> None:
    document = stage.document
    name = words.canvas(document, stage.side)
    part, shape = document.part(stage.side), document.shape(stage.side)
    if len(shape) > 1 and part is not None:
        name = f"{name} \N{MIDDLE DOT} {words.part(shape.parts[part], part)}"
    paint_caption(stage.painter, stage.theme, stage.side, name, len(stage.ring))
    begun = stage.replaced or stage.overlay.trail is not None
    if shape.parts and document.pair.ends == (None, None) and not begun:
        paint_line(stage.painter, stage.theme, stage.frame, words.new_part(stage.side))
    elif not shape.parts and not begun:
        how = how_to_draw(stage.session.tool)
        heading = words.invitation(document, stage.side)
        paint_invitation(stage.painter, stage.theme, stage.frame, heading, how)
