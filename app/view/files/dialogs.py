"""Questions to the user: which file, which pair, save or not; and what went wrong."""

from collections.abc import Sequence
from enum import Enum
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QStandardPaths, Qt, Slot
from PySide6.QtGui import QImageReader
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QLineEdit,
    QListWidget,
    QMessageBox,
    QVBoxLayout,
    QWidget,
)

from app.view.asking import accepted, answers, asked
from app.view.files.remembered import last_folder, remember_folder
from app.view.wording import words
from app.view.wording.plain import Label
from starskel.errors import StarskelError
from starskel.files.disk import room_in
from starskel.limits import DOCUMENT_BYTES
from starskel.reading.readers import ENDINGS

translate = QCoreApplication.translate

PROJECT_ENDING = ".json"

_OWN_FOLDERS = (
    QStandardPaths.StandardLocation.DocumentsLocation,
    QStandardPaths.StandardLocation.HomeLocation,
)


class Answer(Enum):
    """What to do with changes."""

    SAVE = "save"
    DISCARD = "discard"
    ELSEWHERE = "elsewhere"
    CANCEL = "cancel"


def path_to_open(parent: QWidget) -> Path | None:
    """Ask for a project, a file of pairs or one with shapes; None where the user thinks better of it."""
    kinds = (
        translate("Dialogs", "All that can be opened ({endings})").format(endings=f"*.json {_shapes()}"),
        translate("Dialogs", "Projects and polygon pairs (*.json)"),
        translate("Dialogs", "Drawings, maps, pictures and fonts ({endings})").format(endings=_shapes()),
        translate("Dialogs", "All files (*)"),
    )
    return _path_to_read(parent, translate("Dialogs", "Open"), kinds)


def path_to_import(parent: QWidget) -> Path | None:
    """Ask for a file with shapes; None where the user thinks better of it."""
    kinds = (
        translate("Dialogs", "Drawings, maps, pictures and fonts ({endings})").format(endings=_shapes()),
        translate("Dialogs", "All files (*)"),
    )
    return _path_to_read(parent, translate("Dialogs", "Import shapes"), kinds)


def _shapes() -> str:
    return " ".join(f"*{ending}" for ending in ENDINGS)


def picture_to_open(parent: QWidget) -> Path | None:
    """Ask for a picture to draw over; None where the user thinks better of it."""
    endings = " ".join(f"*.{bytes(kind.data()).decode()}" for kind in QImageReader.supportedImageFormats())
    kinds = translate("Dialogs", "Pictures ({endings});;All files (*)").format(endings=endings)
    return _path_to_read(parent, translate("Dialogs", "Open picture"), [kinds])


def _path_to_read(parent: QWidget, title: str, kinds: Sequence[str]) -> Path | None:
    """Ask for a file, from where the last one was."""
    chosen, _ = QFileDialog.getOpenFileName(parent, title, str(last_folder()), ";;".join(kinds))
    if not chosen:
        return None
    path = Path(chosen)
    remember_folder(path.parent)
    return path


def path_to_save(
    parent: QWidget, title: str, name: str, endings: Sequence[str], folder: Path | None = None
) -> Path | None:
    """Ask where to write a file; None where the user thinks better of it.

    It begins in the folder given, else where the last file was.

    A name without an ending gets the one of the chosen kind. The dialog itself must know the ending: it asks
    before it lets a file be overwritten.
    """
    dialog = SaveDialog(parent, title, (folder or last_folder()) / f"{name}{endings[0]}", endings)
    if not accepted(dialog):
        return None
    path = Path(dialog.selectedFiles()[0])
    remember_folder(path.parent)
    return path


def folder_with_room(full: Path) -> Path:
    """Give a folder of the user's for a project that one folder would not take: the first with room for any.

    Where none has so much, it is the one with the most; where nothing can be written at all, that one.
    """
    own = (Path(QStandardPaths.writableLocation(kind)) for kind in _OWN_FOLDERS)
    room = {folder: room_in(folder) for folder in own if folder != full}
    enough = (folder for folder, free in room.items() if free >= DOCUMENT_BYTES)
    most = max(room, key=lambda folder: room[folder], default=full)
    return next(enough, most if room.get(most) else full)


class SaveDialog(QFileDialog):
    """Asks where to write a file in one of several formats."""

    def __init__(self, parent: QWidget, title: str, suggested: Path, endings: Sequence[str]) -> None:
        super().__init__(parent, title, str(suggested.parent))
        self._endings = {f"{ending[1:].upper()} (*{ending})": ending for ending in endings}
        self.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        self.setFileMode(QFileDialog.FileMode.AnyFile)
        self.setNameFilters(list(self._endings))
        self.setDefaultSuffix(endings[0][1:])
        self._suggest(suggested.name)
        self.filterSelected.connect(self._follow)

    @Slot(str)
    def _follow(self, kind: str) -> None:
        """Give the name the ending of the kind that was chosen."""
        ending = self._endings[kind]
        self.setDefaultSuffix(ending[1:])
        chosen = Path(self.selectedFiles()[0])
        if chosen.suffix in self._endings.values():
            self._suggest(chosen.with_suffix(ending).name)

    def _suggest(self, name: str) -> None:
        """Write a name into the field, and into the field alone.

        Qt selects a file of this name in the list as well. Until it has read the folder, typing does not take
        that back, and Enter would save to the file selected, not to the one typed.
        """
        self.selectFile(name)
        for files in self.findChildren(QAbstractItemView):
            files.clearSelection()


