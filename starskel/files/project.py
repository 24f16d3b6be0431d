"""Project files: what the editor has open, format starskel-project."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Annotated

import msgspec

from starskel.blending import METHODS
from starskel.correspondence.marks import Mark
from starskel.easing import Easing
from starskel.errors import InvalidFile, told
from starskel.files.documents import check_format, read_document, write_document
from starskel.files.pairs import ShapePair
from starskel.files.picture import Picture, Share
from starskel.files.shapes import Row, marked_shapes, polygon_of, rows_of
from starskel.files.step import Step
from starskel.polygon import Polygon

FORMAT = "starskel-project"
VERSION = 3


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

    def updated(self) -> "_Document":
        steps = [_step_of(Step(tuple(step.marks), step.duration)) for step in self.steps]
        return _Document(
            self.format, 3, self.name, self.shapes, steps, self.methods, self.description, self.pictures
        )


class _Step(msgspec.Struct, frozen=True):
    duration: Duration
    easing: tuple[tuple[Share, Share], tuple[Share, Share]]
    root: Row | None
    turns: int
    marks: list[Mark]


class _Document(msgspec.Struct, frozen=True):
    format: str
    version: int
    name: str
    shapes: list[list[Row] | None]
    steps: list[_Step]
    methods: list[str]
    description: str = ""
    pictures: list[Picture | None] = []  # for each shape; files without any may leave it out


_VERSIONS: tuple[type[_First] | type[_Second] | type[_Document], ...] = (_First, _Second, _Document)


@dataclass(frozen=True)
class Project:
    """Key shapes in order, on the way to a blend.

    Attributes
    ----------
    name : str
        What the user calls it.
    shapes : tuple of Polygon or None
        At least two, None where nothing has been drawn yet.
    steps : tuple of Step
        Step k leads from shape k to shape k + 1.
    methods : tuple of str
        The blending methods shown, in order.
    description : str
        A sentence about it; empty where nobody wrote one.
    pictures : tuple of Picture or None
        For each shape what is behind it; empty where there is none at all.
    """

    name: str
    shapes: tuple[Polygon | None, ...] = (None, None)
    steps: tuple[Step, ...] = (Step(),)
    methods: tuple[str, ...] = ()
    description: str = ""
    pictures: tuple[Picture | None, ...] = ()

    @classmethod
    def of(cls, pair: ShapePair) -> "Project":
        """Give a pair as a project of one step."""
        return cls(pair.id, (pair.source, pair.target), (Step(pair.marks),), description=pair.description)

    def pair(self, step: int) -> ShapePair:
        """Give the two shapes of a step, under the project's name, and the step's where there are several.

        Raises
        ------
        InvalidFile
            If one of them has not been drawn yet.
        """
        source, target = self.shapes[step : step + 2]
        if source is None or target is None:
            raise InvalidFile(
                told(
                    "{name} has no shape {letter} yet",
                    name=self.name,
                    letter=letter(step if source is None else step + 1),
                ),
                told("draw it in the editor and save"),
            )
        way, name = self.steps[step], self.step_name(step)
        return ShapePair(name, source, target, way.marks, way.root, way.turns, description=self.description)

    def step_name(self, step: int) -> str:
        """Give the name of a step: the project's, and the letters of its shapes where there are several."""
        if len(self.steps) == 1:
            return self.name
        return f"{self.name} {letter(step)}-{letter(step + 1)}"


def letter(shape: int) -> str:
    """Give the letter of a key shape counted from 0: A, B, ... Z, AA, AB, ..."""
    letters, rest = "", shape
    while rest >= 0:
        letters = chr(ord("A") + rest % 26) + letters
        rest = rest // 26 - 1
    return letters


def read_project(path: Path) -> Project:
    """Read a project file of this or an older version.

    Raises
    ------
    InvalidFile
        If it cannot be read, is damaged, is no project, is one of a newer version, or holds invalid things.
    """
    check_format(path, FORMAT)
    document = _read(path)
    _check_counts(path, document)
    shapes = tuple(
        None
        if rows is None
        else polygon_of(rows, told("{path}: shape {letter}", path=path, letter=letter(number)))
        for number, rows in enumerate(document.shapes)
    )
    steps = tuple(
        Step(_marks(path, pair, step, number), step.duration, Easing(*step.easing), step.root, step.turns)
        for number, (pair, step) in enumerate(zip(pairwise(shapes), document.steps, strict=True))
    )
    # the polygons as if they had been given counter-clockwise, as their marks are
    own = tuple(None if shape is None else Polygon(shape.vertices) for shape in shapes)
    methods, pictures = _methods(path, document.methods), tuple(document.pictures)
    return Project(document.name, own, steps, methods, document.description, pictures)


def write_project(path: Path, project: Project) -> None:
    """Write a project file, whole or not at all.

    Raises
    ------
    InvalidFile
        If it cannot be written; an old file stays as it was.
    """
    shapes = [None if shape is None else rows_of(shape) for shape in project.shapes]
    steps = [_step_of(step) for step in project.steps]
    methods, description = list(project.methods), project.description
    pictures = list(project.pictures) if any(project.pictures) else []
    document = _Document(FORMAT, VERSION, project.name, shapes, steps, methods, description, pictures)
    write_document(path, document)


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
    document: _First | _Second | _Document = read_document(path, _VERSIONS[version - 1])
    while not isinstance(document, _Document):
        document = document.updated()
    return document


def _step_of(step: Step) -> _Step:
    easing = (step.easing.first, step.easing.second)
    return _Step(step.duration, easing, step.root, step.turns, list(step.marks))


def _check_counts(path: Path, document: _Document) -> None:
    shapes, steps = len(document.shapes), len(document.steps)
    if shapes < 2 or steps != shapes - 1:
        raise InvalidFile(
            told("{path} has {shapes} shapes and {steps} steps", path=path, shapes=shapes, steps=steps),
            told("give two shapes at least, and a step from each to the next"),
        )
    if document.pictures and len(document.pictures) != shapes:
        raise InvalidFile(
            told(
                "{path} has {pictures} pictures for {shapes} shapes",
                path=path,
                pictures=len(document.pictures),
                shapes=shapes,
            ),
            told("give one for each shape, null where there is none"),
        )


def _marks(
    path: Path, shapes: tuple[Polygon | None, Polygon | None], step: _Step, number: int
) -> tuple[Mark, ...]:
    where = told("{path}: step {first}-{last}", path=path, first=letter(number), last=letter(number + 1))
    source, target = shapes
    if source is not None and target is not None:
        return marked_shapes(source, target, step.marks, where)[2]
    if step.marks:
        raise InvalidFile(
            told("{where} has marks, but not both shapes", where=where),
            told("add the shape or remove the marks"),
        )
    return ()


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
