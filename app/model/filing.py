"""Documents to projects, which files hold, and back."""

from app.model.document import Document
from app.model.sequence import Sequence
from starskel.files.project import Project, Step


def document_of(project: Project, usual_methods: tuple[str, ...]) -> Document:
    """Give a project to be edited, its first step on the canvases; with the usual methods if it names none.

    Raises
    ------
    InvalidMarks
        If marks of it cross.
    """
    marks = tuple(step.marks for step in project.steps)
    durations = tuple(step.duration for step in project.steps)
    empty = Document(project.name, methods=project.methods or usual_methods, description=project.description)
    return empty.arranged(Sequence(project.shapes, marks, durations, project.pictures), 0)


def project_of(document: Document, name: str) -> Project:
    """Give a document as a project, under this name where it has none of its own."""
    sequence = document.sequence
    steps = map(Step, sequence.marks, sequence.durations)
    name = document.name or name
    return Project(
        name, sequence.shapes, tuple(steps), document.methods, document.description, sequence.pictures
    )
