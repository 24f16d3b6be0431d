"""The list of edits: a click goes back to one, or forward."""

from collections.abc import Iterable

from PySide6.QtCore import QEvent, QSignalBlocker, Slot
from PySide6.QtGui import QBrush, QHideEvent, QPalette, QShowEvent
from PySide6.QtWidgets import QListWidget

from app.model.history import Step
from app.session import Session
from app.view.wording import words


class HistoryList(QListWidget):
    """All steps since the document was opened; those that are undone are greyed out.

    It follows only while it is seen, and touches only rows that change: there may be thousands.
    """

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._steps: tuple[Step, ...] = ()
        self._position = 0
        self.setObjectName("history-list")
        self.setAccessibleName(self.tr("History"))
        self.currentRowChanged.connect(self._go)
        session.document_changed.connect(self._follow)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._follow()

    def hideEvent(self, event: QHideEvent) -> None:
        """Let go of the steps, which hold documents."""
        super().hideEvent(event)
        self._steps = ()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._paint_rows(range(self.count()))

    @Slot()
    def _follow(self) -> None:
        if not self.isVisible():
            return
        steps, position = self._session.history.steps, self._session.history.position
        pairs = enumerate(zip(self._steps, steps, strict=False))
        kept = next((row for row, (old, new) in pairs if old is not new), min(len(self._steps), len(steps)))
        moved = sorted((self._position, position))
        with QSignalBlocker(self):
            while self.count() > kept:
                self.takeItem(self.count() - 1)
            self.addItems(
                [words.step(step.name) if step.name else self.tr("Opened") for step in steps[kept:]]
            )
            self._steps, self._position = steps, position
            self._paint_rows({*range(moved[0], moved[1] + 1), *range(kept, len(steps))})
            self.setCurrentRow(position)

    def _paint_rows(self, rows: Iterable[int]) -> None:
        undone = self.palette().brush(QPalette.ColorGroup.Disabled, QPalette.ColorRole.Text)
        for row in rows:
            if (item := self.item(row)) is not None:
                item.setForeground(undone if row > self._position else QBrush())

    @Slot(int)
    def _go(self, row: int) -> None:
        if row >= 0:
            self._session.go_to(row)
        self._follow()
