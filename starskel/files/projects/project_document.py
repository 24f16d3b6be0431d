"""What a project file of this version holds, entry by entry, under the names that it has there."""

from typing import Annotated

import msgspec

from starskel.correspondence.marks import Mark
from starskel.files.projects.key_shape import Colour
from starskel.files.projects.picture import Picture, Share
from starskel.files.shapes import Row

FORMAT = "starskel-project"
VERSION = 4

Duration = Annotated[float, msgspec.Meta(gt=0)]


class PartEntry(msgspec.Struct, frozen=True):
    """A polygon of a key shape: an outline, or a hole in one."""

    name: str
    colour: Colour
    visible: bool
    ring: list[Row]


class ShapeEntry(msgspec.Struct, frozen=True):
    """A key shape: its picture and its parts."""

    picture: Picture | None
    parts: list[PartEntry]


class LinkEntry(msgspec.Struct, frozen=True):
    """A part of the shape before and the part of the shape behind that it becomes; null for none."""

    source: int | None
    target: int | None
    place: Row | None
    root: Row | None
    marks: list[Mark]


class StepEntry(msgspec.Struct, frozen=True):
    """The way from one key shape to the next."""

    duration: Duration
    easing: tuple[tuple[Share, Share], tuple[Share, Share]]
    turns: int
    joined: bool
    links: list[LinkEntry]


class ProjectDocument(msgspec.Struct, frozen=True):
    """A project: key shapes, the steps between them, and the methods that are shown."""

    format: str
    version: int
    name: str
    shapes: list[ShapeEntry]
    steps: list[StepEntry]
    methods: list[str]
    description: str = ""
