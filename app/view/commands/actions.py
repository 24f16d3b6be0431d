"""A QAction for every command of the table."""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QPalette
from PySide6.QtWidgets import QWidget

from app.view.commands.command import Command
from app.view.commands.table import COMMANDS
from app.view.painting.icons import icon


def say(text: object) -> str:
    """Give a text of the table in the user's language."""
    return QCoreApplication.translate("Command", str(text))


class Actions:
    """A QAction for every command.

    Parameters
    ----------
    parent : QWidget
        What owns them, and whose colours their icons have: a button made of them has its size at once.
    handlers : mapping of str to callable
        For each command what it does; that of a switch is called after it was switched.
    """

    def __init__(self, parent: QWidget, handlers: Mapping[str, Callable[[], object]]) -> None:
        self._actions: dict[str, QAction] = {}
        groups: dict[str, QActionGroup] = {}
        for command in COMMANDS:
            action = _action(command, parent)
            action.triggered.connect(handlers[command.name])
            if command.group:
                group = groups.setdefault(command.group, QActionGroup(parent))
                group.addAction(action)
            self._actions[command.name] = action
        self.dress(parent.palette())

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def __contains__(self, name: str) -> bool:
        return name in self._actions

    @property
    def all(self) -> list[QAction]:
        """All of them, in the order of the table."""
        return list(self._actions.values())

    def dress(self, palette: QPalette) -> None:
        """Draw the icons in the palette's colours."""
        for name, action in self._actions.items():
            action.setIcon(icon(name, palette))


def _action(command: Command, parent: QObject) -> QAction:
    action = QAction(say(command.text), parent)
    action.setObjectName(command.name)
    action.setCheckable(command.checkable)
    action.setShortcuts([QKeySequence(keys) for keys in command.keys])
    action.setStatusTip(say(command.tip))
    keys = f" ({action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)})" if command.keys else ""
    action.setToolTip(say(command.tip) + keys)
    return action
