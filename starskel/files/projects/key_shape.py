"""Key shape: the parts that are drawn at one moment, as a project holds them."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated

import msgspec

from starskel.files.projects.picture import Picture
from starskel.polygon import Polygon
from starskel.shapes.shape import Shape

Colour = Annotated[str, msgspec.Meta(pattern="^(#[0-9a-fA-F]{6})?$")]


@dataclass(frozen=True)
class Part:
    """A polygon of a key shape: an outline, or a hole in one.

    Attributes
    ----------
    ring : Polygon
    name : str
        What the user calls it; empty where nobody has named it.
    colour : str
        "#rrggbb", or empty for the usual one.
    visible : bool
        Whether it is shown.
    """

    ring: Polygon
    name: str = ""
    colour: str = ""
    visible: bool = True


@dataclass(frozen=True)
class KeyShape:
    """All that is drawn at one moment.

    Attributes
    ----------
    parts : tuple of Part
        In the order in which they were added; none where nothing has been drawn yet.
    picture : Picture or None
        What is behind it.

    Raises
    ------
    InvalidPolygon
        Where the parts form no shape, since holes of one of them meet.
    """

    parts: tuple[Part, ...] = ()
    picture: Picture | None = None

    @classmethod
    def of(cls, *rings: Polygon) -> "KeyShape":
        """Give a shape of these polygons."""
        return cls(tuple(map(Part, rings)))

    def __post_init__(self) -> None:
        if len(self.parts) > 1:
            self.shape  # noqa: B018 -- raises

    def __len__(self) -> int:
        return len(self.parts)

    @cached_property
    def rings(self) -> tuple[Polygon, ...]:
        """The polygons of the parts."""
        return tuple(part.ring for part in self.parts)

    @cached_property
    def shape(self) -> Shape:
        """The parts as a shape: those inside others are holes.

        Raises
        ------
        InvalidPolygon
            Where there is no part.
        """
        return Shape(self.rings)

    def put(self, number: int, part: Part) -> "KeyShape":
        """Replace a part, or add one behind the last."""
        return replace(self, parts=(*self.parts[:number], part, *self.parts[number + 1 :]))

    def without(self, number: int) -> "KeyShape":
        """Leave a part out."""
        return replace(self, parts=(*self.parts[:number], *self.parts[number + 1 :]))
