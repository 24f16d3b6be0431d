"""Documents to projects, which files hold, and back."""

from app.model.document import Document
from app.model.sequence import Sequence
from starskel.files.project import Project


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
