"""Project files: what the editor has open, format starskel-project."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from starskel.blending import METHODS
from starskel.correspondence.marks import Mark
from starskel.errors import InvalidFile, told
from starskel.files.documents import check_format, read_document, write_document
from starskel.files.shapes import Row, marked_shapes, polygon_of, rows_of
from starskel.polygon import Polygon

FORMAT = "starskel-project"
VERSION = 1


class _Header(msgspec.Struct, frozen=True):
    version: int = 0


class _Document(msgspec.Struct, frozen=True):
    format: str
    version: int
    name: str
    source: list[Row] | None
    target: list[Row] | None
    marks: list[Mark]
    methods: list[str]
    description: str = ""


@dataclass(frozen=True)
class Project:
    """Two shapes on the way to a blend.

    Attributes
    ----------
    name : str
        What the user calls it.
    source, target : Polygon or None
        The shapes drawn so far.
    marks : tuple of (int, int)
        A vertex of the source, a vertex of the target; none while a shape is missing.
    methods : tuple of str
        The blending methods shown, in order.
    description : str
        A sentence about it; empty where nobody wrote one.
    """

    name: str
    source: Polygon | None = None
    target: Polygon | None = None
    marks: tuple[Mark, ...] = ()
    methods: tuple[str, ...] = ()
    description: str = ""


def read_project(path: Path) -> Project:
    """Read a project file.

    Raises
    ------
    InvalidFile
        If it cannot be read, is damaged, is no project, is one of a newer version, or holds invalid things.
    """
    check_format(path, FORMAT)
    _check_version(path)
    document = read_document(path, _Document)
    source = (
        polygon_of(document.source, told("{where}: {what}", where=path, what=told("source")))
        if document.source is not None
        else None
    )
    target = (
        polygon_of(document.target, told("{where}: {what}", where=path, what=told("target")))
        if document.target is not None
        else None
    )
    marks: tuple[Mark, ...] = ()
    if source is not None and target is not None:
        source, target, marks = marked_shapes(source, target, document.marks, str(path))
    elif document.marks:
        raise InvalidFile(
            told("{path} has marks, but not both shapes", path=path),
            told("add the missing shape or remove the marks"),
        )
    methods = _methods(path, document.methods)
    return Project(document.name, source, target, marks, methods, document.description)


def write_project(path: Path, project: Project) -> None:
    """Write a project file, whole or not at all.

    Raises
    ------
    InvalidFile
        If it cannot be written; an old file stays as it was.
    """
    source = rows_of(project.source) if project.source is not None else None
    target = rows_of(project.target) if project.target is not None else None
    marks, methods = list(project.marks), list(project.methods)
    document = _Document(FORMAT, VERSION, project.name, source, target, marks, methods, project.description)
    write_document(path, document)


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


def _check_version(path: Path) -> None:
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