def ask_about_changes(parent: QWidget, name: str) -> Answer:
    """Ask whether to save unsaved changes before they would be lost."""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Question)
    box.setWindowTitle(translate("Dialogs", "Unsaved changes"))
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(translate("Dialogs", "Save the changes to “{name}”?").format(name=name))
    box.setInformativeText(translate("Dialogs", "Otherwise they are lost."))
    kind = QMessageBox.StandardButton
    box.setStandardButtons(kind.Save | kind.Discard | kind.Cancel)
    box.setDefaultButton(kind.Save)
    answers = {kind.Save: Answer.SAVE, kind.Discard: Answer.DISCARD}
    return answers.get(kind(asked(box)), Answer.CANCEL)


def ask_about_overtaking(parent: QWidget, path: Path) -> Answer:
    """Ask whether to overwrite what another program has written into the file meanwhile."""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setWindowTitle(translate("Dialogs", "Changed by another program"))
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(
        translate("Dialogs", "{name} was changed by another program since it was opened here.").format(
            name=path.name
        )
    )
    box.setInformativeText(translate("Dialogs", "Overwriting it loses what that program has written."))
    elsewhere = box.addButton(translate("Dialogs", "Save &Elsewhere…"), QMessageBox.ButtonRole.AcceptRole)
    overwrite = box.addButton(translate("Dialogs", "&Overwrite"), QMessageBox.ButtonRole.DestructiveRole)
    box.addButton(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(elsewhere)
    asked(box)
    clicked = box.clickedButton()
    if clicked == elsewhere:
        return Answer.ELSEWHERE
    return Answer.SAVE if clicked == overwrite else Answer.CANCEL


def ask_for_another_place(parent: QWidget, path: Path, error: StarskelError) -> bool:
    """Say why a file was not saved, and ask whether to save it elsewhere."""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setWindowTitle(translate("Dialogs", "Not saved"))
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(translate("Dialogs", "{name} was not saved").format(name=path.name))
    kept = translate("Dialogs", "The document is still open, with all its changes.")
    box.setInformativeText(words.sentences(error, "\n\n") + "\n\n" + kept)
    elsewhere = box.addButton(translate("Dialogs", "Save &Elsewhere…"), QMessageBox.ButtonRole.AcceptRole)
    box.addButton(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(elsewhere)
    asked(box)
    return box.clickedButton() == elsewhere


def may_overwrite(parent: QWidget, paths: Sequence[Path]) -> bool:
    """Ask whether files may be overwritten."""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setWindowTitle(translate("Dialogs", "Overwrite?"))
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(translate("Dialogs", "Files of these names are already there."))
    names = [path.name for path in paths[:5]] + (["…"] if len(paths) > 5 else [])
    box.setInformativeText("\n".join(names))
    write = box.addButton(translate("Dialogs", "&Overwrite"), QMessageBox.ButtonRole.AcceptRole)
    box.setDefaultButton(box.addButton(QMessageBox.StandardButton.Cancel))
    asked(box)
    return box.clickedButton() is write


def complain(parent: QWidget, heading: str, error: StarskelError) -> None:
    """Say what went wrong, where, and how to mend it."""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setWindowTitle(translate("Dialogs", "Not possible"))
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(heading)
    box.setInformativeText(words.sentences(error, "\n\n"))
    asked(box)


class PairDialog(QDialog):
    """Lets the user choose one of the pairs of a file."""

    def __init__(self, ids: Sequence[str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Choose a pair"))
        self.resize(360, 420)
        self._filter = QLineEdit()
        self._filter.setPlaceholderText(self.tr("Filter"))
        self._filter.setAccessibleName(self.tr("Filter"))
        self._filter.setClearButtonEnabled(True)
        self._filter.textChanged.connect(self._narrow)
        self._list = QListWidget()
        self._list.setAccessibleName(self.tr("Pairs"))
        self._list.addItems(list(ids))
        self._list.setCurrentRow(0)
        self._list.itemDoubleClicked.connect(self.accept)
        kind = QDialogButtonBox.StandardButton
        self._buttons = answers(self, kind.Open | kind.Cancel)
        layout = QVBoxLayout(self)
        layout.addWidget(Label(self.tr("The file holds {count} pairs of shapes.").format(count=len(ids))))
        for widget in (self._filter, self._list, self._buttons):
            layout.addWidget(widget)

    @property
    def chosen(self) -> str | None:
        """The pair chosen, None where the filter leaves none."""
        item = self._list.currentItem()
        return None if item is None or item.isHidden() else item.text()

    @Slot(str)
    def _narrow(self, text: str) -> None:
        found = self._list.findItems(text, Qt.MatchFlag.MatchContains)
        for row in range(self._list.count()):
            self._list.item(row).setHidden(self._list.item(row) not in found)
        if found:
            self._list.setCurrentItem(found[0])
        self._buttons.button(QDialogButtonBox.StandardButton.Open).setEnabled(bool(found))
