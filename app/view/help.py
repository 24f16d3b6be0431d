"""Help: finding commands and their shortcuts, the manual, and what the program is."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QMainWindow

from app.view.about import AboutDialog
from app.view.asking import asked
from app.view.commands.actions import Actions
from app.view.commands.finder import Finder
from app.view.commands.shortcuts import ShortcutsDialog, apply_shortcuts
from app.view.manual import Manual


class Help(QObject):
    """The commands of the help menu."""

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._actions: Actions | None = None

    def handlers(self) -> dict[str, Callable[[], object]]:
        """Give for each command what it does."""
        return {
            "find-command": self._find,
            "shortcuts": self._change_shortcuts,
            "about": self._tell,
            "manual": self._show_manual,
        }

    def begin(self, actions: Actions) -> None:
        """Take the actions, when there are some, and give them the user's shortcuts."""
        self._actions = actions
        apply_shortcuts(actions.all)

    @Slot()
    def _find(self) -> None:
        """Let a command be found, and give it when the dialog is gone."""
        assert self._actions is not None
        finder = Finder(self._actions.all, self._window)
        asked(finder)
        chosen = finder.chosen
        if chosen is not None:
            chosen.trigger()

    @Slot()
    def _change_shortcuts(self) -> None:
        assert self._actions is not None
        asked(ShortcutsDialog(self._actions.all, self._window))

    @Slot()
    def _show_manual(self) -> None:
        """Show the manual, or the one that is open already."""
        manual = self._window.findChild(Manual) or Manual(self._window)
        manual.show()
        manual.raise_()
        manual.activateWindow()

    @Slot()
    def _tell(self) -> None:
        asked(AboutDialog(self._window))
