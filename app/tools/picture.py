"""Place the picture behind a shape: drag it, its handles, or the one that turns it."""

from dataclasses import dataclass, replace
from math import degrees
from typing import ClassVar

from app.model import placing
from app.model.document import Document
from app.model.marks import Side
from app.model.point import Point
from app.model.selection import Selection
from app.model.texts import QT_TRANSLATE_NOOP
from app.model.transforms import Box, box_of
from app.tools.handles import CORNERS, STALK, TURN, nearest_handle, turning_place
from app.tools.moving import ARROWS, key_turn, key_way, turned_by
from app.tools.settings import Snapping
from app.tools.tool import Commit, Key, Overlay, Pointer, Response, Tool, ToolContext
from starskel.files.projects.picture import Picture

MOVE = QT_TRANSLATE_NOOP("Step", "Move picture")
SCALE = QT_TRANSLATE_NOOP("Step", "Scale picture")
TURNING = QT_TRANSLATE_NOOP("Step", "Turn picture")

SMALLEST = 10.0
"""Pixels that a dragged side of a picture keeps at least."""


@dataclass(frozen=True)
class PictureTool(Tool):
    """No picture held."""

    side: Side = "source"
    handle: str = ""

    name: ClassVar[str] = "picture"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Drag the picture, its corners or sides to fit it, or the round handle to turn it. "
        "Arrow keys move it, with Alt they turn and scale.",
    )

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        picture = free_picture(context.document, pointer.side)
        if picture is None:
            return Response(self)
        handle = _handle_at(picture, pointer)
        if not handle and not placing.holds(picture, pointer.at):
            return Response(self)
        return Response(HoldingPicture(pointer, handle, picture, picture))

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        picture = free_picture(context.document, pointer.side)
        handle = _handle_at(picture, pointer) if picture is not None else ""
        return Response(PictureTool(pointer.side, handle))

    def key(self, context: ToolContext, key: Key) -> Response:
        side = context.selection.side
        picture = free_picture(context.document, side)
        if picture is None:
            return Response(self)
        if key.name in ("delete", "backspace"):
            return put_picture(context, side, None, QT_TRANSLATE_NOOP("Step", "Remove picture"))
        return self._by_key(context, picture, key)

    def _by_key(self, context: ToolContext, picture: Picture, key: Key) -> Response:
        """Move, turn or scale; the same in a row counts as one step."""
        side = context.selection.side
        if key.name not in ARROWS:
            return Response(self)
        if not key.alt:
            moved = placing.moved(picture, key_way(key))
            return put_picture(context, side, moved, MOVE, joined=True)
        angle, factor = key_turn(key)
        if angle:
            return put_picture(context, side, placing.turned(picture, angle), TURNING, joined=True)
        return put_picture(context, side, placing.scaled(picture, (factor, factor)), SCALE, joined=True)

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        picture = free_picture(context.document, side)
        if picture is None:
            return Overlay()
        return Overlay(picture=picture, handles=True, handle=self.handle if side == self.side else "")


@dataclass(frozen=True)
class HoldingPicture(Tool):
    """A picture dragged, or one of its handles."""

    start: Pointer
    handle: str
    picture: Picture
    placed: Picture

    name: ClassVar[str] = "picture"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Release to leave the picture here; Esc puts it back. Shift frees the proportions, or steps by 15°.",
    )
    busy: ClassVar[bool] = True

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        return Response(replace(self, placed=self._placed(context.settings.snapping, pointer)))

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        side = self.start.side
        name = MOVE if not self.handle else TURNING if self.handle == TURN else SCALE
        return put_picture(context, side, self.placed, name)

    def preview(self, context: ToolContext, pointer: Pointer) -> Document | None:
        """Say that the blends stay as they are."""
        return None

    def key(self, context: ToolContext, key: Key) -> Response:
        return Response(self.cancel() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return PictureTool(self.start.side)

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.start.side:
            return Overlay()
        readout = (placing.place_on(self.placed, 0.5, 0), self._figures()) if self.handle else None
        return Overlay(picture=self.placed, handles=True, handle=self.handle, readout=readout)

    def _figures(self) -> str:
        if self.handle == TURN:
            return f"{degrees(self.placed.rotation):.4g}°"
        width, height = self.placed.size
        return f"{width:.4g} × {height:.4g}"

    def _placed(self, snapping: Snapping, pointer: Pointer) -> Picture:
        picture, at, start = self.picture, pointer.at, self.start.at
        if self.handle == TURN:
            angle = turned_by(self.start, pointer, picture.middle, snapping, picture.rotation)
            return placing.turned(picture, angle)
        offset = at[0] - start[0], at[1] - start[1]
        if not self.handle:
            return placing.moved(picture, offset)
        shares = CORNERS[self.handle]
        x, y = placing.place_on(picture, *shares)
        to = x + offset[0], y + offset[1]
        return placing.stretched(picture, shares, to, SMALLEST * pointer.pixel, free=pointer.shift)


def put_picture(
    context: ToolContext, side: Side, picture: Picture | None, name: str, *, joined: bool = False
) -> Response:
    """Put a picture behind a shape, or take it away; joined, edits of that name in a row are one step."""
    commit = Commit(context.document.put_picture(side, picture), name, (name, side) if joined else None)
    there = None if context.selection.side == side else Selection(side)  # the one worked on from now on
    return Response(PictureTool(side), commit, there)


def free_picture(document: Document, side: Side) -> Picture | None:
    """Give the picture of a side where it may be moved."""
    picture = document.picture(side)
    return picture if picture is not None and not picture.locked else None


def picture_handles(picture: Picture, pixel: float, view: Box | None = None) -> dict[str, Point]:
    """Give where the handles of a picture are, where a pixel has this size in document units."""
    places = {name: placing.place_on(picture, x, y) for name, (x, y) in CORNERS.items()}
    stalk = STALK * pixel / picture.size[1]
    stalks = [placing.place_on(picture, 0.5, y) for y in (1 + stalk, -stalk, 1 - stalk)]
    return {**places, TURN: turning_place(stalks, box_of(placing.corners_of(picture)), pixel, view)}


def _handle_at(picture: Picture, pointer: Pointer) -> str:
    return nearest_handle(picture_handles(picture, pointer.pixel, pointer.view), pointer)
