"""Files that are dropped on the window: projects, drawings, maps and fonts."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QMimeData, QObject, Qt, QTimer
from PySide6.QtGui import QDropEvent

from app.model.marks import Side
from app.session import Session
from app.view.canvas.canvas import Canvas
from app.view.files.files import Files
from app.view.files.importing import Aim, Importing
from starskel.reading.readers import ENDINGS

PICTURES = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".gif")
"""Endings of pictures: those are put behind the shape, to be drawn over or traced."""

TAKEN = tuple(ending for ending in ENDINGS if ending not in PICTURES)
"""Endings of files whose shapes are put on a canvas."""

_KINDS = (QEvent.Type.DragEnter, QEvent.Type.DragMove, QEvent.Type.Drop)


class Drops(QObject):
    """Takes files that are dropped on a window or its canvases, before these take them as pictures."""

    def __init__(self, parent: QObject, session: Session, files: Files, importing: Importing) -> None:
        super().__init__(parent)
        self._session = session
        self._files = files
        self._importing = importing

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() not in _KINDS or not isinstance(event, QDropEvent):
            return False
        path = dropped_file(event.mimeData())
        if path is None:
            return False
        event.setDropAction(Qt.DropAction.CopyAction)  # after a move the original would be taken away
        event.accept()
        if event.type() == QEvent.Type.Drop:
            side = watched.side if isinstance(watched, Canvas) else self._session.selection.side
            # not before the drop has ended: whoever drags would wait for the answer to a question
            QTimer.singleShot(0, self, partial(self.take, path, side))
        return True

    def take(self, path: Path, side: Side) -> None:
        """Open a project; put a shape of a drawing, a map or a font on a canvas."""
        if path.suffix.lower() in TAKEN:
            self._importing.read(Aim(path, side))
        elif self._files.may_go():
            self._files.open(path)


def dropped_file(data: QMimeData) -> Path | None:
    """Give the first project among what is dropped, or file with shapes."""
    paths = (Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile())
    return next((path for path in paths if path.suffix.lower() in (".json", *TAKEN)), None)
