"""Files that were open, and the examples, in menus."""

from pathlib import Path

from app.view.files import remembered
from app.view.files.project_menus import LARGE
from app.view.main_window import MainWindow
from tests.app.driver import Driver, square_project


def test_opened_and_saved_files_are_offered_again_the_last_one_first(driver: Driver, tmp_path: Path) -> None:
    paths = [square_project(tmp_path / f"{name}.json") for name in ("one", "two & a half", "three")]
    for path in paths:
        driver.open(path)
    driver.save(paths[0])
    driver.window.files.save()
    menu = driver.window.recent
    menu.aboutToShow.emit()
    assert [action.text() for action in menu.actions()[:3]] == ["one", "three", "two && a half"]
    assert not menu.actions()[0].icon().isNull()
    assert menu.actions()[0].toolTip() == str(paths[0])
    menu.actions()[2].trigger()
    driver.wait_until_read()
    assert driver.session.path == paths[1]


def test_files_that_are_gone_are_not_offered_and_the_list_can_be_cleared(
    driver: Driver, tmp_path: Path
) -> None:
    kept, gone = square_project(tmp_path / "kept.json"), square_project(tmp_path / "gone.json")
    for path in (kept, gone):
        driver.open(path)
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
    path = square_project(tmp_path / "large.json")
    driver.open(path)
    path.write_text(path.read_text() + " " * LARGE)
    driver.window.recent.aboutToShow.emit()
    entry = driver.window.recent.actions()[0]
    assert (entry.text(), entry.icon().isNull()) == ("large", True)
    entry.trigger()
    driver.wait_until_read()
    assert driver.session.path == path
