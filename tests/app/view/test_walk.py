"""A walk through the whole table: each command is in a menu, in the finder and in the list of shortcuts."""

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible, QAction, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QTreeWidget, QWidget

from app.view.commands.finder import Finder, plain
from app.view.commands.shortcuts import ShortcutsDialog
from app.view.commands.table import COMMANDS
from app.view.main_window import MainWindow

LEFT = Qt.MouseButton.LeftButton


def names_told(root: QWidget) -> set[str]:
    """Give what a screen reader says of the entries of a menu, or of the first column of a list."""
    told = QAccessible.queryAccessibleInterface(root)
    names = [told.child(k).text(QAccessible.Text.Name) for k in range(told.childCount())]
    return {name.rstrip("…") for name in names}


def test_every_command_is_in_a_menu_the_finder_and_the_list_of_shortcuts(window: MainWindow) -> None:
    table = {command.name: window.actions_table[command.name] for command in COMMANDS}
    for action in table.values():
        action.setEnabled(True)  # the finder shows what can be done now
    in_menus = {name for menu in window.menuBar().findChildren(QMenu) for name in names_told(menu)}
    found, listed = shown_by(Finder, list(table.values())), shown_by(ShortcutsDialog, list(table.values()))
    for name, action in table.items():
        assert plain(action), name
        assert plain(action) in in_menus, name
        assert plain(action) in found, name
        assert plain(action) in listed, name


def shown_by(kind: type[Finder] | type[ShortcutsDialog], actions: list[QAction]) -> set[str]:
    dialog = kind(actions)
    dialog.show()
    names = names_told(dialog.findChild(QTreeWidget))
    dialog.close()
    dialog.deleteLater()
    return names


def test_every_command_is_given_by_clicking_its_entry(window: MainWindow) -> None:
    """By real events: the menu bar is clicked, menus inside are opened, the entry is clicked."""
    bar, table = window.menuBar(), {window.actions_table[row.name] for row in COMMANDS}
    entries = [(top, path) for top in bar.actions() for path in paths_in(top.menu()) if path[-1] in table]
    assert len(entries) == len(COMMANDS)
    for top, path in entries:
        given: list[QAction] = []
        action = path[-1]
        action.setEnabled(True)
        action.triggered.disconnect()  # the click is what is tried here, not what comes of it
        action.triggered.connect(partial(given.append, action))
        QTest.mouseClick(bar, LEFT, pos=bar.actionGeometry(top).center())
        for step in path:
            menu = QApplication.activePopupWidget()
            assert isinstance(menu, QMenu), action.text()
            QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(step).center())
        assert given == [action], action.text()
        assert QApplication.activePopupWidget() is None


def paths_in(menu: QMenu) -> list[list[QAction]]:
    """Give for each entry of a menu, and of those inside it, what is clicked to reach it."""
    steps = [action for action in menu.actions() if not action.isSeparator() and action.isVisible()]
    return [
        [step, *inner]
        for step in steps
        for inner in (paths_in(step.menu()) if step.menu() is not None else [[]])
    ]


def test_every_command_is_given_by_its_keys(window: MainWindow) -> None:
    window.canvases["source"].setFocus()
    for command in COMMANDS:
        given: list[QAction] = []
        action = window.actions_table[command.name]
        action.setEnabled(True)
        action.triggered.disconnect()
        action.triggered.connect(partial(given.append, action))
        for keys in command.keys:
            QTest.keySequence(window.canvases["source"], QKeySequence(keys))
        assert given == [action] * len(command.keys), command.name
