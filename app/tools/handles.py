"""The frame around what is selected, and its handles."""

from collections.abc import Mapping, Sequence

from app.model.point import Point
from app.model.transforms import Box
from app.tools.pick import distance
from app.tools.tool import Pointer

GAP = 14.0
"""Pixels between what is selected and its frame: the corners of a box are vertices, and stay free."""

STALK = 22.0
"""Pixels from the frame to the handle that turns."""

SIGHT = 9.0
"""Pixels between the handle that turns and the edge of the view, at least."""

TURN = "turn"

CORNERS: dict[str, Point] = {
    "south-west": (0, 0),
    "south": (0.5, 0),
    "south-east": (1, 0),
    "east": (1, 0.5),
    "north-east": (1, 1),
    "north": (0.5, 1),
    "north-west": (0, 1),
    "west": (0, 0.5),
}
"""The handles that scale, at these parts of the frame's width and height."""


def handle_places(box: Box, pixel: float, view: Box | None = None) -> dict[str, Point]:
    """Give where the handles of a box are, whose pixels have this size in document units."""
    frame = box.wider(GAP * pixel)
    places = {name: frame.at(x, y) for name, (x, y) in CORNERS.items()}
    (x, low), (_, high), stalk = frame.at(0.5, 0), frame.at(0.5, 1), STALK * pixel
    stalks = (x, high + stalk), (x, low - stalk), (x, high - stalk)
    return {**places, TURN: turning_place(stalks, frame, pixel, view)}


def turning_place(stalks: Sequence[Point], frame: Box, pixel: float, view: Box | None) -> Point:
    """Give where the handle that turns is: at the first end of a stalk in sight, or near the first of all.

    Of a frame that is out of sight itself, or where nobody looks, it is at the first.
    """
    if view is None or not view.meets(frame):
        return stalks[0]
    seen = view.wider(-SIGHT * pixel)
    return next((place for place in stalks if seen.contains(place)), seen.nearest(stalks[0]))


def handle_at(box: Box, pointer: Pointer) -> str:
    """Give the handle of a box under the pointer, "" where there is none."""
    return nearest_handle(handle_places(box, pointer.pixel, pointer.view), pointer)


def nearest_handle(places: Mapping[str, Point], pointer: Pointer) -> str:
    """Give the handle under the pointer, "" where there is none."""
    near = [name for name, place in places.items() if distance(place, pointer.at) <= pointer.radius]
    return min(near, key=lambda name: distance(places[name], pointer.at), default="")


def in_frame(box: Box, pointer: Pointer) -> bool:
    """Tell whether the pointer is in the frame."""
    return box.wider(GAP * pointer.pixel).contains(pointer.at)
