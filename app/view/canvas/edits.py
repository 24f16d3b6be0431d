"""What menus do to the shapes on the canvases."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject, Slot

from app.model.clipping import clipping_of
from app.model.marks import Side
from app.model.selection import Selection
from app.session import Session
from app.tools.tool import ToolContext
from app.tools.verbs.pasting import cut
from app.tools.verbs.shape import VERBS, meant
from app.view.canvas.canvas import Canvas
from app.view.canvas.clipboard import copy_shape


class Edits(QObject):
    """The commands of the shape menu, and those that fill the clipboard."""

    def __init__(self, parent: QObject, session: Session, canvases: Mapping[Side, Canvas]) -> None:
        super().__init__(parent)
        self._session = session
        self._canvases = canvases

    def handlers(self) -> dict[str, Callable[[], object]]:
        """Give for each command what it does."""
        return {
            **dict.fromkeys(VERBS, self._do),
            "cut": self._cut,
            "copy": self._copy,
        }

    @property
    def _side(self) -> Side:
        """The shape that was worked on last, or the only one there is."""
        return meant(ToolContext(self._session.document, self._session.selection)).side

    @property
    def _meant(self) -> Selection:
        """What is selected; where nothing is, all of that shape."""
        selection = self._session.selection
        return selection if selection.side == self._side else Selection(self._side)

    @Slot()
    def _do(self) -> None:
        verb = VERBS[self.sender().objectName()]
        pixel = 1 / self._canvases[self._side].camera.scale
        self._session.edit(lambda context: verb(context, pixel))

    @Slot()
    def _copy(self) -> None:
        if self._session.finish() and (clipping := clipping_of(self._session.document, self._meant)):
            copy_shape(clipping)

    @Slot()
    def _cut(self) -> None:
        self._copy()
        self._session.edit(partial(cut, selection=self._meant))
