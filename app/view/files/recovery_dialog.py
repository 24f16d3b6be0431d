"""A dialog that offers what was unsaved when the program ended unexpectedly."""

from pathlib import Path

from PySide6.QtCore import QDateTime, QLocale, QSize, Qt, Slot
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QListWidget,
    QListWidgetItem,
    QMessageBox,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.recovery.places import Kept
from app.recovery.record import Record
from app.view.asking import asked
from app.view.files.project_menus import project_icon
from app.view.wording.plain import Label
from starskel.errors import NewerFile

PICTURE = QSize(72, 72)
"""Size of a document's picture, in pixels."""

_KEPT = Qt.ItemDataRole.UserRole


class RecoveryDialog(QDialog):
    """Lets the user open a document, discard some, or leave them for later.

    Parameters
    ----------
    kept : tuple of Kept
        At least one.
    """

    def __init__(self, kept: tuple[Kept, ...], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Recovered documents"))
        self.resize(520, 380)
        self.chosen: Kept | None = None
        heading = Label(
            self.tr("The program ended unexpectedly. What was not saved then has been kept:"), wrapped=True
        )
        self.documents = self._document_list()
        for each in kept:
            self._add(each)
        self.documents.itemDoubleClicked.connect(self._open)
        self.documents.currentItemChanged.connect(self._follow)
        later = Label(
            self.tr("What is left for later is offered again, and is in the File menu."), wrapped=True
        )
        buttons = QDialogButtonBox()
        self.open_button = self._button(buttons, self.tr("&Open"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.discard_button = self._button(
            buttons, self.tr("&Discard…"), QDialogButtonBox.ButtonRole.DestructiveRole
        )
        self.later_button = self._button(buttons, self.tr("&Later"), QDialogButtonBox.ButtonRole.RejectRole)
        self.open_button.clicked.connect(self._open)
        self.discard_button.clicked.connect(self._discard)
        self.later_button.clicked.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(heading)
        layout.addWidget(self.documents, 1)
        layout.addWidget(later)
        layout.addWidget(buttons)
        self.open_button.setDefault(True)
        self.documents.setCurrentRow(0)

    def _document_list(self) -> QListWidget:
        documents = QListWidget()
        documents.setAccessibleName(self.tr("Recovered documents"))
        documents.setIconSize(PICTURE)
        documents.setSpacing(2)
        documents.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        documents.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        return documents

    def _button(self, box: QDialogButtonBox, text: str, role: QDialogButtonBox.ButtonRole) -> QPushButton:
        button = box.addButton(text, role)
        assert button is not None
        return button

    def _add(self, kept: Kept) -> None:
        item = QListWidgetItem(self._describe(kept))
        if isinstance(kept.record, Record):
            item.setIcon(project_icon(kept.record.project, self.palette(), PICTURE))
        item.setData(_KEPT, kept)
        self.documents.addItem(item)

    def _describe(self, kept: Kept) -> str:
        """Give three lines: what it is called, where it belongs, when it was kept."""
        time = QDateTime.fromSecsSinceEpoch(int(kept.time.timestamp()))
        when = QLocale().toString(time, QLocale.FormatType.ShortFormat)
        record = kept.record
        if not isinstance(record, Record):
            newer = isinstance(record, NewerFile)
            why = (
                self.tr("Of a newer version of starskel, which can open it")
                if newer
                else self.tr("Damaged, it cannot be opened")
            )
            return f"{why}\n{kept.place.path}\n{when}"
        origin: Path | None = None if record.file is None else record.file.path
        name = (origin.stem if origin else record.project.name) or self.tr("Untitled")
        place = str(origin) if origin else self.tr("never saved to a file")
        return f"{name}\n{place}\n{when}"

    @Slot()
    def _follow(self) -> None:
        kept = self._current()
        self.open_button.setEnabled(kept is not None and isinstance(kept.record, Record))
        self.discard_button.setEnabled(kept is not None)

    @Slot()
    def _open(self) -> None:
        if self.open_button.isEnabled():
            self.chosen = self._current()
            self.accept()

    @Slot()
    def _discard(self) -> None:
        """Do away with the one chosen, after a question; without any left there is nothing to offer."""
        item, kept = self.documents.currentItem(), self._current()
        if kept is None or not self._sure(kept, item.text().partition("\n")[0]):
            return
        kept.place.clear()
        self.documents.takeItem(self.documents.row(item))
        if not self.documents.count():
            self.reject()

    def _sure(self, kept: Kept, name: str) -> bool:
        box = QMessageBox(self)
        box.setIcon(QMessageBox.Icon.Question)
        box.setWindowTitle(self.tr("Discard"))
        box.setTextFormat(Qt.TextFormat.PlainText)
        if kept.readable:
            box.setText(self.tr("Discard the unsaved work on “{name}”?").format(name=name))
        else:
            box.setText(self.tr("Discard what cannot be opened here?") + f"\n\n{name}")
        box.setInformativeText(self.tr("It cannot be brought back. A saved file stays as it is."))
        kind = QMessageBox.StandardButton
        box.setStandardButtons(kind.Discard | kind.Cancel)
        box.setDefaultButton(kind.Cancel)
        return kind(asked(box)) == kind.Discard

    def _current(self) -> Kept | None:
        item = self.documents.currentItem()
        kept = None if item is None else item.data(_KEPT)
        assert kept is None or isinstance(kept, Kept)
        return kept
