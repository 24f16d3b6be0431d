"""The frame around what is selected, and its handles."""

from app.model.point import Point
from app.model.transforms import Box
from app.tools.pick import distance
from app.tools.tool import Pointer

GAP = 14.0
"""Pixels between what is selected and its frame: the corners of a box are vertices, and stay free."""

STALK = 22.0
"""Pixels from the frame to the handle that turns."""

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


def handle_places(box: Box, pixel: float) -> dict[str, Point]:
    """Give where the handles of a box are, whose pixels have this size in document units."""
    frame = box.wider(GAP * pixel)
    places = {name: frame.at(x, y) for name, (x, y) in CORNERS.items()}
    x, y = frame.at(0.5, 1)
    return {**places, TURN: (x, y + STALK * pixel)}


def handle_at(box: Box, pointer: Pointer) -> str:
    """Give the handle under the pointer, "" where there is none."""
    places = handle_places(box, pointer.pixel)
    near = [name for name, place in places.items() if distance(place, pointer.at) <= pointer.radius]
    return min(near, key=lambda name: distance(places[name], pointer.at), default="")


def in_frame(box: Box, pointer: Pointer) -> bool:
    """Tell whether the pointer is in the frame."""
    return box.wider(GAP * pointer.pixel).contains(pointer.at)
