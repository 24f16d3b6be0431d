"""Shapes of drawings, maps, pictures and fonts: read beside the window, chosen, and put on the canvases."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtWidgets import QWidget

from app.compute import USUAL_METHODS
from app.compute.errands import Work
from app.model.document import Document
from app.model.filing import project_of
from app.model.marks import SIDES, Side
from app.model.selection import Selection
from app.model.texts import QT_TRANSLATE_NOOP
from app.session import Session
from app.tools.refusal import Refusal
from app.tools.select import SelectTool
from app.tools.tool import Response, ToolContext
from app.tools.verbs.pasting import pasted, put
from app.view.canvas.canvas import Canvas
from app.view.canvas.clipboard import copied_shape, copied_svg
from app.view.files.dialogs import complain, path_to_import
from app.view.files.file_reader import FileReader
from app.view.wording import words
from starskel.errors import StarskelError
from starskel.task import Task

if TYPE_CHECKING:  # what reads is loaded by the worker, so that the window opens sooner
    from starskel.reading.named_shape import NamedShape, Reading


_CLIPBOARD = Path("clipboard.svg")
"""What errors call the clipboard."""


@dataclass(frozen=True)
class Aim:
    """What is to become of the shapes of a file.

    Attributes
    ----------
    path : Path
    side : {"source", "target"} or None
        The canvas that gets a shape, or None for both.
    anew : bool
        Whether they begin a new document.
    """

    path: Path
    side: Side | None = None
    anew: bool = False


class Importing(QObject):
    """Takes files that hold shapes."""

    told = Signal(str)
    """What there is to say of what was imported."""
    begun = Signal(object, object)
    """A Project of shapes that are to be a new document, and the path of their file."""

    def __init__(self, window: QWidget, session: Session, canvases: Mapping[Side, Canvas]) -> None:
        super().__init__(window)
        self._window = window
        self._session = session
        self._canvases = canvases
        self.reader = FileReader(self)
        session.opened.connect(self.reader.cancel)  # what is being read was to replace what was open

    def close(self) -> None:
        """End the reader; to be called before the program ends."""
        self.reader.close()

    @Slot()
    def choose(self) -> None:
        """Ask for a file, and put shapes of it on the canvases."""
        path = path_to_import(self._window)
        if path is not None:
            self.read(Aim(path))

    @Slot()
    def paste(self) -> None:
        """Put what is on the clipboard on the canvas that was worked on last, and show all of it."""
        side = self._session.selection.side
        if (clipping := copied_shape()) is not None:
            self._session.edit(partial(pasted, side=side, clipping=clipping))
            self._canvases[side].reveal()
            return
        aim = Aim(_CLIPBOARD, side)
        try:
            content = copied_svg()
        except StarskelError as error:
            self._refuse(aim, error)
        else:
            self._read(aim, partial(_read_content, content))

    def read(self, aim: Aim) -> None:
        """Read a file, and do with its shapes what is aimed at."""
        self._read(aim, partial(_read, aim.path))

    def _read(self, aim: Aim, work: Work) -> None:
        self.reader.read(aim.path.name, work, partial(self._take, aim), partial(self._refuse, aim))

    def _take(self, aim: Aim, reading: "Reading") -> None:
        if (chosen := self._chosen(aim, reading)) is not None:
            self._put(aim, chosen)

    def _refuse(self, aim: Aim, error: StarskelError) -> None:
        if aim.side is None:
            complain(self._window, self.tr("{name} cannot be read").format(name=aim.path.name), error)
        else:
            refusal = Refusal(aim.side, error)
            self._session.edit(lambda context: Response(SelectTool(refusal.side), refusal=refusal))

    def _chosen(self, aim: Aim, reading: "Reading") -> "Mapping[Side, NamedShape] | None":
        """Give a shape for each canvas that gets one, asking where a file holds several."""
        if len(reading.shapes) == 1:
            return {aim.side or ("source" if aim.anew else self._session.selection.side): reading.shapes[0]}
        chooser = import_module("app.view.files.shape_chooser")
        sides = SIDES if aim.side is None else (aim.side,)
        chosen: Mapping[Side, NamedShape] | None = chooser.chosen_shapes(
            aim.path, reading, sides, self._window, optional=not aim.anew
        )
        return chosen

    def _put(self, aim: Aim, chosen: "Mapping[Side, NamedShape]") -> None:
        shapes = {side: found.shape for side, found in chosen.items()}
        name = (
            QT_TRANSLATE_NOOP("Step", "Paste shape")
            if aim.path == _CLIPBOARD
            else QT_TRANSLATE_NOOP("Step", "Import shapes")
        )
        verb = partial(put, shapes=shapes, name=name)
        if aim.anew:
            title = aim.path.stem
            begun = verb(ToolContext(Document(title, methods=USUAL_METHODS), Selection("source")))
            if begun.commit is not None:
                self.begun.emit(project_of(begun.commit.document, title), aim.path)
        else:
            self._session.edit(verb)
            for side in shapes:
                self._canvases[side].reveal()
        self._tell(chosen)

    def _tell(self, chosen: "Mapping[Side, NamedShape]") -> None:
        """Say what was mended."""
        lines = [
            f"{words.retold(found.name)}: {words.retold(repair)}"
            for found in chosen.values()
            for repair in found.repairs
        ]
        if lines:
            self.told.emit(self.tr("Mended: {what}").format(what="; ".join(lines)))


def _read_content(content: bytes, _: Task) -> "Reading":
    reading: Reading = import_module("starskel.reading.readers").read_content(content, _CLIPBOARD)
    return reading


def _read(path: Path, _: Task) -> "Reading":
    reading: Reading = import_module("starskel.reading.readers").read_shapes(path)
    return reading
