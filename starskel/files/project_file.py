"""Project files: what the editor has open, format starskel-project."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any

import msgspec

from starskel.blending import METHODS
from starskel.correspondence.marks import Mark
from starskel.easing import Easing
from starskel.errors import InvalidFile, InvalidMarks, InvalidPolygon, told
from starskel.files.documents import check_format, read_document, write_document
from starskel.files.key_shape import Colour, KeyShape, Part
from starskel.files.picture import Picture, Share
from starskel.files.project import Project, letter
from starskel.files.shapes import Row, as_given, polygon_of, rows_of
from starskel.files.step import Link, Step
from starskel.limits import DOCUMENT_RINGS, Tally

FORMAT = "starskel-project"
VERSION = 4


class _Header(msgspec.Struct, frozen=True):
    version: int = 0


Duration = Annotated[float, msgspec.Meta(gt=0)]


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
            _Shape(picture, [] if rows is None else [_Part("", "", True, rows)])
            for rows, picture in zip(self.shapes, pictures, strict=True)
        ]
        steps = [
            _ThirdStep(step.duration, _EVEN, None, 0, True, _links(ends, step.marks))
            for ends, step in zip(pairwise(shapes), self.steps, strict=True)
        ]
        return _Third(self.format, 3, self.name, shapes, steps, self.methods, self.description)


class _Part(msgspec.Struct, frozen=True):
    name: str
    colour: Colour
    visible: bool
    ring: list[Row]


class _Shape(msgspec.Struct, frozen=True):
    picture: Picture | None
    parts: list[_Part]


class _ThirdLink(msgspec.Struct, frozen=True):
    source: int | None
    target: int | None
    place: Row | None
    marks: list[Mark]


class _ThirdStep(msgspec.Struct, frozen=True):
    duration: Duration
    easing: tuple[tuple[Share, Share], tuple[Share, Share]]
    root: Row | None
    turns: int
    joined: bool
    links: list[_ThirdLink]

    def updated(self) -> "_Step":
        root = self.root if len(self.links) == 1 else None  # several parts had none
        links = [_Link(link.source, link.target, link.place, root, link.marks) for link in self.links]
        return _Step(self.duration, self.easing, self.turns, self.joined, links)


class _Third(msgspec.Struct, frozen=True):
    """Version 3: one root for each step; pictures are upright and whole."""

    format: str
    version: int
    name: str
    shapes: list[_Shape]
    steps: list[_ThirdStep]
    methods: list[str]
    description: str = ""

    def updated(self) -> "_Document":
        steps = [step.updated() for step in self.steps]
        return _Document(self.format, 4, self.name, self.shapes, steps, self.methods, self.description)


class _Link(msgspec.Struct, frozen=True):
    source: int | None
    target: int | None
    place: Row | None
    root: Row | None
    marks: list[Mark]


class _Step(msgspec.Struct, frozen=True):
    duration: Duration
    easing: tuple[tuple[Share, Share], tuple[Share, Share]]
    turns: int
    joined: bool
    links: list[_Link]


class _Document(msgspec.Struct, frozen=True):
    format: str
    version: int
    name: str
    shapes: list[_Shape]
    steps: list[_Step]
    methods: list[str]
    description: str = ""


_EVEN = ((1 / 3, 1 / 3), (2 / 3, 2 / 3))
_VERSIONS: tuple[type[_First] | type[_Second] | type[_Third] | type[_Document], ...] = (
    _First,
    _Second,
    _Third,
    _Document,
)


def project_schema() -> dict[str, Any]:
    """Give the JSON schema of project files of this version; `resources/project.schema.json` holds it."""
    about = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"{FORMAT}, version {VERSION}",
    }
    return about | msgspec.json.schema(_Document)


def read_project(path: Path) -> Project:
    """Read a project file of this or an older version.

    Raises
    ------
    InvalidFile
        If it cannot be read, is damaged, is no project, is one of a newer version, or holds invalid things.
    """
    check_format(path, FORMAT)
    document, tally = _read(path), Tally(str(path))
    tally.add(told("rings"), sum(len(shape.parts) for shape in document.shapes), DOCUMENT_RINGS)
    shapes = tuple(
        _shape(shape, told("{path}: shape {letter}", path=path, letter=letter(number)), tally)
        for number, shape in enumerate(document.shapes)
    )
    steps = tuple(
        _step(step, ends, told("{path}: step {first}-{last}", path=path, first=letter(k), last=letter(k + 1)))
        for k, (step, ends) in enumerate(zip(document.steps, pairwise(shapes), strict=True))
    )
    # the polygons as if they had been given counter-clockwise, as their marks are
    own = tuple(
        replace(shape, parts=tuple(replace(part, ring=as_given(part.ring)) for part in shape.parts))
        for shape in shapes
    )
    return Project(document.name, own, steps, _methods(path, document.methods), document.description)


def write_project(path: Path, project: Project) -> None:
    """Write a project file, whole or not at all.

    Raises
    ------
    InvalidFile
        If it cannot be written; an old file stays as it was.
    """
    write_document(path, project_content(project))


def project_content(project: Project) -> dict[str, Any]:
    """Give what a project file holds, by the names that it has there."""
    shapes = [
        _Shape(shape.picture, [_Part(p.name, p.colour, p.visible, rows_of(p.ring)) for p in shape.parts])
        for shape in project.shapes
    ]
    steps = [
        _Step(
            step.duration,
            (step.easing.first, step.easing.second),
            step.turns,
            step.joined,
            [_Link(link.source, link.target, link.place, link.root, list(link.marks)) for link in step.links],
        )
        for step in project.steps
    ]
    methods = list(project.methods)
    document = _Document(FORMAT, VERSION, project.name, shapes, steps, methods, project.description)
    return msgspec.structs.asdict(document)


def _read(path: Path) -> _Document:
    version = read_document(path, _Header).version
    if version > VERSION:
        raise InvalidFile(
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
    document: _First | _Second | _Third | _Document = read_document(path, _VERSIONS[version - 1])
    if isinstance(document, _First):
        document = document.updated()
    _check_counts(path, document)
    while not isinstance(document, _Document):
        document = document.updated()
    return document


def _check_counts(path: Path, document: _Second | _Third | _Document) -> None:
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


def _links(ends: tuple[_Shape, _Shape], marks: list[Mark]) -> list[_ThirdLink]:
    """Give the links of shapes of at most one part."""
    source, target = (0 if shape.parts else None for shape in ends)
    return [] if source is target is None and not marks else [_ThirdLink(source, target, None, marks)]


def _shape(shape: _Shape, where: str, tally: Tally) -> KeyShape:
    several = len(shape.parts) > 1
    parts = [
        Part(
            polygon_of(
                part.ring, told("{where}, part {number}", where=where, number=k) if several else where, tally
            ),
            part.name,
            part.colour,
            part.visible,
        )
        for k, part in enumerate(shape.parts)
    ]
    try:
        return KeyShape(tuple(parts), shape.picture)
    except InvalidPolygon as error:
        raise InvalidFile.holding(error, where) from error


def _step(given: _Step, ends: tuple[KeyShape, KeyShape], where: str) -> Step:
    """Give a step, whose marks count the rows of the file, with marks that count the polygons' vertices."""
    links = tuple(
        Link(link.source, link.target, tuple(link.marks), link.place, link.root) for link in given.links
    )
    step = Step(links, given.duration, Easing(*given.easing), given.turns, given.joined)
    try:
        step.check(*ends)
    except InvalidMarks as error:
        raise InvalidFile.holding(error, where) from error
    return replace(step, links=tuple(_own(link, ends) for link in links))


def _own(link: Link, ends: tuple[KeyShape, KeyShape]) -> Link:
    if link.source is None or link.target is None:
        return link
    source, target = ends[0].rings[link.source], ends[1].rings[link.target]
    return replace(link, marks=tuple((source.vertex_of(i), target.vertex_of(j)) for i, j in link.marks))


def _methods(path: Path, names: Sequence[str]) -> tuple[str, ...]:
    for number, name in enumerate(names):
        if name not in METHODS:
            what = told(
                '{path} shows the method "{name}", which this program does not know', path=path, name=name
            )
            raise InvalidFile(
                what, told("open it with a newer starskel, or name one of {names}", names=", ".join(METHODS))
            )
        if name in names[:number]:
            raise InvalidFile(
                told('{path} shows the method "{name}" twice', path=path, name=name), told("name it once")
            )
    return tuple(names)
