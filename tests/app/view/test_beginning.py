from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from app.view.beginning import begun
from app.view.main_window import MainWindow
from tests.app.driver import Driver


def test_how_to_begin_is_shown_beside_the_canvases_until_it_is_put_away(
    driver: Driver, window: MainWindow
) -> None:
    switch = window.actions_table["begin"]
    assert not window.beginning.isVisible()
    assert not begun()
    switch.trigger()
    assert window.beginning.isVisible()
    driver.wait(lambda: window.canvases["source"].y() >= 0)
    lower = window.beginning.mapTo(window, window.beginning.rect().bottomLeft()).y()
    assert all(
        canvas.mapTo(window, canvas.rect().topLeft()).y() > lower for canvas in window.canvases.values()
    )
    QTest.mouseClick(window.beginning.close_button, Qt.MouseButton.LeftButton)
    assert not window.beginning.isVisible()
    assert not switch.isChecked()
    assert begun()


def test_what_was_put_away_comes_again_from_the_help_menu(window: MainWindow) -> None:
    window.actions_table["begin"].trigger()
    window.actions_table["begin"].trigger()
    window.actions_table["begin"].trigger()
    assert window.beginning.isVisible()
    assert window.actions_table["begin"].isChecked()


def test_the_lines_name_the_keys_that_the_user_has_set(window: MainWindow) -> None:
    def lines() -> str:
        return " ".join(label.text() for label in window.beginning.findChildren(QLabel))

    assert "P plays" in lines()
    window.actions_table["play"].setShortcut(QKeySequence("Ctrl+7"))
    assert "Ctrl+7 plays" in lines()
    window.actions_table["play"].setShortcut(QKeySequence())
    assert "Play plays" in lines()
