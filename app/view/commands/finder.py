"""The command finder: type a part of a command's name, press Enter."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt, Slot
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QDialog, QLineEdit, QTreeWidget, QTreeWidgetItem, QVBoxLayout, QWidget

_ROWS = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown)


def plain(action: QAction) -> str:
    """Give what an action is called, without the mark of its key."""
    return action.text().replace("&", "").rstrip("…")


def matches(text: str, wanted: str) -> bool:
    """Tell whether every word that is wanted is somewhere in a text."""
    return all(word in text.casefold() for word in wanted.casefold().split())


class Finder(QDialog):
    """Lists the commands that can be given now."""

    def __init__(self, actions: Sequence[QAction], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Find command"))
        self.resize(480, 420)
        self.chosen: QAction | None = None
        self._actions = [action for action in actions if action.isEnabled()]
        self._items: list[QTreeWidgetItem] = []
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("What do you want to do?"))
        self.field.setAccessibleName(self.tr("Part of a command's name"))
        self.field.setClearButtonEnabled(True)
        self.field.textChanged.connect(self._narrow)
        self.field.returnPressed.connect(self._take)
        self.field.installEventFilter(self)
        self.list = QTreeWidget()
        self.list.setAccessibleName(self.tr("Commands"))
        self.list.setColumnCount(2)
        self.list.setHeaderHidden(True)
        self.list.setRootIsDecorated(False)
        self.list.setUniformRowHeights(True)
        self.list.itemActivated.connect(self._take)
        layout = QVBoxLayout(self)
        layout.addWidget(self.field)
        layout.addWidget(self.list)
        self._fill()

    def _fill(self) -> None:
        native = QKeySequence.SequenceFormat.NativeText
        for action in self._actions:
            item = QTreeWidgetItem([plain(action), action.shortcut().toString(native)])
            item.setIcon(0, action.icon())
            item.setToolTip(0, action.statusTip())
            self._items.append(item)
        self.list.addTopLevelItems(self._items)
        self.list.resizeColumnToContents(0)
        self._narrow("")

    @Slot(str)
    def _narrow(self, wanted: str) -> None:
        """Show the commands that have the words in their names; where none has, in what is said of them."""
        named = [matches(plain(action), wanted) for action in self._actions]
        told = [matches(f"{plain(action)} {action.statusTip()}", wanted) for action in self._actions]
        for item, found in zip(self._items, named if any(named) else told, strict=True):
            item.setHidden(not found)
        first = next((item for item in self._items if not item.isHidden()), None)
        if first is not None:
            self.list.setCurrentItem(first)

    @Slot()
    def _take(self) -> None:
        item = self.list.currentItem()
        if item is not None and not item.isHidden():
            self.chosen = self._actions[self._items.index(item)]
            self.accept()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Let arrow keys in the field move through the list."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress and event.key() in _ROWS:
            self.list.event(event)
            return True
        return super().eventFilter(watched, event)
