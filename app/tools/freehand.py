"""Draw a shape by hand; what the hand trembles is simplified away."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from app.model.marks import Side
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.adjust import Sketch, done
from app.tools.pick import distance
from app.tools.tool import Key, Overlay, Pointer, Response, Tool, ToolContext


@dataclass(frozen=True)
class FreehandTool(Tool):
    """Ready to draw by hand.

    Attributes
    ----------
    side, trail
        The last line, where no shape could be made of it: it is shown beside the reason.
    """

    side: Side = "source"
    trail: tuple[Point, ...] = ()

    name: ClassVar[str] = "freehand"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Press and draw the outline in one go; it closes itself. How closely it is followed is set above.",
    )

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        return Response(Sketching(pointer.side, (pointer.at,), pointer.pixel))

    def cancel(self) -> Tool:
        return FreehandTool()

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        return Overlay(trail=np.array(self.trail)) if side == self.side and self.trail else Overlay()


@dataclass(frozen=True)
class Sketching(Tool):
    """A line being drawn."""

    side: Side
    points: tuple[Point, ...]
    pixel: float

    name: ClassVar[str] = "freehand"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP("Hint", "Release to close the outline; Esc gives it up.")
    busy: ClassVar[bool] = True

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        if pointer.side != self.side or distance(self.points[-1], pointer.at) < self.pixel:
            return Response(self)
        return Response(replace(self, points=(*self.points, pointer.at)))

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        extent = np.ptp(np.array(self.points), axis=0).max()
        if len(self.points) < 3 or extent < pointer.radius:  # a click, or a dot
            return Response(FreehandTool())
        sketch = Sketch(self.side, self.points, self.pixel, FreehandTool())
        return done(sketch, context, FreehandTool(self.side, self.points))

    def key(self, context: ToolContext, key: Key) -> Response:
        return Response(self.cancel() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return FreehandTool()

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        return Overlay(trail=np.array(self.points)) if side == self.side else Overlay()
