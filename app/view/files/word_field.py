"""A field for a word that a font sets: its outlines become a shape, made beside the window."""

from functools import partial
from importlib import import_module
from pathlib import Path

from PySide6.QtCore import QTimer, Signal, Slot
from PySide6.QtWidgets import QLineEdit

from app.compute.errands import Errands, Outcome
from app.view.wording import words
from starskel.errors import StarskelError
from starskel.reading.named_shape import NamedShape, Reading
from starskel.task import Task

PAUSE = 200
"""Milliseconds without a key after which what is written is set."""


class WordField(QLineEdit):
    """Asks for a word."""

    made = Signal(object)
    """The shape of the word, a `NamedShape`; None where nothing is written, or it cannot be set."""
    refused = Signal(str)
    """Why it cannot be set."""
    pending_changed = Signal()

    def __init__(self, font: Path) -> None:
        super().__init__()
        self._font = font
        self.setPlaceholderText(self.tr("Or write a word"))
        self.setToolTip(self.tr("Set in this font, with kerning; each part of a letter becomes a part"))
        self.setClearButtonEnabled(True)
        self._pause = QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.setInterval(PAUSE)
        self._pause.timeout.connect(self._set)
        self._errands = Errands(self)
        self._errands.done.connect(self._take)
        self.textChanged.connect(self._wait)

    @property
    def pending(self) -> bool:
        """Whether what is written has not become a shape yet."""
        return self._pause.isActive() or self._errands.busy

    @Slot()
    def leave(self) -> None:
        """End the worker; to be called before the field is gone."""
        self._pause.stop()
        self._errands.close()

    @Slot()
    def _wait(self) -> None:
        self._errands.cancel()
        self._pause.start()
        self.pending_changed.emit()

    @Slot()
    def _set(self) -> None:
        text = self.text().strip()
        if text:
            self._errands.do(partial(_word, self._font, text))
        else:
            self.made.emit(None)
            self.pending_changed.emit()

    @Slot(object)
    def _take(self, outcome: Outcome) -> None:
        self.made.emit(outcome.value)
        if isinstance(outcome.error, StarskelError):
            self.refused.emit(words.sentences(outcome.error, " "))
        elif outcome.error is not None:
            raise outcome.error
        self.pending_changed.emit()


def _word(font: Path, text: str, _: Task) -> NamedShape:
    reading: Reading = import_module("starskel.reading.readers").read_shapes(font, texts=(text,))
    return reading.shapes[0]
