"""What a sheet is made of: a few kinds of marks on paper that every file format can draw.

All lengths are points (1/72 inch), x right and y up from the lower left corner of the sheet.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from starskel.arrays import Floats
from starskel.images.placed import Pixels

Colour = str
"""Red, green and blue as "#rrggbb"."""

FINE = 4
"""Pixels for a point, 288 an inch, of pictures in formats that scale them."""

Place = tuple[float, float]


def channels(colour: Colour) -> tuple[int, int, int]:
    """Give red, green and blue, each from 0 to 255."""
    red, green, blue = bytes.fromhex(colour[1:])
    return red, green, blue


@dataclass(frozen=True)
class Stroke:
    """How a line is drawn."""

    colour: Colour
    width: float


@dataclass(frozen=True, eq=False)
class Area:
    """A closed ring, filled or outlined or both; by the non-zero rule, with holes by the even-odd rule."""

    ring: Floats
    fill: Colour | None = None
    stroke: Stroke | None = None
    holes: tuple[Floats, ...] = ()


@dataclass(frozen=True, eq=False)
class Line:
    """An open line through points."""

    points: Floats
    stroke: Stroke


@dataclass(frozen=True)
class Disc:
    """A round area."""

    centre: Place
    radius: float
    fill: Colour | None = None
    stroke: Stroke | None = None


@dataclass(frozen=True)
class Label:
    """One line of text in a sans-serif face; `place` is on its base line, where `anchor` says."""

    text: str
    place: Place
    size: float
    colour: Colour
    anchor: Literal["start", "middle", "end"] = "start"
    bold: bool = False


Painter = Callable[[Floats, tuple[int, int]], Pixels]
"""Gives what is seen in a box, its lower left and upper right corner as rows, in pixels across and down."""


@dataclass(frozen=True, eq=False)
class Image:
    """A picture, painted when it is known in how many pixels, in a box as `Painter` has it."""

    box: Floats
    paint: Painter

    @property
    def pixels(self) -> Pixels:
        """The picture for formats that scale it, with `FINE` pixels for a point."""
        width, height = np.ceil((self.box[1] - self.box[0]) * FINE).astype(int).tolist()
        return self.paint(self.box, (max(width, 1), max(height, 1)))


@dataclass(frozen=True)
class Group:
    """What belongs together under a name, unique in its drawing."""

    name: str
    items: tuple["Item", ...]


Item = Area | Line | Disc | Label | Image | Group


@dataclass(frozen=True)
class Drawing:
    """A sheet."""

    title: str
    width: float
    height: float
    items: tuple[Item, ...]
