"""Select, move, insert and delete vertices."""

from dataclasses import dataclass, replace
from typing import ClassVar

from app.model import transforms
from app.model.clipping import cut
from app.model.marks import Side
from app.model.point import Point
from app.model.selection import Selection, everything
from app.model.texts import QT_TRANSLATE_NOOP
from app.model.transforms import Box, box_of
from app.tools.handles import handle_at, in_frame
from app.tools.moving import ARROWS, Dragging, Transforming, key_turn, key_way, placed
from app.tools.pick import distance, edge_at, inside, nearest_vertex, part_under, vertex_at, vertices_in
from app.tools.refusal import Refusal, refused_ring
from app.tools.tool import Commit, Key, Overlay, Pointer, Response, Tool, ToolContext
from starskel.arrays import Floats
from starskel.errors import StarskelError


@dataclass(frozen=True)
class SelectTool(Tool):
    """Nothing held; what lies under the pointer is shown."""

    side: Side = "source"
    vertex: int | None = None
    insertion: Point | None = None
    handle: str = ""

    name: ClassVar[str] = "select"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Drag vertices or edges, click the shape to select it whole, double-click an edge to insert. "
        "Shift adds; arrow keys move, with Alt they turn and scale.",
    )

    def reach(self, context: ToolContext, pointer: Pointer) -> int | None:
        """Give the part under the pointer, where nothing of the one worked on is nearer."""
        document, box = context.document, frame_of(context, pointer.side)
        on_handle = box is not None and not pointer.shift and bool(handle_at(box, pointer))
        if on_handle or len(document.shape(pointer.side)) == (document.part(pointer.side) is not None):
            return None
        if edge_at(document, pointer) is not None:
            return None
        part = part_under(document, pointer)
        return None if part == document.part(pointer.side) else part

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        side, idle = pointer.side, SelectTool(pointer.side)
        selected = context.selection.on(side)
        vertex = vertex_at(context.document, pointer)
        if vertex is not None:
            return self._take_vertex(context, pointer, vertex)
        box = frame_of(context, side)
        if box is not None and not pointer.shift:
            if handle := handle_at(box, pointer):
                return Response(Transforming(idle, pointer, handle, selected, box, pointer))
            if in_frame(box, pointer):
                return self._take_all(context, pointer, selected)
        edge = edge_at(context.document, pointer)
        if edge is not None and not pointer.shift:
            ends = frozenset([edge[0], (edge[0] + 1) % len(context.document.vertices(side))])
            return self._take(context, pointer, ends, Selection(side, ends))
        kept = context.selection if pointer.shift else Selection(side)
        return Response(RubberBand(pointer, pointer, kept), selection=kept)

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        vertex = vertex_at(context.document, pointer)
        box = frame_of(context, pointer.side)
        handle = handle_at(box, pointer) if box is not None and vertex is None else ""
        edge = None if vertex is not None or handle else edge_at(context.document, pointer)
        return Response(SelectTool(pointer.side, vertex, edge[1] if edge else None, handle))

    def double_press(self, context: ToolContext, pointer: Pointer) -> Response:
        edge = edge_at(context.document, pointer)
        if edge is None or vertex_at(context.document, pointer) is not None:
            return Response(self)
        start, place = edge
        try:
            document = context.document.insert(pointer.side, start, place)
        except StarskelError as error:
            return Response(self, refusal=Refusal(pointer.side, error, places=(place,)))
        selection = Selection(pointer.side, frozenset([start + 1]))
        return Response(
            SelectTool(pointer.side, start + 1),
            Commit(document, QT_TRANSLATE_NOOP("Step", "Insert vertex")),
            selection,
        )

    def key(self, context: ToolContext, key: Key) -> Response:
        if not context.selection:
            return Response(self)
        if key.name in ("delete", "backspace"):
            return self._delete(context)
        if key.name in ARROWS and key.alt:
            return self._transform(context, key)
        if key.name in ARROWS:
            return self._nudge(context, key_way(key))
        return Response(self)

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        frame = frame_of(context, side)
        if side != self.side or (self.vertex or 0) >= len(context.document.vertices(side)):
            return Overlay(frame=frame)
        return Overlay(vertex=self.vertex, insertion=self.insertion, frame=frame, handle=self.handle)

    def _take_vertex(self, context: ToolContext, pointer: Pointer, vertex: int) -> Response:
        if pointer.shift:
            return Response(self, selection=context.selection.toggle(pointer.side, vertex))
        alone = Selection(pointer.side, frozenset([vertex]))
        selected = context.selection.on(pointer.side)
        return self._take(context, pointer, selected if vertex in selected else alone.vertices, alone)

    def _take_all(self, context: ToolContext, pointer: Pointer, selected: frozenset[int]) -> Response:
        """Take what is in the frame; a click there selects the whole shape, or nothing beside it."""
        side = pointer.side
        on_it = inside(context.document, pointer) or edge_at(context.document, pointer) is not None
        click = everything(context.document, side) if on_it else Selection(side)
        return self._take(context, pointer, selected, click)

    @staticmethod
    def _take(context: ToolContext, pointer: Pointer, vertices: frozenset[int], click: Selection) -> Response:
        side = pointer.side
        vertex = nearest_vertex(context.document, pointer, vertices)
        state = Dragging(SelectTool(side), pointer, vertex, vertices, click)
        return Response(state, selection=Selection(side, vertices))

    def _nudge(self, context: ToolContext, offset: Point) -> Response:
        """Move the selection; nudges of the same vertices in a row are undone at once."""
        selection = context.selection
        ring = context.document.moved(selection.side, selection.vertices, offset)
        return self._joined(context, ring, QT_TRANSLATE_NOOP("Step", "Nudge vertices"))

    def _transform(self, context: ToolContext, key: Key) -> Response:
        """Turn by left and right, scale by up and down, about the middle of the selection."""
        side, rows = context.selection.side, sorted(context.selection.vertices)
        ring = context.document.vertices(side).copy()
        middle, (angle, factor) = box_of(ring[rows]).middle, key_turn(key)
        if angle:
            ring[rows] = transforms.turned(ring[rows], middle, angle)
            return self._joined(context, ring, QT_TRANSLATE_NOOP("Step", "Turn"))
        ring[rows] = transforms.scaled(ring[rows], middle, (factor, factor))
        return self._joined(context, ring, QT_TRANSLATE_NOOP("Step", "Scale"))

    @staticmethod
    def _joined(context: ToolContext, ring: Floats, name: str) -> Response:
        selection = context.selection
        response = placed(context, SelectTool(selection.side), selection, ring, name)
        if response.commit is None:
            return response
        return replace(response, commit=replace(response.commit, joins=(name, selection)))

    def _delete(self, context: ToolContext) -> Response:
        side, vertices = context.selection.side, context.selection.vertices
        if context.selection.links:
            gone = Commit(cut(context.document, context.selection), QT_TRANSLATE_NOOP("Step", "Delete parts"))
            return Response(SelectTool(side), gone, Selection(side))
        try:
            document = context.document.delete(side, vertices)
        except StarskelError as error:
            left = [v for v in range(len(context.document.vertices(side))) if v not in vertices]
            return Response(self, refusal=refused_ring(side, context.document.vertices(side)[left], error))
        return Response(
            SelectTool(side), Commit(document, QT_TRANSLATE_NOOP("Step", "Delete vertices")), Selection(side)
        )


@dataclass(frozen=True)
class RubberBand(Tool):
    """A box being drawn; the vertices in it join the selection."""

    start: Pointer
    end: Pointer
    kept: Selection

    name: ClassVar[str] = "select"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP("Hint", "Release to select the vertices in the box.")
    busy: ClassVar[bool] = True

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        within = vertices_in(context.document, pointer, self.start.at)
        return Response(replace(self, end=pointer), selection=self.kept.add(pointer.side, within))

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        side = self.start.side
        click = distance(self.start.at, self.end.at) <= pointer.radius / 3
        whole = click and not self.start.shift and inside(context.document, self.start)
        return Response(SelectTool(side), selection=everything(context.document, side) if whole else None)

    def cancel(self) -> Tool:
        return SelectTool(self.start.side)

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        return Overlay(box=(self.start.at, self.end.at)) if side == self.start.side else Overlay()


def frame_of(context: ToolContext, side: Side) -> Box | None:
    """Give the box around the selected vertices of a side, where there are at least two."""
    vertices = [v for v in context.selection.on(side) if v < len(context.document.vertices(side))]
    return box_of(context.document.vertices(side)[vertices]) if len(vertices) > 1 else None
