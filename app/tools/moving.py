"""Move, scale and turn what is selected, by dragging."""

from dataclasses import dataclass, replace
from math import atan2, degrees, radians, remainder, tau
from typing import ClassVar

from app.model import transforms
from app.model.marks import Side
from app.model.point import Point, as_point
from app.model.selection import Selection, at_places
from app.model.texts import QT_TRANSLATE_NOOP
from app.model.transforms import Box, box_of
from app.tools.handles import CORNERS, TURN
from app.tools.pick import distance
from app.tools.refusal import refused_ring
from app.tools.settings import Snapping
from app.tools.snapping import CATCH_REACH, STEP, caught, targets_for_moving
from app.tools.tool import Catch, Commit, Key, Overlay, Pointer, Response, Tool, ToolContext
from starskel.arrays import Floats
from starskel.errors import StarskelError

ARROWS: dict[str, Point] = {"left": (-1, 0), "right": (1, 0), "up": (0, 1), "down": (0, -1)}


@dataclass(frozen=True)
class Dragging(Tool):
    """Some vertices held.

    Attributes
    ----------
    idle : Tool
        The state that they were taken from.
    start : Pointer
        Where they were taken.
    vertex : int
        The one of them that is caught by what is near.
    vertices : frozenset of int
        All that move.
    click : Selection
        What is selected where the pointer is released without having moved.
    catch : Catch or None
        Where the vertex goes, None until the pointer moves.
    """

    idle: Tool
    start: Pointer
    vertex: int
    vertices: frozenset[int]
    click: Selection
    catch: Catch | None = None

    name: ClassVar[str] = "select"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Release to set the vertices here; Esc puts them back. Ctrl suspends snapping."
    )
    busy: ClassVar[bool] = True

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        if self.catch is None and distance(pointer.at, self.start.at) <= pointer.radius / 3:
            return Response(self)  # a shaky click is no drag
        state = replace(self, catch=self._caught(context, pointer))
        return Response(state, refusal=state._tried(context).refusal)

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        if self.catch is None:
            return Response(self.idle, selection=self.click)
        return self._tried(context)

    def key(self, context: ToolContext, key: Key) -> Response:
        return Response(self.cancel() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return self.idle

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.start.side or self.catch is None:
            return Overlay()
        return Overlay(ring=self._ring(context), vertex=self.vertex, catch=self.catch)

    def _held(self, context: ToolContext) -> Point:
        return as_point(context.document.vertices(self.start.side)[self.vertex])

    def _caught(self, context: ToolContext, pointer: Pointer) -> Catch:
        side, held = self.start.side, self._held(context)
        at = held[0] + pointer.at[0] - self.start.at[0], held[1] + pointer.at[1] - self.start.at[1]
        targets = targets_for_moving(context.document, side, self.vertices)
        if pointer.shift:
            targets = replace(targets, origins=(held,))
        return caught(replace(pointer, at=at), context.settings.snapping, targets)

    def _ring(self, context: ToolContext) -> Floats:
        assert self.catch is not None
        held = self._held(context)
        offset = self.catch.at[0] - held[0], self.catch.at[1] - held[1]
        return context.document.moved(self.start.side, self.vertices, offset)

    def _tried(self, context: ToolContext) -> Response:
        name = QT_TRANSLATE_NOOP("Step", "Move vertices")
        return placed(
            context, self.idle, Selection(self.start.side, self.vertices), self._ring(context), name
        )


@dataclass(frozen=True)
class Transforming(Tool):
    """A handle of the frame held.

    Attributes
    ----------
    idle : Tool
        The state that it was taken from.
    start : Pointer
        Where it was taken.
    handle : str
        Its name.
    vertices : frozenset of int
        What is scaled or turned.
    box : Box
        The box around them.
    pointer : Pointer
        Where it is now.
    """

    idle: Tool
    start: Pointer
    handle: str
    vertices: frozenset[int]
    box: Box
    pointer: Pointer

    name: ClassVar[str] = "select"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint", "Release to keep it so; Esc puts it back. Shift keeps the proportions, or steps of 15°."
    )
    busy: ClassVar[bool] = True

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        state = replace(self, pointer=pointer)
        return Response(state, refusal=state._tried(context).refusal)

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        return self._tried(context) if self.pointer != self.start else Response(self.idle)

    def key(self, context: ToolContext, key: Key) -> Response:
        return Response(self.cancel() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return self.idle

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.start.side:
            return Overlay()
        ring = self._ring(context)
        if self.handle == TURN:
            return Overlay(ring=ring, readout=(self.pointer.at, f"{degrees(self._angle(context)):.4g}°"))
        box, catch = box_of(ring[sorted(self.vertices)]), self._catch(context)
        width, height = box.size
        readout = (self.pointer.at, f"{width:.4g} × {height:.4g}")
        return Overlay(ring=ring, frame=box, catch=catch, readout=readout)

    def _tried(self, context: ToolContext) -> Response:
        turns = self.handle == TURN
        name = QT_TRANSLATE_NOOP("Step", "Turn") if turns else QT_TRANSLATE_NOOP("Step", "Scale")
        return placed(
            context, self.idle, Selection(self.start.side, self.vertices), self._ring(context), name
        )

    def _ring(self, context: ToolContext) -> Floats:
        ring = context.document.vertices(self.start.side).copy()
        rows = sorted(self.vertices)
        if self.handle == TURN:
            ring[rows] = transforms.turned(ring[rows], self.box.middle, self._angle(context))
        else:
            ring[rows] = transforms.scaled(ring[rows], self._fixed(), self._factors(context))
        return ring

    def _angle(self, context: ToolContext) -> float:
        return turned_by(self.start, self.pointer, self.box.middle, context.settings.snapping)

    def _fixed(self) -> Point:
        """Give the corner or the side that stays."""
        x, y = CORNERS[self.handle]
        return self.box.at(1 - x, 1 - y)

    def _catch(self, context: ToolContext) -> Catch:
        """Give where the corner or the side goes that is dragged."""
        x, y = self.box.at(*CORNERS[self.handle])
        at = x + self.pointer.at[0] - self.start.at[0], y + self.pointer.at[1] - self.start.at[1]
        targets = targets_for_moving(context.document, self.start.side, self.vertices)
        pointer = replace(self.pointer, at=at, shift=False)
        return caught(pointer, context.settings.snapping, replace(targets, lines=(), origins=()))

    def _factors(self, context: ToolContext) -> Point:
        corner, fixed = self.box.at(*CORNERS[self.handle]), self._fixed()
        catch = self._catch(context)
        ways = [(catch.at[k] - fixed[k], corner[k] - fixed[k]) for k in (0, 1)]
        x, y = (new / old if old else 1.0 for new, old in ways)  # a side's own direction stays as it is
        if not self.pointer.shift:
            return x, y
        if 0.5 in CORNERS[self.handle]:
            same = x if CORNERS[self.handle][1] == 0.5 else y
            return same, same
        larger = max(abs(x), abs(y))
        return (larger if x >= 0 else -larger), (larger if y >= 0 else -larger)


def turned_by(start: Pointer, pointer: Pointer, about: Point, snapping: Snapping, turn: float = 0.0) -> float:
    """Give the angle by which a drag turns what was turned by `turn`: multiples of 15 degrees catch both."""
    (x, y), here, there = about, pointer.at, start.at
    angle = turn + atan2(here[1] - y, here[0] - x) - atan2(there[1] - y, there[0] - x)
    even = STEP * round(angle / STEP)
    near = abs(angle - even) * distance(here, about) <= pointer.radius * CATCH_REACH
    caught_by = (snapping.angles and near and not pointer.free) or pointer.shift
    return remainder((even if caught_by else angle) - turn, tau)


def key_way(key: Key) -> Point:
    """Give how far an arrow key moves what is selected."""
    x, y = ARROWS[key.name]
    return x * key.step, y * key.step


def key_turn(key: Key) -> tuple[float, float]:
    """Give by which angle, in radians, or by which factor an arrow key turns or scales."""
    x, y = ARROWS[key.name]
    return -x * radians(15 if key.far else 1), (1.1 if key.far else 1.01) ** y


def placed(context: ToolContext, idle: Tool, selection: Selection, ring: Floats, name: str) -> Response:
    """Try to put the selected vertices where they are in a ring; they stay selected."""
    side = selection.side
    try:
        document = context.document.reform(side, ring)
    except StarskelError as error:
        return Response(idle, refusal=refused_ring(side, ring, error))
    # a shape that is turned inside out numbers its vertices anew
    return Response(idle, Commit(document, name), at_places(document, side, ring[sorted(selection.vertices)]))
