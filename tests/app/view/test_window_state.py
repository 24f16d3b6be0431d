"""What is kept for the next start, and the first one."""

from pathlib import Path

from PySide6.QtWidgets import QComboBox
from pytestqt.qtbot import QtBot

from app.session import Session
from app.view.files import remembered
from app.view.main_window import FRAME, MainWindow
from app.view.start import begin
from app.view.window_state import keep_window, restore_window
from tests.app.driver import Driver, square_project


def test_the_window_comes_back_as_it_was_left(driver: Driver, tmp_path: Path, qtbot: QtBot) -> None:
    path = square_project(tmp_path / "last.json")
    first = driver.window
    driver.open(path)
    first.actions_table["pieces"].trigger()
    first.actions_table["history"].trigger()
    field(first, "repeat").setCurrentIndex(1)
    field(first, "speed").setCurrentIndex(0)
    keep_window(first, first.actions_table, first.session.path)
    second = MainWindow(Session())
    restore_window(second, second.actions_table)
    second.show()
    qtbot.waitExposed(second)
    try:
        assert second.display.layers.pieces
        assert not second.display.layers.skeleton
        assert second.history.isVisible()
        assert field(second, "repeat").currentIndex() == 1
        assert second.player.speed == first.player.speed < 1
        assert second.actions_table["history"].isChecked()
        begin(second, None)
        qtbot.waitUntil(lambda: second.session.path == path)
    finally:
        second.close()
        second.deleteLater()


def test_a_window_that_was_never_resized_leaves_room_for_its_frame(qtbot: QtBot) -> None:
    window = MainWindow(Session())
    window.show()
    qtbot.waitExposed(window)
    try:
        assert window.height() <= window.screen().availableSize().height() - FRAME.height()
    finally:
        window.close()
        window.deleteLater()


def field(window: MainWindow, name: str) -> QComboBox:
    found = window.findChild(QComboBox, name)
    assert found is not None
    return found


def test_a_first_start_shows_an_example_playing(window: MainWindow) -> None:
    begin(window, None)
    assert window.session.path is None
    assert window.player.playing


def test_the_theme_that_was_chosen_is_kept(window: MainWindow) -> None:
    assert remembered.theme_name() == ""
    window.actions_table["dark"].trigger()
    assert remembered.theme_name() == "dark"
    window.actions_table["light"].trigger()
    assert remembered.theme_name() == "light"
