"""Draw a polygon click by click."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from app.model.document import Point
from app.model.marks import Side, other
from app.model.selection import Selection
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.pick import distance
from app.tools.select import SelectTool
from app.tools.tool import (
    Commit,
    Key,
    Overlay,
    Pointer,
    Refusal,
    Response,
    Scene,
    Segment,
    Tool,
    refused_ring,
)
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon
from starskel.predicates import Floats, folds_back, segments_meet


@dataclass(frozen=True)
class DrawTool(Tool):
    """Ready to begin a polygon."""

    name: ClassVar[str] = "draw"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Click to set the first vertex; the new shape replaces the one on its canvas."
    )

    def press(self, scene: Scene, pointer: Pointer) -> Response:
        return Response(Drawing(pointer.side, (pointer.at,), pointer.at))


@dataclass(frozen=True)
class Drawing(Tool):
    """A polygon begun.

    Attributes
    ----------
    side : {"source", "target"}
        The canvas.
    points : tuple of points
        The vertices set so far; their path does not touch itself.
    at : (float, float)
        Where the next vertex would be.
    closes : bool
        Whether the pointer is on the first vertex.
    """

    side: Side
    points: tuple[Point, ...]
    at: Point
    closes: bool = False

    name: ClassVar[str] = "draw"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Click adds a vertex; the first vertex or Enter closes. Backspace takes one back, Esc cancels.",
    )
    busy: ClassVar[bool] = True

    def press(self, scene: Scene, pointer: Pointer) -> Response:
        if pointer.side != self.side:
            return Response(self)
        state = self._aimed(pointer)
        if state.closes:
            return state._close(scene)
        if distance(self.points[-1], state.at) <= pointer.radius / 2:
            return Response(state)  # the second press of a double click is no new vertex
        refusal = state._refusal()
        if refusal is not None:
            return Response(state, refusal=refusal)
        return Response(replace(state, points=(*self.points, state.at)))

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        if pointer.side != self.side:
            return Response(self)
        state = self._aimed(pointer)
        return Response(state, refusal=state._refusal())

    def key(self, scene: Scene, key: Key) -> Response:
        if key.name == "enter":
            return self._close(scene)
        if key.name in ("backspace", "delete"):
            rest = self.points[:-1]
            return Response(replace(self, points=rest, closes=False) if rest else DrawTool())
        return Response(self)

    def cancel(self) -> Tool:
        return DrawTool()

    def finish(self, scene: Scene) -> Response:
        """Close what is a polygon already: it can be undone, while a path given up would be lost."""
        return self._close(scene) if len(self.points) >= 3 else Response(self.cancel())

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        if side != self.side:
            return Overlay()
        return Overlay(path=(*self.points, self.at), closes=self.closes)

    def _aimed(self, pointer: Pointer) -> "Drawing":
        """Follow the pointer, caught by the first vertex where that would close a polygon."""
        closes = len(self.points) >= 3 and distance(self.points[0], pointer.at) <= pointer.radius
        return replace(self, at=self.points[0] if closes else pointer.at, closes=closes)

    def _refusal(self) -> Refusal | None:
        path = np.array(self.points)
        crossed = crossed_edges(path[1:] if self.closes else path, self.at)
        if not crossed:
            return None
        first = crossed[0] + self.closes
        edges = (self._edge(first), (self.points[-1], self.at))
        error = InvalidPolygon(
            f"the new edge would cross or touch edge {first}-{first + 1}",
            "set the vertex elsewhere",
            (first, first + 1, len(path) - 1, len(path)),
        )
        return Refusal(self.side, error, edges)

    def _edge(self, first: int) -> Segment:
        return self.points[first], self.points[first + 1]

    def _close(self, scene: Scene) -> Response:
        ring = np.array(self.points)
        try:
            polygon = Polygon(ring)
        except InvalidPolygon as error:
            return Response(self, refusal=refused_ring(self.side, ring, error))
        commit = Commit(scene.document.draw(self.side, polygon), QT_TRANSLATE_NOOP("Step", "Draw shape"))
        # with both shapes there a stray click should not begin to replace one
        one_is_missing = scene.document.polygon(other(self.side)) is None
        return Response(DrawTool() if one_is_missing else SelectTool(), commit, Selection(self.side))


def crossed_edges(path: Floats, at: Point) -> list[int]:
    """Give the edges of an open path that a segment from its end to a point would cross or touch.

    Parameters
    ----------
    path : (k, 2) array
        The path, whose last point the segment starts at.
    at : (float, float)
        The end of the segment.

    Returns
    -------
    list of int
        Edge i runs from point i to the next.
    """
    last, new = path[-1], np.array(at)
    if len(path) < 2:
        return []
    starts, ends = path[:-2], path[1:-1]
    low, high = np.minimum(last, new), np.maximum(last, new)
    near = (np.minimum(starts, ends) <= high).all(axis=1) & (np.maximum(starts, ends) >= low).all(axis=1)
    near[near] = segments_meet(starts[near], ends[near], last, new)
    crossed: list[int] = np.flatnonzero(near).tolist()
    if bool(folds_back(path[-2], last, new)):
        crossed.append(len(path) - 2)
    return crossed
