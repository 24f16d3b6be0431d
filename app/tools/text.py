"""Set a text in outlines."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from app.model.marks import Side
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.outcome import drawn_parts
from app.tools.settings import ToolSettings
from app.tools.snapping import begun_at
from app.tools.tool import Catch, Overlay, Pointer, Response, Tool, ToolContext
from starskel.arrays import Floats


@dataclass(frozen=True)
class TextTool(Tool):
    """The text follows the pointer; each letter is a part of the shape, and so are the holes in it."""

    side: Side = "source"
    catch: Catch | None = None

    name: ClassVar[str] = "text"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Type the text above, then click to set it in the place of the shape on the canvas.",
    )

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        rings = placed_letters(context.settings, begun_at(context, pointer).at)
        if not rings:
            return Response(self)
        return drawn_parts(context, pointer.side, rings, TextTool(), QT_TRANSLATE_NOOP("Step", "Set text"))

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        return Response(replace(self, side=pointer.side, catch=begun_at(context, pointer)))

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.side or self.catch is None:
            return Overlay()
        rings = placed_letters(context.settings, self.catch.at)
        return Overlay(figure=rings[0] if rings else None, beside=rings[1:], catch=self.catch)


def placed_letters(settings: ToolSettings, at: Point) -> tuple[Floats, ...]:
    """Give the outlines of the text in its size, the largest one first, and its middle at a place."""
    rings = [ring * settings.size for ring in settings.lettering.rings]
    if not rings:
        return ()
    middle = (rings[0].min(axis=0) + rings[0].max(axis=0)) / 2
    return tuple(ring - middle + np.array(at) for ring in rings)
