"""Select, move, insert and delete vertices."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from app.model.document import Point
from app.model.marks import Side
from app.model.selection import Selection
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.pick import distance, edge_at, vertex_at, vertices_in
from app.tools.tool import Commit, Key, Overlay, Pointer, Refusal, Response, Scene, Tool, refused_ring
from starskel.errors import StarskelError

ARROWS: dict[str, Point] = {"left": (-1, 0), "right": (1, 0), "up": (0, 1), "down": (0, -1)}


@dataclass(frozen=True)
class SelectTool(Tool):
    """Nothing held; what lies under the pointer is shown."""

    side: Side = "source"
    vertex: int | None = None
    insertion: Point | None = None

    name: ClassVar[str] = "select"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Drag a vertex to move it; double-click an edge to insert one. "
        "Shift adds to the selection; Delete removes; arrow keys nudge.",
    )

    def press(self, scene: Scene, pointer: Pointer) -> Response:
        vertex = vertex_at(scene.document, pointer)
        if vertex is None:
            kept = scene.selection if pointer.shift else Selection(pointer.side)
            return Response(RubberBand(pointer, pointer, kept), selection=kept)
        if pointer.shift:
            return Response(self, selection=scene.selection.toggle(pointer.side, vertex))
        selected = scene.selection.on(pointer.side)
        if vertex not in selected:
            selected = frozenset([vertex])
        return Response(Dragging(pointer, vertex, selected), selection=Selection(pointer.side, selected))

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        vertex = vertex_at(scene.document, pointer)
        edge = None if vertex is not None else edge_at(scene.document, pointer)
        return Response(SelectTool(pointer.side, vertex, edge[1] if edge else None))

    def double_press(self, scene: Scene, pointer: Pointer) -> Response:
        edge = edge_at(scene.document, pointer)
        if edge is None or vertex_at(scene.document, pointer) is not None:
            return Response(self)
        start, place = edge
        try:
            document = scene.document.insert(pointer.side, start, place)
        except StarskelError as error:
            return Response(self, refusal=Refusal(pointer.side, error, place=place))
        selection = Selection(pointer.side, frozenset([start + 1]))
        return Response(
            SelectTool(pointer.side, start + 1),
            Commit(document, QT_TRANSLATE_NOOP("Step", "Insert vertex")),
            selection,
        )

    def key(self, scene: Scene, key: Key) -> Response:
        if not scene.selection:
            return Response(self)
        if key.name in ("delete", "backspace"):
            return self._delete(scene)
        if key.name in ARROWS:
            x, y = ARROWS[key.name]
            return self._nudge(scene, (x * key.step, y * key.step))
        return Response(self)

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        if side != self.side or (self.vertex or 0) >= len(scene.document.vertices(side)):
            return Overlay()
        return Overlay(vertex=self.vertex, insertion=self.insertion)

    @staticmethod
    def _nudge(scene: Scene, offset: Point) -> Response:
        """Move the selection; nudges of the same vertices in a row are undone at once."""
        side, vertices = scene.selection.side, scene.selection.vertices
        response = _move(scene, side, vertices, offset)
        if response.commit is None:
            return response
        name = QT_TRANSLATE_NOOP("Step", "Nudge vertices")
        commit = Commit(response.commit.document, name, joins=("nudge", side, vertices))
        return replace(response, commit=commit)

    def _delete(self, scene: Scene) -> Response:
        side, vertices = scene.selection.side, scene.selection.vertices
        try:
            document = scene.document.delete(side, vertices)
        except StarskelError as error:
            left = [v for v in range(len(scene.document.vertices(side))) if v not in vertices]
            return Response(self, refusal=refused_ring(side, scene.document.vertices(side)[left], error))
        return Response(
            SelectTool(side), Commit(document, QT_TRANSLATE_NOOP("Step", "Delete vertices")), Selection(side)
        )


@dataclass(frozen=True)
class Dragging(Tool):
    """Some vertices held, one of them under the pointer."""

    start: Pointer
    vertex: int
    vertices: frozenset[int]
    offset: Point | None = None

    name: ClassVar[str] = "select"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP("Hint", "Release to set the vertices here; Esc puts them back.")
    busy: ClassVar[bool] = True

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        if self.offset is None and distance(pointer.at, self.start.at) <= pointer.radius / 3:
            return Response(self)  # a shaky click is no drag
        offset = (pointer.at[0] - self.start.at[0], pointer.at[1] - self.start.at[1])
        tried = _move(scene, self.start.side, self.vertices, offset)
        return Response(replace(self, offset=offset), refusal=tried.refusal)

    def release(self, scene: Scene, pointer: Pointer) -> Response:
        if self.offset is None:
            only = Selection(self.start.side, frozenset([self.vertex]))
            return Response(SelectTool(self.start.side, self.vertex), selection=only)
        return _move(scene, self.start.side, self.vertices, self.offset)

    def key(self, scene: Scene, key: Key) -> Response:
        return Response(self.cancel() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return SelectTool(self.start.side)

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        if side != self.start.side or self.offset is None:
            return Overlay()
        return Overlay(ring=scene.document.moved(side, self.vertices, self.offset), vertex=self.vertex)


@dataclass(frozen=True)
class RubberBand(Tool):
    """A box being drawn; the vertices in it join the selection."""

    start: Pointer
    end: Pointer
    kept: Selection

    name: ClassVar[str] = "select"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP("Hint", "Release to select the vertices in the box.")
    busy: ClassVar[bool] = True

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        inside = vertices_in(scene.document, pointer, self.start.at)
        return Response(replace(self, end=pointer), selection=self.kept.add(pointer.side, inside))

    def release(self, scene: Scene, pointer: Pointer) -> Response:
        return Response(SelectTool(pointer.side))

    def cancel(self) -> Tool:
        return SelectTool(self.start.side)

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        return Overlay(box=(self.start.at, self.end.at)) if side == self.start.side else Overlay()


def _move(scene: Scene, side: Side, vertices: frozenset[int], offset: Point) -> Response:
    """Try to move vertices."""
    ring = scene.document.moved(side, vertices, offset)
    try:
        document = scene.document.move(side, vertices, offset)
    except StarskelError as error:
        return Response(SelectTool(side), refusal=refused_ring(side, ring, error))
    # a shape that is turned inside out numbers its vertices anew
    moved = (document.vertices(side)[:, None] == ring[sorted(vertices)]).all(axis=2).any(axis=1)
    selection = Selection(side, frozenset(np.flatnonzero(moved).tolist()))
    return Response(SelectTool(side), Commit(document, QT_TRANSLATE_NOOP("Step", "Move vertices")), selection)
