"""A walk through the whole table: each command is in a menu, in the finder and in the list of shortcuts."""

from PySide6.QtGui import QAccessible, QAction
from PySide6.QtWidgets import QMenu, QTreeWidget, QWidget

from app.view.commands.finder import Finder, plain
from app.view.commands.shortcuts import ShortcutsDialog
from app.view.commands.table import COMMANDS
from app.view.main_window import MainWindow


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
