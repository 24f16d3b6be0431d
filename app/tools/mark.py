"""Mark vertices that correspond."""

from dataclasses import dataclass, replace
from typing import ClassVar

from app.model.document import Document
from app.model.marks import Side, end, mark_at
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.pick import distance, part_of_vertex_at, vertex_at
from app.tools.refusal import Refusal
from app.tools.tool import Commit, Key, Overlay, Pointer, Response, Tool, ToolContext
from starskel.errors import InvalidMarks


@dataclass(frozen=True)
class MarkTool(Tool):
    """No mark begun."""

    side: Side = "source"
    vertex: int | None = None

    name: ClassVar[str] = "mark"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Click a vertex, then its partner on the other canvas, or drag from one to the other. "
        "Click a pin to remove it, drag it to move it.",
    )

    def reach(self, context: ToolContext, pointer: Pointer) -> int | None:
        """Give the part whose vertex is under the pointer."""
        if vertex_at(context.document, pointer) is not None:
            return None
        return part_of_vertex_at(context.document, pointer)

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        vertex = vertex_at(context.document, pointer)
        if vertex is None:
            return Response(self)
        index = mark_at(context.document.marks, pointer.side, vertex)
        if index is not None:
            return Response(HoldingPin(pointer, index))
        return Response(MarkBegun(pointer.side, vertex))

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        return Response(MarkTool(pointer.side, vertex_at(context.document, pointer)))

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.side or (self.vertex or 0) >= len(context.document.vertices(side)):
            return Overlay()
        return Overlay(vertex=self.vertex)


@dataclass(frozen=True)
class MarkBegun(Tool):
    """One vertex chosen; its partner on the other canvas is wanted.

    Attributes
    ----------
    side : {"source", "target"}
        The canvas of the vertex.
    vertex : int
        The vertex.
    pointer : Pointer or None
        Where the pointer is, on either canvas.
    over : int or None
        The vertex under it.
    refusal : Refusal or None
        Why the partner last chosen cannot be one; shown until the pointer is on another vertex.
    """

    side: Side
    vertex: int
    pointer: Pointer | None = None
    over: int | None = None
    refusal: Refusal | None = None

    name: ClassVar[str] = "mark"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Click the vertex that corresponds on the other canvas, or drag there; Esc cancels."
    )
    busy: ClassVar[bool] = True

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        vertex = vertex_at(context.document, pointer)
        if vertex is None:
            return Response(self)
        if pointer.side == self.side:
            return MarkTool().press(context, pointer)
        return self._set(context, pointer, vertex)

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        there = pointer.across or pointer
        over = vertex_at(context.document, there)
        if over is None:
            return Response(replace(self, pointer=there, over=None), refusal=self.refusal)
        tried = self._set(context, there, over) if there.side != self.side else Response(self)
        return Response(replace(self, pointer=there, over=over, refusal=tried.refusal), refusal=tried.refusal)

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        """Set the mark where the vertex was dragged onto its partner; else a click is still to come."""
        vertex = vertex_at(context.document, pointer.across) if pointer.across is not None else None
        if pointer.across is None or vertex is None:
            return Response(self)
        return self._set(context, pointer.across, vertex)

    def key(self, context: ToolContext, key: Key) -> Response:
        return Response(MarkTool() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return MarkTool()

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        here = self.pointer is not None and self.pointer.side == side
        refused = self.refusal is not None  # its two ends are shown, and the line would cross what is said
        return Overlay(
            vertex=self.over if here else None,
            pin=(self.vertex, len(context.document.marks)) if side == self.side else None,
            line=self.pointer.at if self.pointer is not None and here and not refused else None,
        )

    def _set(self, context: ToolContext, pointer: Pointer, vertex: int) -> Response:
        pair = (self.vertex, vertex) if self.side == "source" else (vertex, self.vertex)
        try:
            document = context.document.mark(*pair)
        except InvalidMarks as error:
            refusal = Refusal(pointer.side, error, marks=(*error.marks, pair))
            return Response(replace(self, refusal=refusal), refusal=refusal)
        return Response(
            MarkTool(pointer.side, vertex), Commit(document, QT_TRANSLATE_NOOP("Step", "Set mark"))
        )


@dataclass(frozen=True)
class HoldingPin(Tool):
    """A pin pressed: released at once it is removed, dragged to another vertex it moves there.

    Dragged to the other canvas, it is the mark's end there that moves.

    Attributes
    ----------
    start : Pointer
        Where it was pressed.
    index : int
        The mark.
    dragged : bool
        Whether it has left the place.
    side, vertex : {"source", "target"} and int or None
        The canvas and the vertex that it is on now.
    """

    start: Pointer
    index: int
    dragged: bool = False
    side: Side = "source"
    vertex: int | None = None

    name: ClassVar[str] = "mark"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Release on another vertex to move the pin there; Esc puts it back."
    )
    busy: ClassVar[bool] = True

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        if not self.dragged and distance(pointer.at, self.start.at) <= pointer.radius:
            return Response(self)
        there = pointer.across or pointer
        held = replace(self, dragged=True, side=there.side, vertex=vertex_at(context.document, there))
        return Response(held, refusal=held._moved(context).refusal)

    def preview(self, context: ToolContext, pointer: Pointer) -> Document | None:
        return super().preview(context, pointer) if self.dragged else None

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        if self.dragged:
            return self._moved(context)
        removed = context.document.unmark(self.index)
        return Response(MarkTool(self.start.side), Commit(removed, QT_TRANSLATE_NOOP("Step", "Remove mark")))

    def cancel(self) -> Tool:
        return MarkTool(self.start.side)

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.side or self.vertex is None:
            return Overlay()
        return Overlay(vertex=self.vertex, pin=(self.vertex, self.index))

    def _moved(self, context: ToolContext) -> Response:
        marks = context.document.marks
        if self.vertex is None or self.vertex == end(marks[self.index], self.side):
            return Response(self.cancel())
        try:
            moved = context.document.repin(self.index, self.side, self.vertex)
        except InvalidMarks as error:
            return Response(self.cancel(), refusal=Refusal(self.side, error, marks=error.marks))
        tool = MarkTool(self.side, self.vertex)
        return Response(tool, Commit(moved, QT_TRANSLATE_NOOP("Step", "Move mark")))
