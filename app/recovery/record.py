"""Record: a document with unsaved changes, and the file that it belongs to.

It is written as a project file with one entry more, so that any program that opens projects opens it, too.
"""

from dataclasses import dataclass
from pathlib import Path

import msgspec

from app.model.filing import Filed
from starskel.files.documents import read_document, write_document
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import project_content, read_project


@dataclass(frozen=True)
class Record:
    """What is kept of a document.

    Attributes
    ----------
    project : Project
        The document as it was last.
    file : Filed or None
        Its own file, None before it has one.
    """

    project: Project
    file: Filed | None = None


class _Origin(msgspec.Struct, frozen=True):
    path: str | None = None
    digest: str | None = None


class _Header(msgspec.Struct, frozen=True):
    recovery: _Origin = _Origin()


def write_record(path: Path, record: Record) -> None:
    """Write a record, whole or not at all.

    Raises
    ------
    InvalidFile
        If it cannot be written.
    """
    file = record.file
    origin = _Origin() if file is None else _Origin(str(file.path.absolute()), file.digest)
    write_document(path, {**project_content(record.project), "recovery": origin})


def read_record(path: Path) -> Record:
    """Read a record.

    Raises
    ------
    NewerFile
        If a newer program has written it.
    InvalidFile
        If it cannot be read or is damaged.
    """
    project = read_project(path)
    origin = read_document(path, _Header).recovery
    return Record(project, None if origin.path is None else Filed(Path(origin.path), origin.digest))
