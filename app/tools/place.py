"""Choose the point that a part without a partner grows from, or shrinks to."""

from dataclasses import dataclass
from typing import ClassVar

from app.model import parts
from app.model.marks import Side
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.select import SelectTool
from app.tools.tool import Commit, Overlay, Pointer, Response, Tool, ToolContext


@dataclass(frozen=True)
class PlaceTool(Tool):
    """The point follows the pointer until it is set."""

    side: Side = "source"
    at: Point | None = None

    name: ClassVar[str] = "place"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Click where the part without a partner grows from or shrinks to, on the canvas without it."
    )

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        if context.document.part(pointer.side) is not None:
            return Response(self)
        document = parts.place(context.document, pointer.at)
        return Response(
            SelectTool(pointer.side), Commit(document, QT_TRANSLATE_NOOP("Step", "Set place of growth"))
        )

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        free = context.document.part(pointer.side) is None
        return Response(PlaceTool(pointer.side, pointer.at if free else None))

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        return Overlay(insertion=self.at) if side == self.side else Overlay()
