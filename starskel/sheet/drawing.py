"""What a sheet is made of: a few kinds of marks on paper that every file format can draw.

All lengths are points (1/72 inch), x right and y up from the lower left corner of the sheet.
"""

from dataclasses import dataclass
from typing import Literal

from starskel.predicates import Floats

Colour = str
"""Red, green and blue as "#rrggbb"."""

Place = tuple[float, float]


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


@dataclass(frozen=True)
class Group:
    """What belongs together under a name, unique in its drawing."""

    name: str
    items: tuple["Item", ...]


Item = Area | Line | Disc | Label | Group


@dataclass(frozen=True)
class Drawing:
    """A sheet."""

    title: str
    width: float
    height: float
    items: tuple[Item, ...]
