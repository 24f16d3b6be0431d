"""Recent files, dropped files, what is kept for the next start, the history, finding commands, shortcuts."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDesktopServices, QDragEnterEvent, QDropEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QMessageBox, QPushButton, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from app.session import Session
from app.tools.tool import Key
from app.view.about import AboutDialog, versions
from app.view.files import remembered
from app.view.files.project_menus import LARGE
from app.view.main_window import FRAME, MainWindow
from app.view.start import begin
from starskel.files.key_shape import KeyShape
from starskel.files.project import Project
from starskel.files.project_file import write_project
from starskel.files.step import Step
from starskel.polygon import Polygon
from tests.app.driver import CONTROL, LEFT, PLAIN, SQUARE, Driver

SHAPE = Polygon(SQUARE)


def project(path: Path) -> Path:
    write_project(path, Project(path.stem, (KeyShape.of(SHAPE),) * 2, (Step.of(),), ("vertex",)))
    return path


def drop(driver: Driver, path: Path, on: QWidget) -> bool:
    """Drop a file as a file manager does; tell whether it was taken."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    copy, left, place = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton, QPoint(60, 60)
    entering = QDragEnterEvent(place, copy, data, left, PLAIN)
    QApplication.sendEvent(on, entering)
    if entering.isAccepted():
        QApplication.sendEvent(on, QDropEvent(QPointF(place), copy, data, left, PLAIN))
    return entering.isAccepted()


def with_dialog(driver: Driver, kind: type[QWidget], act: Callable[[QWidget], None]) -> None:
    def check(dialog: QWidget) -> None:
        assert isinstance(dialog, kind)
        act(dialog)

    driver.in_dialog(check)


# recent files


def test_opened_and_saved_files_are_offered_again_the_last_one_first(driver: Driver, tmp_path: Path) -> None:
    paths = [project(tmp_path / f"{name}.json") for name in ("one", "two & a half", "three")]
    for path in paths:
        driver.window.files.open(path)
    driver.session.save(paths[0])
    driver.window.files.save()
    menu = driver.window.recent
    menu.aboutToShow.emit()
    assert [action.text() for action in menu.actions()[:3]] == ["one", "three", "two && a half"]
    assert not menu.actions()[0].icon().isNull()
    assert menu.actions()[0].toolTip() == str(paths[0])
    menu.actions()[2].trigger()
    assert driver.session.path == paths[1]


def test_files_that_are_gone_are_not_offered_and_the_list_can_be_cleared(
    driver: Driver, tmp_path: Path
) -> None:
    kept, gone = project(tmp_path / "kept.json"), project(tmp_path / "gone.json")
    for path in (kept, gone):
        driver.window.files.open(path)
    gone.unlink()
    assert remembered.recent_files() == (kept,)
    driver.window.recent.aboutToShow.emit()
    driver.window.recent.actions()[-1].trigger()
    assert remembered.recent_files() == ()


def test_no_more_files_are_remembered_than_a_menu_should_hold(tmp_path: Path) -> None:
    for number in range(remembered.RECENT + 3):
        path = tmp_path / f"{number}.json"
        path.touch()
        remembered.remember_file(path)
    assert len(remembered.recent_files()) == remembered.RECENT
    assert remembered.recent_files()[0] == path


def test_every_example_has_a_picture(window: MainWindow) -> None:
    menu = window._examples
    menu.aboutToShow.emit()
    entries = [action for action in menu.actions() if action.data() is not None]
    assert entries
    assert not any(action.icon().isNull() for action in entries)
    menu.aboutToShow.emit()
    assert [action for action in menu.actions() if action.data() is not None] == entries


def test_a_large_file_is_offered_without_being_read(driver: Driver, tmp_path: Path) -> None:
    path = project(tmp_path / "large.json")
    driver.window.files.open(path)
    path.write_text(path.read_text() + " " * LARGE)
    driver.window.recent.aboutToShow.emit()
    entry = driver.window.recent.actions()[0]
    assert (entry.text(), entry.icon().isNull()) == ("large", True)
    entry.trigger()
    assert driver.session.path == path


# dropped files


