"""Pictures behind the shapes: opened, dropped or pasted, traced, cropped, locked and removed."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QMimeData, QObject, Slot
from PySide6.QtWidgets import QWidget

from app.model.marks import Side
from app.session import Session
from app.tools.picture import PictureTool
from app.tools.refusal import Refusal
from app.tools.tool import Response
from app.tools.verbs.picture import crop_picture, lock_picture, traced, with_picture, without_picture
from app.view.asking import accepted
from app.view.canvas.canvas import Canvas
from app.view.files.dialogs import picture_to_open
from app.view.painting.pictures import image_in, picture_of
from app.view.pictures.trace_dialog import TraceDialog
from starskel.errors import StarskelError
from starskel.files.disk import read_bytes


class Backgrounds(QObject):
    """The commands for pictures; they mean the canvas that was worked on last."""

    def __init__(self, window: QWidget, session: Session, canvases: Mapping[Side, Canvas]) -> None:
        super().__init__(window)
        self._window = window
        self._session = session
        self._canvases = canvases
        for canvas in canvases.values():
            canvas.dropped.connect(self._take)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """Give for each command what it does."""
        return {
            "picture-open": self._open,
            "picture-trace": self._trace,
            "picture-lock": self._lock,
            "picture-crop": self._crop,
            "picture-remove": self._remove,
        }

    @property
    def _side(self) -> Side:
        return self._session.selection.side

    @Slot()
    def _open(self) -> None:
        path = picture_to_open(self._window)
        if path is not None:
            self._put(self._side, partial(read_bytes, path))

    @Slot(str, object)
    def _take(self, side: Side, data: QMimeData) -> None:
        self._put(side, partial(_content, data))

    @Slot()
    def _trace(self) -> None:
        """Put what is traced in the place of the shape, as one step."""
        side, picture = self._side, self._session.document.picture(self._side)
        if picture is None or not self._session.finish():
            return
        dialog = TraceDialog(picture, side, self._window)
        if accepted(dialog) and dialog.found is not None:
            self._session.edit(partial(traced, side=side, shape=dialog.found.shape))

    @Slot()
    def _lock(self) -> None:
        picture = self._session.document.picture(self._side)
        if picture is not None:
            self._session.edit(partial(lock_picture, side=self._side, locked=not picture.locked))

    @Slot()
    def _crop(self) -> None:
        picture = self._session.document.picture(self._side)
        if picture is not None:
            self._session.edit(partial(crop_picture, side=self._side, cropped=not picture.cropped))

    @Slot()
    def _remove(self) -> None:
        self._session.edit(partial(without_picture, side=self._side))

    def _put(self, side: Side, content: Callable[[], bytes]) -> None:
        """Put a picture in the middle of a canvas; where it is none, say so there."""
        try:
            picture = picture_of(content(), self._canvases[side].camera)
        except StarskelError as error:
            refusal = Refusal(side, error)
            self._session.edit(lambda context: Response(PictureTool(side), refusal=refusal))
        else:
            self._session.edit(partial(with_picture, side=side, picture=picture))


def _content(data: QMimeData) -> bytes:
    return image_in(data) or b""
