"""Draw a polygon click by click."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from app.model.marks import Side
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.outcome import drawn
from app.tools.pick import distance
from app.tools.refusal import Refusal, Segment
from app.tools.snapping import begun_at, caught, targets_for_drawing
from app.tools.tool import Catch, Key, Overlay, Pointer, Response, Tool, ToolContext
from starskel.arrays import Floats
from starskel.errors import InvalidPolygon, told
from starskel.predicates import folds_back, segments_meet


@dataclass(frozen=True)
class DrawTool(Tool):
    """Ready to begin a polygon."""

    side: Side = "source"
    catch: Catch | None = None

    name: ClassVar[str] = "draw"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Click to set the first vertex. The new shape takes the place of the one that is worked on."
    )

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        at = begun_at(context, pointer).at
        return Response(PolygonBegun(pointer.side, (at,), Catch(at)))

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        return Response(DrawTool(pointer.side, begun_at(context, pointer)))

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        return Overlay(catch=self.catch) if side == self.side else Overlay()


@dataclass(frozen=True)
class PolygonBegun(Tool):
    """A polygon begun.

    Attributes
    ----------
    side : {"source", "target"}
        The canvas.
    points : tuple of points
        The vertices set so far; their path does not touch itself.
    catch : Catch
        Where the next vertex would be.
    closes : bool
        Whether the pointer is on the first vertex.
    """

    side: Side
    points: tuple[Point, ...]
    catch: Catch
    closes: bool = False

    name: ClassVar[str] = "draw"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Click adds a vertex; the first vertex or Enter closes. Backspace takes one back, Esc cancels.",
    )
    busy: ClassVar[bool] = True

    @property
    def at(self) -> Point:
        """Where the next vertex would be."""
        return self.catch.at

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        if pointer.side != self.side:
            return Response(self)
        state = self._aimed(context, pointer)
        if state.closes:
            return state._close(context)
        if distance(self.points[-1], state.at) <= pointer.radius / 2:
            return Response(state)  # the second press of a double click is no new vertex
        refusal = state._refusal()
        if refusal is not None:
            return Response(state, refusal=refusal)
        return Response(replace(state, points=(*self.points, state.at)))

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        if pointer.side != self.side:
            return Response(self)
        state = self._aimed(context, pointer)
        return Response(state, refusal=state._refusal())

    def key(self, context: ToolContext, key: Key) -> Response:
        if key.name == "enter":
            return self._close(context)
        if key.name in ("backspace", "delete"):
            rest = self.points[:-1]
            return Response(replace(self, points=rest, closes=False) if rest else DrawTool())
        return Response(self)

    def cancel(self) -> Tool:
        return DrawTool()

    def finish(self, context: ToolContext) -> Response:
        """Close what is a polygon already: it can be undone, while a path given up would be lost."""
        return self._close(context) if len(self.points) >= 3 else Response(self.cancel())

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.side:
            return Overlay()
        return Overlay(path=(*self.points, self.at), closes=self.closes, catch=self.catch)

    def _aimed(self, context: ToolContext, pointer: Pointer) -> "PolygonBegun":
        """Follow the pointer, caught by the first vertex where that would close a polygon."""
        closes = len(self.points) >= 3 and distance(self.points[0], pointer.at) <= pointer.radius
        if closes:
            return replace(self, catch=Catch(self.points[0]), closes=True)
        targets = targets_for_drawing(context.document, self.side, self.points)
        return replace(self, catch=caught(pointer, context.settings.snapping, targets), closes=False)

    def _refusal(self) -> Refusal | None:
        path = np.array(self.points)
        crossed = crossed_edges(path[1:] if self.closes else path, self.at)
        if not crossed:
            return None
        first = crossed[0] + self.closes
        edges = (self._edge(first), (self.points[-1], self.at))
        error = InvalidPolygon(
            told("the new edge would cross or touch edge {edge}", edge=f"{first}-{first + 1}"),
            told("set the vertex elsewhere"),
            (first, first + 1, len(path) - 1, len(path)),
        )
        return Refusal(self.side, error, edges)

    def _edge(self, first: int) -> Segment:
        return self.points[first], self.points[first + 1]

    def _close(self, context: ToolContext) -> Response:
        ring = np.array(self.points)
        response = drawn(context, self.side, ring, DrawTool(), QT_TRANSLATE_NOOP("Step", "Draw shape"))
        return response if response.refusal is None else replace(response, tool=self)


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
