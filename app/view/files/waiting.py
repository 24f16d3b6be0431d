"""Work that takes a while, done beside the window: how far it is, and a way to give it up."""

from typing import Any

from PySide6.QtCore import QEventLoop, Qt, QTimer, Slot
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QProgressBar, QVBoxLayout, QWidget

from app.compute.errands import Errands, Outcome, Work
from app.view.wording.plain import Label
from starskel.errors import Cancelled

BLINK = 400
"""Milliseconds of work for which no dialog is shown."""


class Waiting(QDialog):
    """Shows the progress of one errand, once it takes longer than a blink.

    Parameters
    ----------
    text : str
        What is done.
    stoppable : bool
        Whether the user may give it up.
    """

    def __init__(self, text: str, parent: QWidget | None = None, *, stoppable: bool = True) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Please wait"))
        self.setWindowModality(Qt.WindowModality.WindowModal)
        self._outcome: Outcome | None = None
        self._loop = QEventLoop(self)
        self._errands = Errands(self)
        self._errands.done.connect(self._take)
        self._errands.progressed.connect(self._advance)
        self._bar = QProgressBar()
        self._bar.setRange(0, 0)  # moves to and fro until something is reported
        self._bar.setAccessibleName(self.tr("Progress"))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        button = buttons.button(QDialogButtonBox.StandardButton.Cancel)
        button.setIcon(QIcon())
        button.setAutoDefault(False)  # Enter, pressed once too often before, gives nothing up
        buttons.rejected.connect(self.reject)
        buttons.setVisible(stoppable)
        self._stoppable = stoppable
        layout = QVBoxLayout(self)
        for widget in (Label(text), self._bar, buttons):
            layout.addWidget(widget)
        self.setMinimumWidth(360)

    def reject(self) -> None:
        """Give the work up, where that may be done."""
        if self._stoppable:
            super().reject()

    def awaited(self, work: Work) -> Any:
        """Do the work, and give what came of it. It can be done once.

        Raises
        ------
        Cancelled
            If the user gave it up.
        Exception
            Whatever the work raised.
        """
        self._errands.do(work)
        QTimer.singleShot(BLINK, self._loop, self._loop.quit)
        self._loop.exec(QEventLoop.ProcessEventsFlag.ExcludeUserInputEvents)
        if self._outcome is None:
            self.exec()
        self._errands.close()
        self.deleteLater()
        if self._outcome is None:
            raise Cancelled
        if self._outcome.error is not None:
            raise self._outcome.error
        return self._outcome.value

    @Slot(object)
    def _take(self, outcome: Outcome) -> None:
        self._outcome = outcome
        self._loop.quit()
        self.accept()

    @Slot(float)
    def _advance(self, fraction: float) -> None:
        self._bar.setRange(0, 100)
        self._bar.setValue(int(100 * fraction))
