"""Documents to projects, which files hold, and back; and whether a file is still as it was."""

from dataclasses import dataclass
from pathlib import Path

from app.model.document import Document
from app.model.sequence import Sequence
from starskel.files.disk import clear_leftovers, digest_of
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import write_project


@dataclass(frozen=True)
class Filed:
    """The file of a document, as it was when it was read or written last.

    Attributes
    ----------
    path : Path
        Where it lies.
    digest : str or None
        Of what was in it; None where it could not be read.
    """

    path: Path
    digest: str | None

    @classmethod
    def now(cls, path: Path) -> "Filed":
        """Give a file as it is now."""
        return cls(path, digest_of(path))

    @property
    def overtaken(self) -> bool:
        """Whether another program has changed it since; one that has gone can be written anew unasked."""
        now = digest_of(self.path)
        return now is not None and self.digest is not None and now != self.digest


def stored(document: Document, path: Path) -> Filed:
    """Write the project file of a document, whole or not at all, and give it.

    Raises
    ------
    InvalidFile
        If it cannot be written.
    """
    write_project(path, project_of(document, path.stem))
    clear_leftovers(path.parent)
    return Filed.now(path)


def document_of(project: Project, usual_methods: tuple[str, ...]) -> Document:
    """Give a project to be edited, its first step on the canvases; with the usual methods if it names none.

    Raises
    ------
    InvalidMarks
        If marks of it cross.
    """
    sequence, methods = Sequence(project.shapes, project.steps), project.methods or usual_methods
    return Document(project.name, sequence, methods=methods, description=project.description)


def project_of(document: Document, name: str) -> Project:
    """Give a document as a project, under this name where it has none of its own."""
    sequence = document.sequence
    return Project(
        document.name or name,
        sequence.shapes,
        sequence.steps,
        document.methods,
        document.description,
    )
