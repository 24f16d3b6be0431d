"""What menus do to the shapes on the canvases."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject, Slot

from app.model.marks import Side
from app.session import Session
from app.tools.pasting import cut, pasted
from app.tools.select import SelectTool
from app.tools.tool import Refusal, Response, Scene
from app.tools.verbs import VERBS, meant
from app.view.canvas.canvas import Canvas
from app.view.canvas.clipboard import copied_ring, copy_ring
from starskel.errors import StarskelError


class Edits(QObject):
    """The commands of the shape menu, and those of the clipboard."""

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
            "paste": self._paste,
        }

    @property
    def _side(self) -> Side:
        """The shape that was worked on last, or the only one there is."""
        return meant(Scene(self._session.document, self._session.selection)).side

    @Slot()
    def _do(self) -> None:
        verb = VERBS[self.sender().objectName()]
        pixel = 1 / self._canvases[self._side].camera.scale
        self._session.edit(lambda scene: verb(scene, pixel))

    @Slot()
    def _copy(self) -> None:
        if self._session.finish() and self._session.document.polygon(self._side) is not None:
            copy_ring(self._session.document.vertices(self._side))

    @Slot()
    def _cut(self) -> None:
        self._copy()
        self._session.edit(partial(cut, side=self._side))

    @Slot()
    def _paste(self) -> None:
        """Paste onto the canvas that was worked on last, and show all of what came from elsewhere."""
        side = self._session.selection.side
        try:
            ring = copied_ring()
        except StarskelError as error:
            refusal = Refusal(side, error)
            self._session.edit(lambda scene: Response(SelectTool(side), refusal=refusal))
            return
        self._session.edit(partial(pasted, side=side, ring=ring))
        self._canvases[side].reveal()
