"""Files that are dropped on the window: projects, and outlines as SVG."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QMimeData, QObject, QTimer
from PySide6.QtGui import QDropEvent

from app.model.marks import Side
from app.model.svg_outline import outlines_of
from app.session import Session
from app.tools.pasting import pasted
from app.tools.select import SelectTool
from app.tools.tool import Refusal, Response
from app.view.canvas.canvas import Canvas
from app.view.files.files import Files
from starskel.errors import InvalidFile, StarskelError, told
from starskel.files.disk import read_bytes

_KINDS = (QEvent.Type.DragEnter, QEvent.Type.DragMove, QEvent.Type.Drop)


class Drops(QObject):
    """Takes files that are dropped on a window or its canvases, before these take them as pictures."""

    def __init__(self, parent: QObject, session: Session, files: Files) -> None:
        super().__init__(parent)
        self._session = session
        self._files = files

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() not in _KINDS or not isinstance(event, QDropEvent):
            return False
        path = dropped_file(event.mimeData())
        if path is None:
            return False
        event.acceptProposedAction()
        if event.type() == QEvent.Type.Drop:
            side = watched.side if isinstance(watched, Canvas) else self._session.selection.side
            # not before the drop has ended: whoever drags would wait for the answer to a question
            QTimer.singleShot(0, self, partial(self.take, path, side))
        return True

    def take(self, path: Path, side: Side) -> None:
        """Open a project; put an outline on a canvas."""
        if path.suffix.lower() == ".svg":
            self._put(path, side)
        elif self._files.may_go():
            self._files.open(path)

    def _put(self, path: Path, side: Side) -> None:
        try:
            found = outlines_of(read_bytes(path).decode(errors="replace"))
            if not found:
                raise InvalidFile(told("there is no outline in {name}", name=path.name))
        except StarskelError as error:
            refusal = Refusal(side, error)
            self._session.edit(lambda scene: Response(SelectTool(side), refusal=refusal))
        else:
            self._session.edit(partial(pasted, side=side, ring=found[0]))


def dropped_file(data: QMimeData) -> Path | None:
    """Give the first project or SVG among what is dropped."""
    paths = (Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile())
    return next((path for path in paths if path.suffix.lower() in (".json", ".svg")), None)
