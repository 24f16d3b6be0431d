"""Finding commands, their shortcuts, and what is kept from one time to the next."""

from collections.abc import Callable
from dataclasses import fields

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QMainWindow

from app.session import Session
from app.view.about import AboutDialog
from app.view.asking import asked
from app.view.canvas.options import SWITCHES
from app.view.commands.actions import Actions
from app.view.commands.finder import Finder
from app.view.commands.shortcuts import ShortcutsDialog, apply_shortcuts
from app.view.files.remembered import (
    remember_last_file,
    remember_layout,
    remember_playing,
    remember_switches,
    restore_layout,
    restore_playing,
    switches,
)
from app.view.manual import Manual
from app.view.painting.display import Layers
from app.view.wording import language

KEPT = (*SWITCHES, *(field.name for field in fields(Layers)))
"""The switches that are as they were at the next start: what the tools snap to, and what is shown."""


class Convenience(QObject):
    """The commands of the help menu, and those of the window as a whole."""

    def __init__(self, window: QMainWindow, session: Session) -> None:
        super().__init__(window)
        self._window = window
        self._session = session
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
        """Take the actions, when there are some."""
        self._actions = actions
        actions[f"language-{language.chosen()}"].setChecked(True)
        apply_shortcuts(actions.all)

    def restore(self) -> None:
        """Have window and switches as they were."""
        restore_layout(self._window)
        restore_playing(self._window)
        for name, on in switches().items():
            if self._actions is not None and name in KEPT and self._actions[name].isChecked() != on:
                self._actions[name].trigger()

    def keep(self) -> None:
        """Keep window, switches and the name of the file for the next start."""
        remember_layout(self._window)
        remember_playing(self._window)
        remember_last_file(self._session.path)
        if self._actions is not None:
            remember_switches({name: self._actions[name].isChecked() for name in KEPT})

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