def test_a_dropped_project_is_opened_after_the_question_about_changes(driver: Driver, tmp_path: Path) -> None:
    path = project(tmp_path / "dropped.json")
    driver.draw("source", SQUARE)

    def discard(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        QTest.mouseClick(dialog.button(QMessageBox.StandardButton.Discard), LEFT)

    driver.in_dialog(discard)
    assert drop(driver, path, driver.window.canvases["target"])
    driver.wait(lambda: driver.session.path == path)


@pytest.mark.parametrize("side", ["source", "target"])
def test_a_dropped_svg_becomes_the_shape_of_the_canvas_under_it(
    driver: Driver, tmp_path: Path, side: str
) -> None:
    path = tmp_path / "outline.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L10 0 L10 10 Z"/></svg>')
    assert drop(driver, path, driver.window.canvases[side])  # type: ignore[index]
    driver.wait(lambda: driver.document.polygon(side) is not None)  # type: ignore[arg-type]
    assert driver.session.undoes == "Import shapes"


def test_an_svg_without_outlines_is_refused_with_the_reason(driver: Driver, tmp_path: Path) -> None:
    path = tmp_path / "empty.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
    drop(driver, path, driver.window.canvases["source"])
    driver.wait(lambda: driver.session.refusal is not None)
    assert "empty.svg" in str(driver.session.refusal and driver.session.refusal.error)


def test_other_files_are_not_taken_by_the_window(driver: Driver, tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.touch()
    assert not drop(driver, path, driver.window)


# what is kept


def test_the_window_comes_back_as_it_was_left(driver: Driver, tmp_path: Path, qtbot) -> None:  # type: ignore[no-untyped-def]
    path = project(tmp_path / "last.json")
    first = driver.window
    first.files.open(path)
    first.actions_table["pieces"].trigger()
    first.actions_table["history"].trigger()
    field(first, "repeat").setCurrentIndex(1)
    field(first, "speed").setCurrentIndex(0)
    first.convenience.keep()
    second = MainWindow(Session())
    second.convenience.restore()
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
        assert second.session.path == path
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


# history


def test_a_click_in_the_history_goes_there(driver: Driver) -> None:
    driver.draw_both()
    driver.mark((10, 10), (10, 10))
    driver.key(Qt.Key.Key_H, CONTROL)
    shown = driver.window.history
    assert shown.isVisible()
    assert [shown.item(row).text() for row in range(shown.count())] == [
        "Opened",
        "Draw shape",
        "Draw shape",
        "Set mark",
    ]
    assert shown.currentRow() == 3
    QTest.mouseClick(shown.viewport(), LEFT, PLAIN, shown.visualItemRect(shown.item(1)).center())
    assert driver.document.target is None
    assert driver.session.redoes == "Draw shape"
    for _ in range(2):
        QTest.keyClick(shown, Qt.Key.Key_Down)
    assert driver.document.marks == ((0, 0),)
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert shown.currentRow() == 2


def test_the_history_greys_out_what_is_undone_and_catches_up_when_it_is_shown(driver: Driver) -> None:
    driver.draw_both()
    shown, command = driver.window.history, driver.window.actions_table["history"]

    def rows() -> list[tuple[str, bool]]:
        items = [shown.item(row) for row in range(shown.count())]
        undone = shown.palette().brush(shown.palette().ColorGroup.Disabled, shown.palette().ColorRole.Text)
        return [(item.text(), item.foreground() == undone) for item in items]

    command.trigger()
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert rows() == [("Opened", False), ("Draw shape", False), ("Draw shape", True)]
    driver.window.actions_table["dark"].trigger()
    assert rows()[2] == ("Draw shape", True)
    command.trigger()
    driver.session.select_all("source")
    driver.session.key(Key("right"))
    driver.session.key(Key("right", alt=True))
    command.trigger()
    assert rows() == [("Opened", False), ("Draw shape", False), ("Nudge vertices", False), ("Turn", False)]
    driver.key(Qt.Key.Key_Z, CONTROL)
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert [undone for _, undone in rows()] == [False, False, True, True]
    driver.window.actions_table["light"].trigger()


# about, progress, notices


def test_the_versions_can_be_copied(driver: Driver) -> None:
    def copy(dialog: QWidget) -> None:
        button = dialog.findChild(QPushButton, "copy-versions")
        assert button is not None
        QTest.mouseClick(button, LEFT)
        dialog.close()

    with_dialog(driver, AboutDialog, copy)
    driver.window.actions_table["about"].trigger()
    assert QGuiApplication.clipboard().text() == versions()
    assert "numpy" in versions()
    assert "Python" in versions()


def test_the_folder_of_an_export_is_a_click_away(
    driver: Driver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[QUrl] = []
    monkeypatch.setattr(QDesktopServices, "openUrl", opened.append)
    button = driver.window.findChild(QToolButton, "open-folder")
    assert button is not None
    assert not button.isVisible()
    driver.window.files.exported.emit(tmp_path / "row.svg")
    assert "row.svg" in driver.window.statusBar().currentMessage()
    QTest.mouseClick(button, LEFT)
    assert [url.toLocalFile() for url in opened] == [str(tmp_path)]
