"""Mark vertices that correspond."""

from dataclasses import dataclass, replace
from typing import ClassVar

from app.model.document import Document
from app.model.marks import Side, end, mark_at
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.pick import distance, vertex_at
from app.tools.tool import Commit, Key, Overlay, Pointer, Refusal, Response, Scene, Tool
from starskel.errors import InvalidMarks


@dataclass(frozen=True)
class MarkTool(Tool):
    """No mark begun."""

    side: Side = "source"
    vertex: int | None = None

    name: ClassVar[str] = "mark"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Click a vertex, then its partner on the other canvas. Click a pin to remove it, drag it to move it.",
    )

    def press(self, scene: Scene, pointer: Pointer) -> Response:
        vertex = vertex_at(scene.document, pointer)
        if vertex is None:
            return Response(self)
        index = mark_at(scene.document.marks, pointer.side, vertex)
        if index is not None:
            return Response(HoldingPin(pointer, index))
        return Response(MarkBegun(pointer.side, vertex))

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        return Response(MarkTool(pointer.side, vertex_at(scene.document, pointer)))

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        if side != self.side or (self.vertex or 0) >= len(scene.document.vertices(side)):
            return Overlay()
        return Overlay(vertex=self.vertex)


@dataclass(frozen=True)
class MarkBegun(Tool):
    """One vertex chosen; its partner on the other canvas is wanted."""

    side: Side
    vertex: int
    hover: tuple[Side, int | None] = ("source", None)

    name: ClassVar[str] = "mark"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Click the vertex that corresponds on the other canvas; Esc cancels."
    )
    busy: ClassVar[bool] = True

    def press(self, scene: Scene, pointer: Pointer) -> Response:
        vertex = vertex_at(scene.document, pointer)
        if vertex is None:
            return Response(self)
        if pointer.side == self.side:
            return MarkTool().press(scene, pointer)
        pair = (self.vertex, vertex) if self.side == "source" else (vertex, self.vertex)
        try:
            document = scene.document.mark(*pair)
        except InvalidMarks as error:
            return Response(self, refusal=Refusal(pointer.side, error, marks=(*error.marks, pair)))
        return Response(
            MarkTool(pointer.side, vertex), Commit(document, QT_TRANSLATE_NOOP("Step", "Set mark"))
        )

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        return Response(replace(self, hover=(pointer.side, vertex_at(scene.document, pointer))))

    def key(self, scene: Scene, key: Key) -> Response:
        return Response(MarkTool() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return MarkTool()

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        hovered = self.hover[1] if self.hover[0] == side else None
        number = len(scene.document.marks)
        return Overlay(vertex=hovered, pin=(self.vertex, number) if side == self.side else None)


@dataclass(frozen=True)
class HoldingPin(Tool):
    """A pin pressed: released at once it is removed, dragged to another vertex it moves there."""

    start: Pointer
    index: int
    dragged: bool = False
    vertex: int | None = None

    name: ClassVar[str] = "mark"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Release on another vertex to move the pin there; Esc puts it back."
    )
    busy: ClassVar[bool] = True

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        if not self.dragged and distance(pointer.at, self.start.at) <= pointer.radius:
            return Response(self)
        return Response(replace(self, dragged=True, vertex=vertex_at(scene.document, pointer)))

    def preview(self, scene: Scene, pointer: Pointer) -> Document | None:
        return super().preview(scene, pointer) if self.dragged else None

    def release(self, scene: Scene, pointer: Pointer) -> Response:
        side, document = self.start.side, scene.document
        if not self.dragged:
            return Response(
                MarkTool(side), Commit(document.unmark(self.index), QT_TRANSLATE_NOOP("Step", "Remove mark"))
            )
        if self.vertex is None or self.vertex == end(document.marks[self.index], side):
            return Response(MarkTool(side))
        try:
            moved = document.repin(self.index, side, self.vertex)
        except InvalidMarks as error:
            return Response(MarkTool(side), refusal=Refusal(side, error, marks=error.marks))
        return Response(MarkTool(side, self.vertex), Commit(moved, QT_TRANSLATE_NOOP("Step", "Move mark")))

    def cancel(self) -> Tool:
        return MarkTool(self.start.side)

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        if side != self.start.side or self.vertex is None:
            return Overlay()
        return Overlay(vertex=self.vertex, pin=(self.vertex, self.index))
