"""Work indicator: what is being done, how far it is, and a way to stop it."""

from PySide6.QtCore import QTimer, Slot
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QHBoxLayout, QProgressBar, QToolButton, QWidget

from app.view.wording.plain import Label

BLINK = 300
"""Milliseconds of work that are not worth a word."""


class WorkIndicator(QWidget):
    """Shows work that takes longer than a blink; between two pieces of work it shows what came of the last.

    Parameters
    ----------
    name : str
        What it tells, for those who hear it.
    cancel : QAction
        What stops the work.
    """

    def __init__(self, name: str, cancel: QAction) -> None:
        super().__init__()
        self.text = Label()
        self.text.setAccessibleName(name)
        self._bar = QProgressBar()
        self._bar.setAccessibleName(self.tr("Progress"))
        self._bar.setFixedWidth(140)
        self._bar.setMaximumHeight(14)
        self._bar.setTextVisible(False)
        self._stop = QToolButton()
        self._stop.setDefaultAction(cancel)
        self._stop.setAccessibleName(self.tr("Cancel"))
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for widget in (self.text, self._bar, self._stop):
            layout.addWidget(widget)
        self._said = ""
        self._delay = QTimer(self)
        self._delay.setSingleShot(True)
        self._delay.setInterval(BLINK)
        self._delay.timeout.connect(self._show)
        self.end()

    def begin(self, text: str) -> None:
        """Show this work soon, unless it is done by then."""
        self._said = text
        self._bar.setRange(0, 0)  # moves to and fro until something is reported
        self._delay.start()

    def report(self, fraction: float, text: str = "") -> None:
        """Say how far it is, and if need be in other words what is done."""
        self._said = text or self._said
        self._bar.setRange(0, 100)
        self._bar.setValue(round(100 * fraction))
        if not self._delay.isActive():
            self.text.setText(self._said)

    def end(self, outcome: str = "") -> None:
        """Show no work any more, but what came of it."""
        self._delay.stop()
        self._switch(on=False)
        self.text.setText(outcome)
        self.setVisible(bool(outcome))

    @Slot()
    def _show(self) -> None:
        self.text.setText(self._said)
        self._switch(on=True)
        self.show()

    def _switch(self, *, on: bool) -> None:
        self._bar.setVisible(on)
        self._stop.setVisible(on)
