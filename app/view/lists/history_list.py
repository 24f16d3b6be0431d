"""The list of edits: a click goes back to one, or forward."""

from collections.abc import Iterable
from itertools import takewhile

from PySide6.QtCore import QEvent, QSignalBlocker, Slot
from PySide6.QtGui import QBrush, QHideEvent, QPalette, QShowEvent
from PySide6.QtWidgets import QListWidget

from app.model.history import Snapshot
from app.session import Session
from app.view.wording import words


class HistoryList(QListWidget):
    """All steps since the document was opened; those that are undone are greyed out.

    It follows only while it is seen, and touches only rows that change: there may be thousands.
    """

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._snapshots: tuple[Snapshot, ...] = ()
        self._position = 0
        self.setObjectName("history-list")
        self.setAccessibleName(self.tr("History"))
        self.currentRowChanged.connect(self._go)
        session.document_changed.connect(self._follow)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._follow()

    def hideEvent(self, event: QHideEvent) -> None:
        """Let go of the snapshots, which hold documents."""
        super().hideEvent(event)
        self._snapshots = ()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._paint_rows(range(self.count()))

    @Slot()
    def _follow(self) -> None:
        if not self.isVisible():
            return
        snapshots, position = self._session.history.snapshots, self._session.history.position
        same = takewhile(lambda pair: pair[0] is pair[1], zip(self._snapshots, snapshots, strict=False))
        kept = sum(1 for _ in same)
        moved = sorted((self._position, position))
        with QSignalBlocker(self):
            while self.count() > kept:
                self.takeItem(self.count() - 1)
            names = [each.name for each in snapshots[kept:]]
            self.addItems([words.step(name) if name else self.tr("Opened") for name in names])
            self._snapshots, self._position = snapshots, position
            self._paint_rows({*range(moved[0], moved[1] + 1), *range(kept, len(snapshots))})
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
