"""Project files: what the editor has open, format starskel-project."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate, pairwise
from operator import is_
from pathlib import Path
from typing import Any

import msgspec

from starskel.blending import METHODS
from starskel.easing import Easing
from starskel.errors import InvalidFile, InvalidMarks, InvalidPolygon, told
from starskel.files.documents import check_format, write_document
from starskel.files.projects.key_shape import KeyShape, Part
from starskel.files.projects.project import Project, letter
from starskel.files.projects.project_document import (
    FORMAT,
    VERSION,
    LinkEntry,
    PartEntry,
    ProjectDocument,
    ShapeEntry,
    StepEntry,
)
from starskel.files.projects.project_versions import read_up_to_date
from starskel.files.projects.step import Link, Step
from starskel.files.shapes import as_given, polygon_of, rows_of
from starskel.limits import DOCUMENT_RINGS, Tally
from starskel.task import UNWATCHED, Task


def project_schema() -> dict[str, Any]:
    """Give the JSON schema of project files of this version; `resources/project.schema.json` holds it."""
    about = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"{FORMAT}, version {VERSION}",
    }
    return about | msgspec.json.schema(ProjectDocument)


def read_project(path: Path, task: Task = UNWATCHED) -> Project:
    """Read a project file of this or an older version.

    Parameters
    ----------
    path : Path
    task : Task
        It can be stopped between one ring and the next.

    Raises
    ------
    Cancelled
        If the task is stopped.
    NewerFile
        If it is one of a newer version.
    InvalidFile
        If it cannot be read, is damaged, is no project, or holds invalid things.
    """
    check_format(path, FORMAT)
    document, tally = read_up_to_date(path), Tally(str(path))
    tally.add(told("rings"), sum(len(shape.parts) for shape in document.shapes), DOCUMENT_RINGS)
    shapes = tuple(
        _shape(shape, told("{path}: shape {letter}", path=path, letter=letter(number)), tally, own)
        for number, (shape, own) in enumerate(
            zip(document.shapes, _shares(document.shapes, task), strict=True)
        )
    )
    steps = tuple(
        _step(step, ends, told("{path}: step {first}-{last}", path=path, first=letter(k), last=letter(k + 1)))
        for k, (step, ends) in enumerate(zip(document.steps, pairwise(shapes), strict=True))
    )
    own = tuple(map(_turned, shapes))
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
        ShapeEntry(
            shape.picture, [PartEntry(p.name, p.colour, p.visible, rows_of(p.ring)) for p in shape.parts]
        )
        for shape in project.shapes
    ]
    steps = [
        StepEntry(
            step.duration,
            (step.easing.first, step.easing.second),
            step.turns,
            step.joined,
            [
                LinkEntry(link.source, link.target, link.place, link.root, list(link.marks))
                for link in step.links
            ],
        )
        for step in project.steps
    ]
    methods = list(project.methods)
    document = ProjectDocument(FORMAT, VERSION, project.name, shapes, steps, methods, project.description)
    return msgspec.structs.asdict(document)


def _shares(entries: Sequence[ShapeEntry | PartEntry], task: Task) -> list[Task]:
    """Give each of some shapes, or parts, its share of the work: it is as long as it has vertices."""
    counts = [
        sum(len(part.ring) for part in (entry.parts if isinstance(entry, ShapeEntry) else [entry]))
        for entry in entries
    ]
    ends = [end / max(sum(counts), 1) for end in accumulate(counts, initial=0)]
    return [task.part(start, end) for start, end in pairwise(ends)]


def _shape(shape: ShapeEntry, where: str, tally: Tally, task: Task) -> KeyShape:
    several = len(shape.parts) > 1
    parts = []
    for k, (part, own) in enumerate(zip(shape.parts, _shares(shape.parts, task), strict=True)):
        own.reach(0)
        named = told("{where}, part {number}", where=where, number=k) if several else where
        ring = polygon_of(part.ring, named, tally)
        parts.append(Part(ring, part.name, part.colour, part.visible))
    try:
        return KeyShape(tuple(parts), shape.picture)
    except InvalidPolygon as error:
        raise InvalidFile.holding(error, where) from error


def _turned(shape: KeyShape) -> KeyShape:
    """Give the polygons as if they had been given counter-clockwise, as their marks are."""
    own = tuple(as_given(ring) for ring in shape.rings)
    if all(map(is_, own, shape.rings)):
        return shape
    return replace(
        shape, parts=tuple(replace(part, ring=ring) for part, ring in zip(shape.parts, own, strict=True))
    )


def _step(given: StepEntry, ends: tuple[KeyShape, KeyShape], where: str) -> Step:
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
