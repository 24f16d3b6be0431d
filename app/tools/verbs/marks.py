"""Verbs for marks: what the table of marks and the suggestion do, without a pointer."""

from collections.abc import Callable

from app.model.document import Document
from app.model.marks import Marks, Side
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.mark import MarkTool
from app.tools.refusal import Refusal
from app.tools.tool import Commit, Response, ToolContext
from starskel.errors import InvalidMarks


def set_mark(context: ToolContext, source: int, target: int) -> Response:
    """Add a mark."""
    return _tried(lambda: context.document.mark(source, target), QT_TRANSLATE_NOOP("Step", "Set mark"))


def move_mark(context: ToolContext, index: int, side: Side, vertex: int) -> Response:
    """Move one end of a mark to another vertex."""
    return _tried(lambda: context.document.repin(index, side, vertex), QT_TRANSLATE_NOOP("Step", "Move mark"))


def remove_mark(context: ToolContext, index: int) -> Response:
    """Remove a mark."""
    return _tried(lambda: context.document.unmark(index), QT_TRANSLATE_NOOP("Step", "Remove mark"))


def replace_marks(context: ToolContext, marks: Marks) -> Response:
    """Replace all marks by those that suggest themselves."""
    return _tried(lambda: context.document.remark(marks), QT_TRANSLATE_NOOP("Step", "Suggest marks"))


def _tried(verb: Callable[[], Document], name: str) -> Response:
    try:
        return Response(MarkTool(), Commit(verb(), name))
    except InvalidMarks as error:
        return Response(MarkTool(), refusal=Refusal("source", error, marks=error.marks))
