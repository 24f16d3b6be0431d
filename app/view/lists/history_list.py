"""The list of edits: a click goes back to one, or forward."""

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtWidgets import QListWidget

from app.session import Session
from app.view.wording import words


class HistoryList(QListWidget):
    """All steps since the document was opened; those that are undone are greyed out."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.setObjectName("history-list")
        self.setAccessibleName(self.tr("History"))
        self.currentRowChanged.connect(self._go)
        session.document_changed.connect(self._follow)
        self._follow()

    @Slot()
    def _follow(self) -> None:
        history = self._session.history
        names = [words.step(step.name) if step.name else self.tr("Opened") for step in history.steps]
        with QSignalBlocker(self):
            if names != [self.item(row).text() for row in range(self.count())]:
                self.clear()
                self.addItems(names)
            for row in range(self.count()):
                undone = row > history.position
                group = self.palette().ColorGroup.Disabled if undone else self.palette().ColorGroup.Active
                self.item(row).setForeground(self.palette().brush(group, self.palette().ColorRole.Text))
            self.setCurrentRow(history.position)

    @Slot(int)
    def _go(self, row: int) -> None:
        if row >= 0:
            self._session.go_to(row)
        self._follow()
