"""Verbs for marks: what the table of marks and the suggestion do, without a pointer."""

from collections.abc import Callable

from app.model.document import Document
from app.model.marks import Marks, Side
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.mark import MarkTool
from app.tools.refusal import Refusal
from app.tools.tool import Commit, Response, Scene
from starskel.errors import InvalidMarks


def set_mark(scene: Scene, source: int, target: int) -> Response:
    """Add a mark."""
    return _tried(lambda: scene.document.mark(source, target), QT_TRANSLATE_NOOP("Step", "Set mark"))


def move_mark(scene: Scene, index: int, side: Side, vertex: int) -> Response:
    """Move one end of a mark to another vertex."""
    return _tried(lambda: scene.document.repin(index, side, vertex), QT_TRANSLATE_NOOP("Step", "Move mark"))


def remove_mark(scene: Scene, index: int) -> Response:
    """Remove a mark."""
    return _tried(lambda: scene.document.unmark(index), QT_TRANSLATE_NOOP("Step", "Remove mark"))


def replace_marks(scene: Scene, marks: Marks) -> Response:
    """Replace all marks by those that suggest themselves."""
    return _tried(lambda: scene.document.remark(marks), QT_TRANSLATE_NOOP("Step", "Suggest marks"))


def _tried(verb: Callable[[], Document], name: str) -> Response:
    try:
        return Response(MarkTool(), Commit(verb(), name))
    except InvalidMarks as error:
        return Response(MarkTool(), refusal=Refusal("source", error, marks=error.marks))
