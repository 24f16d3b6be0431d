"""Project files of older versions: each is brought up to the next, until it is one of this version."""

from itertools import pairwise
from pathlib import Path

import msgspec

from starskel.correspondence.marks import Mark
from starskel.errors import InvalidFile, NewerFile, told
from starskel.files.documents import read_document
from starskel.files.projects.picture import Picture, Share
from starskel.files.projects.project_document import (
    VERSION,
    Duration,
    LinkEntry,
    PartEntry,
    ProjectDocument,
    ShapeEntry,
    StepEntry,
)
from starskel.files.shapes import Row


class _Header(msgspec.Struct, frozen=True):
    version: int = 0


class _First(msgspec.Struct, frozen=True):
    """Version 1: one step, from the source to the target."""

    format: str
    version: int
    name: str
    source: list[Row] | None
    target: list[Row] | None
    marks: list[Mark]
    methods: list[str]
    description: str = ""

    def updated(self) -> "_Second":
        shapes = [self.source, self.target]
        steps = [_SecondStep(1.0, self.marks)]
        return _Second(self.format, 2, self.name, shapes, steps, self.methods, self.description)


class _SecondStep(msgspec.Struct, frozen=True):
    """A step of version 2."""

    duration: Duration
    marks: list[Mark]


class _Second(msgspec.Struct, frozen=True):
    """Version 2: several steps, all even and unsteered."""

    format: str
    version: int
    name: str
    shapes: list[list[Row] | None]
    steps: list[_SecondStep]
    methods: list[str]
    description: str = ""
    pictures: list[Picture | None] = []

    def updated(self) -> "_Third":
        pictures = self.pictures or [None] * len(self.shapes)
        shapes = [
            ShapeEntry(picture, [] if rows is None else [PartEntry("", "", True, rows)])
            for rows, picture in zip(self.shapes, pictures, strict=True)
        ]
        steps = [
            _ThirdStep(step.duration, _EVEN, None, 0, True, _links(ends, step.marks))
            for ends, step in zip(pairwise(shapes), self.steps, strict=True)
        ]
        return _Third(self.format, 3, self.name, shapes, steps, self.methods, self.description)


class _ThirdLink(msgspec.Struct, frozen=True):
    """A link of version 3."""

    source: int | None
    target: int | None
    place: Row | None
    marks: list[Mark]


class _ThirdStep(msgspec.Struct, frozen=True):
    """A step of version 3."""

    duration: Duration
    easing: tuple[tuple[Share, Share], tuple[Share, Share]]
    root: Row | None
    turns: int
    joined: bool
    links: list[_ThirdLink]

    def updated(self) -> StepEntry:
        root = self.root if len(self.links) == 1 else None  # several parts had none
        links = [LinkEntry(link.source, link.target, link.place, root, link.marks) for link in self.links]
        return StepEntry(self.duration, self.easing, self.turns, self.joined, links)


class _Third(msgspec.Struct, frozen=True):
    """Version 3: one root for each step; pictures are upright and whole."""

    format: str
    version: int
    name: str
    shapes: list[ShapeEntry]
    steps: list[_ThirdStep]
    methods: list[str]
    description: str = ""

    def updated(self) -> ProjectDocument:
        steps = [step.updated() for step in self.steps]
        return ProjectDocument(self.format, 4, self.name, self.shapes, steps, self.methods, self.description)


_EVEN = ((1 / 3, 1 / 3), (2 / 3, 2 / 3))
_VERSIONS: tuple[type[_First] | type[_Second] | type[_Third] | type[ProjectDocument], ...] = (
    _First,
    _Second,
    _Third,
    ProjectDocument,
)


def read_up_to_date(path: Path) -> ProjectDocument:
    """Read a project file of any version as if it were of this one.

    Raises
    ------
    NewerFile
        If it is one of a newer version.
    InvalidFile
        If it cannot be read, is damaged, or has not as many steps as shapes need.
    """
    version = read_document(path, _Header).version
    if version > VERSION:
        raise NewerFile(
            told(
                "{path} is a project of version {version}; this program knows versions up to {newest}",
                path=path,
                version=version,
                newest=VERSION,
            ),
            told("open it with a newer starskel"),
        )
    if version < 1:
        raise InvalidFile(
            told("{path} is a project of version {version}", path=path, version=version),
            told("versions count from 1"),
        )
    document: _First | _Second | _Third | ProjectDocument = read_document(path, _VERSIONS[version - 1])
    if isinstance(document, _First):
        document = document.updated()
    _check_counts(path, document)
    while not isinstance(document, ProjectDocument):
        document = document.updated()
    return document


def _check_counts(path: Path, document: _Second | _Third | ProjectDocument) -> None:
    shapes, steps = len(document.shapes), len(document.steps)
    if shapes < 2 or steps != shapes - 1:
        raise InvalidFile(
            told("{path} has {shapes} shapes and {steps} steps", path=path, shapes=shapes, steps=steps),
            told("give two shapes at least, and a step from each to the next"),
        )
    pictures = len(document.pictures) if isinstance(document, _Second) else 0
    if pictures and pictures != shapes:
        raise InvalidFile(
            told(
                "{path} has {pictures} pictures for {shapes} shapes",
                path=path,
                pictures=pictures,
                shapes=shapes,
            ),
            told("give one for each shape, null where there is none"),
        )


def _links(ends: tuple[ShapeEntry, ShapeEntry], marks: list[Mark]) -> list[_ThirdLink]:
    """Give the links of shapes of at most one part."""
    source, target = (0 if shape.parts else None for shape in ends)
    return [] if source is target is None and not marks else [_ThirdLink(source, target, None, marks)]
