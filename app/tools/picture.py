"""Place the picture behind a shape: drag it, or its corners."""

from dataclasses import dataclass, replace
from typing import ClassVar

from app.model.document import Document, Point
from app.model.marks import Side
from app.model.texts import QT_TRANSLATE_NOOP
from app.model.transforms import Box
from app.tools.pick import distance
from app.tools.tool import Commit, Key, Overlay, Pointer, Response, Scene, Tool
from starskel.files.picture import Picture

CORNERS: dict[str, Point] = {
    "south-west": (0, 0),
    "south-east": (1, 0),
    "north-east": (1, 1),
    "north-west": (0, 1),
}


@dataclass(frozen=True)
class PictureTool(Tool):
    """No picture held."""

    side: Side = "source"
    handle: str = ""

    name: ClassVar[str] = "picture"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Hint",
        "Drop a picture on a canvas to draw over it. Drag it or its corners to fit it, then lock it.",
    )

    def press(self, scene: Scene, pointer: Pointer) -> Response:
        picture = _free(scene.document, pointer.side)
        if picture is None:
            return Response(self)
        box = box_of_picture(picture)
        handle = _corner_at(box, pointer)
        if not handle and not box.contains(pointer.at):
            return Response(self)
        return Response(HoldingPicture(pointer, handle, picture, picture))

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        picture = _free(scene.document, pointer.side)
        handle = _corner_at(box_of_picture(picture), pointer) if picture is not None else ""
        return Response(PictureTool(pointer.side, handle))

    def key(self, scene: Scene, key: Key) -> Response:
        picture = _free(scene.document, scene.selection.side)
        if key.name not in ("delete", "backspace") or picture is None:
            return Response(self)
        return without_picture(scene, scene.selection.side)

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        picture = _free(scene.document, side)
        if picture is None:
            return Overlay()
        return Overlay(corners=box_of_picture(picture), handle=self.handle if side == self.side else "")


@dataclass(frozen=True)
class HoldingPicture(Tool):
    """A picture dragged, or one of its corners, about the opposite one."""

    start: Pointer
    handle: str
    picture: Picture
    placed: Picture

    name: ClassVar[str] = "picture"
    hint: ClassVar[str] = QT_TRANSLATE_NOOP("Hint", "Release to leave the picture here; Esc puts it back.")
    busy: ClassVar[bool] = True

    def move(self, scene: Scene, pointer: Pointer) -> Response:
        placed = self._scaled(pointer) if self.handle else self._moved(pointer)
        return Response(replace(self, placed=placed))

    def release(self, scene: Scene, pointer: Pointer) -> Response:
        side = self.start.side
        document = scene.document.put_picture(side, self.placed)
        return Response(PictureTool(side), Commit(document, QT_TRANSLATE_NOOP("Step", "Move picture")))

    def preview(self, scene: Scene, pointer: Pointer) -> Document | None:
        """Say that the blends stay as they are."""
        return None

    def cancel(self) -> Tool:
        return PictureTool(self.start.side)

    def overlay(self, scene: Scene, side: Side) -> Overlay:
        if side != self.start.side:
            return Overlay()
        return Overlay(picture=self.placed, corners=box_of_picture(self.placed), handle=self.handle)

    def _moved(self, pointer: Pointer) -> Picture:
        (x, y), at, start = self.picture.middle, pointer.at, self.start.at
        return replace(self.picture, middle=(x + at[0] - start[0], y + at[1] - start[1]))

    def _scaled(self, pointer: Pointer) -> Picture:
        """Scale by how far the pointer is from the opposite corner."""
        box, (x, y) = box_of_picture(self.picture), CORNERS[self.handle]
        fixed, corner = box.at(1 - x, 1 - y), box.at(x, y)
        factor = max(distance(fixed, pointer.at), 10 * pointer.pixel) / distance(fixed, corner)
        width, height = (length * factor for length in self.picture.size)
        middle = fixed[0] + (x - 0.5) * width, fixed[1] + (y - 0.5) * height
        return replace(self.picture, middle=middle, size=(width, height))


def with_picture(scene: Scene, side: Side, picture: Picture) -> Response:
    """Put a picture behind a shape, in hand to be placed."""
    commit = Commit(scene.document.put_picture(side, picture), QT_TRANSLATE_NOOP("Step", "Place picture"))
    return Response(PictureTool(side), commit)


def without_picture(scene: Scene, side: Side) -> Response:
    """Take the picture away from behind a shape."""
    commit = Commit(scene.document.put_picture(side, None), QT_TRANSLATE_NOOP("Step", "Remove picture"))
    return Response(PictureTool(side), commit)


def fade_picture(scene: Scene, side: Side, opacity: float) -> Response:
    """Show the picture more or less; changes in a row count as one step."""
    picture = scene.document.picture(side)
    if picture is None:
        return Response(PictureTool(side))
    document = scene.document.put_picture(side, replace(picture, opacity=opacity))
    name = QT_TRANSLATE_NOOP("Step", "Picture opacity")
    return Response(PictureTool(side), Commit(document, name, joins=("opacity", side)))


def lock_picture(scene: Scene, side: Side, *, locked: bool) -> Response:
    """Let the picture stay where it is, or be moved again."""
    picture = scene.document.picture(side)
    if picture is None:
        return Response(PictureTool(side))
    document = scene.document.put_picture(side, replace(picture, locked=locked))
    return Response(PictureTool(side), Commit(document, QT_TRANSLATE_NOOP("Step", "Lock picture")))


def box_of_picture(picture: Picture) -> Box:
    """Give the box that a picture fills."""
    (x, y), (width, height) = picture.middle, picture.size
    return Box((x - width / 2, y - height / 2), (x + width / 2, y + height / 2))


def _free(document: Document, side: Side) -> Picture | None:
    """Give the picture of a side where it may be moved."""
    picture = document.picture(side)
    return picture if picture is not None and not picture.locked else None


def corner_places(box: Box) -> dict[str, Point]:
    """Give where the handles of a picture are."""
    return {name: box.at(x, y) for name, (x, y) in CORNERS.items()}


def _corner_at(box: Box, pointer: Pointer) -> str:
    places = corner_places(box)
    near = [name for name, place in places.items() if distance(place, pointer.at) <= pointer.radius]
    return min(near, key=lambda name: distance(places[name], pointer.at), default="")
