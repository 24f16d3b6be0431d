"""Shortcuts that the user has changed, and the dialog that changes them."""

from collections.abc import Sequence

from PySide6.QtCore import QSettings, Slot
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QKeySequenceEdit,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.view.asking import answers
from app.view.commands.finder import matches, plain
from app.view.commands.table import COMMANDS
from app.view.wording.plain import Label

_GROUP = "shortcuts"
_NATIVE = QKeySequence.SequenceFormat.NativeText
_PORTABLE = QKeySequence.SequenceFormat.PortableText

USUAL = {command.name: tuple(QKeySequence(keys) for keys in command.keys) for command in COMMANDS}
"""The shortcuts of each command until the user changes them."""


def changed_shortcuts() -> dict[str, str]:
    """Give the shortcuts in portable form for each command whose shortcuts the user has changed."""
    settings = QSettings()
    settings.beginGroup(_GROUP)
    return {name: str(settings.value(name)) for name in settings.childKeys() if name in USUAL}


def apply_shortcuts(actions: Sequence[QAction]) -> None:
    """Give all actions their shortcuts, changed or usual."""
    changed = changed_shortcuts()
    for action in actions:
        name = action.objectName()
        keys = QKeySequence.listFromString(changed[name], _PORTABLE) if name in changed else USUAL[name]
        action.setShortcuts([each for each in keys if not each.isEmpty()])
        shown = f" ({action.shortcut().toString(_NATIVE)})" if action.shortcuts() else ""
        action.setToolTip(action.statusTip() + shown)


def remember_shortcuts(name: str, keys: Sequence[QKeySequence]) -> None:
    """Keep a command's shortcuts, where they are not the usual ones; none means none at all."""
    settings = QSettings()
    settings.beginGroup(_GROUP)
    if tuple(keys) == USUAL[name]:
        settings.remove(name)
    else:
        settings.setValue(name, QKeySequence.listToString(keys, _PORTABLE))


def forget_shortcuts() -> None:
    """Go back to the usual shortcuts."""
    QSettings().remove(_GROUP)


class ShortcutsDialog(QDialog):
    """Shows all commands with their shortcuts; the one that is chosen gets the keys that are pressed."""

    def __init__(self, actions: Sequence[QAction], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Keyboard shortcuts"))
        self.resize(560, 520)
        self._actions = list(actions)
        self._items: list[QTreeWidgetItem] = []
        self.filter = QLineEdit()
        self.filter.setPlaceholderText(self.tr("Filter"))
        self.filter.setAccessibleName(self.tr("Filter"))
        self.filter.textChanged.connect(self._narrow)
        self.list = QTreeWidget()
        self.list.setAccessibleName(self.tr("Commands"))
        self.list.setHeaderLabels([self.tr("Command"), self.tr("Shortcut")])
        self.list.setRootIsDecorated(False)
        self.list.currentItemChanged.connect(self._show)
        self.keys = QKeySequenceEdit()
        self.keys.setObjectName("keys")
        self.keys.setAccessibleName(self.tr("New shortcut"))
        self.keys.setMaximumSequenceLength(1)
        self.keys.keySequenceChanged.connect(self._warn)
        self.assign = QPushButton(self.tr("&Assign"))
        self.assign.clicked.connect(self._assign)
        self.note = Label(wrapped=True)
        self._arrange()
        self._fill()

    def _arrange(self) -> None:
        row = QHBoxLayout()
        label = Label(self.tr("&New shortcut:"))
        label.setBuddy(self.keys)
        row.addWidget(label)
        row.addWidget(self.keys, 1)
        row.addWidget(self.assign)
        buttons = answers(self, QDialogButtonBox.StandardButton.Close)
        usual = buttons.addButton(self.tr("&Usual Shortcuts"), QDialogButtonBox.ButtonRole.ResetRole)
        usual.clicked.connect(self._reset)
        layout = QVBoxLayout(self)
        layout.addWidget(self.filter)
        layout.addWidget(self.list, 1)
        layout.addLayout(row)
        layout.addWidget(self.note)
        layout.addWidget(buttons)

    def _fill(self) -> None:
        for action in self._actions:
            item = QTreeWidgetItem([plain(action), ""])
            item.setToolTip(0, action.statusTip())
            self._items.append(item)
        self.list.addTopLevelItems(self._items)
        self._follow()
        self.list.resizeColumnToContents(0)
        self.list.setCurrentItem(self._items[0])

    def _follow(self) -> None:
        apply_shortcuts(self._actions)
        for action, item in zip(self._actions, self._items, strict=True):
            item.setText(1, ", ".join(each.toString(_NATIVE) for each in action.shortcuts()))

    @property
    def _action(self) -> QAction:
        item = self.list.currentItem()
        return self._actions[0 if item is None else self._items.index(item)]

    def _holder(self, keys: QKeySequence) -> QAction | None:
        """Give the other command that has a shortcut already."""
        others = (action for action in self._actions if action is not self._action)
        return next((a for a in others if not keys.isEmpty() and keys in a.shortcuts()), None)

    @Slot(str)
    def _narrow(self, wanted: str) -> None:
        for item in self._items:
            item.setHidden(not matches(item.text(0), wanted))

    @Slot()
    def _show(self) -> None:
        self.keys.setKeySequence(self._action.shortcut())
        self.note.clear()

    @Slot()
    def _warn(self) -> None:
        holder = self._holder(self.keys.keySequence())
        text = self.tr("“{command}” has this shortcut now; assigned here, it loses it.")
        self.note.setText("" if holder is None else text.format(command=plain(holder)))

    @Slot()
    def _assign(self) -> None:
        keys, name = self.keys.keySequence(), self._action.objectName()
        holder = self._holder(keys)
        if holder is not None:
            remember_shortcuts(holder.objectName(), [each for each in holder.shortcuts() if each != keys])
        usual = USUAL[name] if keys in USUAL[name][:1] else [keys]
        remember_shortcuts(name, [each for each in usual if not each.isEmpty()])
        self._follow()
        self.note.clear()

    @Slot()
    def _reset(self) -> None:
        forget_shortcuts()
        self._follow()
        self._show()
