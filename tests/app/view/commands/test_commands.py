"""Commands found by their names, and the shortcuts that lead to them."""

from collections.abc import Callable

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton, QWidget

from app.view.commands.finder import Finder, matches
from app.view.commands.shortcuts import ShortcutsDialog, apply_shortcuts, changed_shortcuts
from app.view.main_window import MainWindow
from app.view.wording import words
from tests.app.driver import CONTROL, LEFT, SHIFT, Driver


def test_a_command_is_found_by_a_part_of_its_name(driver: Driver) -> None:
    def find(dialog: QWidget) -> None:
        assert isinstance(dialog, Finder)
        QTest.keyClicks(dialog.field, "pie star")
        QTest.keyClick(dialog.field, Qt.Key.Key_Return)

    driver.in_dialog(find)
    driver.key(Qt.Key.Key_K, CONTROL)
    assert driver.window.display.layers.pieces


def test_arrow_keys_choose_among_the_commands_found_and_escape_gives_none(driver: Driver) -> None:
    def choose(dialog: QWidget) -> None:
        assert isinstance(dialog, Finder)
        QTest.keyClicks(dialog.field, "zoom")
        first = dialog.list.currentItem()
        QTest.keyClick(dialog.field, Qt.Key.Key_Down)
        assert dialog.list.currentItem() is not first
        QTest.keyClick(dialog.field, Qt.Key.Key_Escape)

    scale = driver.window.canvases["source"].camera.scale
    driver.in_dialog(choose)
    driver.key(Qt.Key.Key_P, CONTROL | SHIFT)
    assert driver.window.canvases["source"].camera.scale == scale


def test_every_word_is_looked_for() -> None:
    assert matches("Mirror Left and Right", "right mir")
    assert not matches("Mirror Left and Right", "mirror up")
    assert matches("anything", "")


def in_shortcuts(driver: Driver, change: Callable[[QWidget], None]) -> None:
    """Open the dialog that changes shortcuts, and do something in it."""
    driver.in_dialog(change)
    driver.window.actions_table["shortcuts"].trigger()


def assign(dialog: QWidget, command: str, keys: str) -> None:
    assert isinstance(dialog, ShortcutsDialog)
    (item,) = dialog.list.findItems(command, Qt.MatchFlag.MatchExactly)
    dialog.list.setCurrentItem(item)
    dialog.keys.setKeySequence(QKeySequence(keys))
    QTest.mouseClick(dialog.assign, LEFT)


def assigning(command: str, keys: str) -> Callable[[QWidget], None]:
    def change(dialog: QWidget) -> None:
        assign(dialog, command, keys)
        dialog.close()

    return change


def test_a_shortcut_is_changed_works_at_once_and_is_kept(driver: Driver) -> None:
    in_shortcuts(driver, assigning("Star Pieces", "Ctrl+J"))
    driver.key(Qt.Key.Key_J, CONTROL)
    assert driver.window.display.layers.pieces
    driver.key(Qt.Key.Key_1, CONTROL)
    assert driver.window.display.layers.pieces, "the old key does nothing any more"
    assert changed_shortcuts() == {"pieces": "Ctrl+J"}


def test_a_shortcut_that_is_taken_changes_hands_after_a_warning(driver: Driver) -> None:
    def change(dialog: QWidget) -> None:
        assert isinstance(dialog, ShortcutsDialog)
        (item,) = dialog.list.findItems("Star Pieces", Qt.MatchFlag.MatchExactly)
        dialog.list.setCurrentItem(item)
        dialog.keys.setKeySequence(QKeySequence("Ctrl+2"))
        assert "Skeleton" in dialog.note.text()
        assign(dialog, "Star Pieces", "Ctrl+2")
        dialog.close()

    in_shortcuts(driver, change)
    driver.key(Qt.Key.Key_2, CONTROL)
    assert driver.window.display.layers.pieces
    assert not driver.window.display.layers.skeleton
    assert changed_shortcuts() == {"pieces": "Ctrl+2", "skeleton": ""}


def test_a_command_with_two_shortcuts_loses_only_the_one_that_is_taken(driver: Driver) -> None:
    in_shortcuts(driver, assigning("Star Pieces", "Ctrl+Y"))
    assert driver.window.actions_table["redo"].shortcuts() == [QKeySequence("Ctrl+Shift+Z")]
    apply_shortcuts(driver.window.actions_table.all)
    assert driver.window.actions_table["redo"].shortcuts() == [QKeySequence("Ctrl+Shift+Z")]
    assert driver.window.actions_table["pieces"].shortcuts() == [QKeySequence("Ctrl+Y")]


def test_the_usual_shortcuts_come_back(driver: Driver) -> None:
    def change(dialog: QWidget) -> None:
        assign(dialog, "Star Pieces", "Ctrl+J")
        usual = next(b for b in dialog.findChildren(QPushButton) if b.text() == "&Usual Shortcuts")
        QTest.mouseClick(usual, LEFT)
        dialog.close()

    in_shortcuts(driver, change)
    assert changed_shortcuts() == {}
    assert driver.window.actions_table["pieces"].shortcut() == QKeySequence("Ctrl+1")


def test_a_menu_of_switches_stays_open_while_they_are_clicked(window: MainWindow) -> None:
    menu = window._methods
    menu.popup(window.mapToGlobal(QPoint(50, 50)))
    for action in menu.actions():
        was, place = action.isChecked(), menu.actionGeometry(action).center()
        QTest.mouseClick(menu, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)
        assert action.isChecked() is not was or sum(each.isChecked() for each in menu.actions()) == 1
        assert menu.isVisible()
        assert action.toolTip() == words.method_tip(action.data())
    menu.close()
