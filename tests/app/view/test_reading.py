"""Files that take long to read: the window goes on, and nothing that is done meanwhile is lost."""

from collections.abc import Iterator
from pathlib import Path
from threading import Event

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox, QWidget

from app.view.files import files
from app.view.status import Status
from starskel.errors import Cancelled
from starskel.files.projects.examples import example
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import read_project, write_project
from starskel.task import Task
from tests.app.driver import CONTROL, SQUARE, Driver

Kind = QMessageBox.StandardButton


@pytest.fixture
def reading(monkeypatch: pytest.MonkeyPatch) -> Iterator[Event]:
    """Let nothing be read to its end until this is set."""
    may_end = Event()

    def slow(path: Path, task: Task) -> Project:
        while not may_end.wait(0.01):
            task.reach(0.5)
        return read_project(path, task)

    monkeypatch.setattr(files, "read_project", slow)
    yield may_end
    may_end.set()


def stored(path: Path, name: str = "arm") -> Path:
    write_project(path, example(name))
    return path


def status(driver: Driver) -> Status:
    bar = driver.window.statusBar()
    assert isinstance(bar, Status)
    return bar


def test_the_window_goes_on_while_a_file_is_read_and_says_so(
    driver: Driver, tmp_path: Path, reading: Event
) -> None:
    driver.window.files.open(stored(tmp_path / "slow.json"))
    driver.wait(lambda: status(driver).reading.text.text() == "Reading slow.json…")
    assert status(driver).reading.isVisible()
    driver.draw("source", SQUARE)
    assert driver.document.source is not None
    driver.session.undo()
    reading.set()
    driver.wait(lambda: driver.session.path == tmp_path / "slow.json")
    assert not status(driver).reading.isVisible()


@pytest.mark.parametrize("answer", [Kind.Cancel, Kind.Discard])
@pytest.mark.parametrize("closed", [True, False])
def test_what_is_drawn_meanwhile_is_asked_about(
    driver: Driver, tmp_path: Path, reading: Event, answer: Kind, closed: bool
) -> None:
    asked: list[str] = []

    def act(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        asked.append(dialog.text())
        dialog.button(answer).click()

    driver.window.files.open(stored(tmp_path / "slow.json"))
    driver.key(Qt.Key.Key_D)
    driver.click("source", *SQUARE)
    if closed:
        driver.key(Qt.Key.Key_Return)
    driver.in_dialog(act)
    reading.set()
    driver.wait(lambda: bool(asked) and not driver.window.importing.reader.busy)
    assert (driver.session.path is None) is (answer is Kind.Cancel)
    assert (driver.corners("source")[2:3] == [[90, 90]]) is (answer is Kind.Cancel)


def test_the_newest_file_is_the_one_that_opens(driver: Driver, tmp_path: Path, reading: Event) -> None:
    driver.window.files.open(stored(tmp_path / "old.json"))
    driver.window.files.open(stored(tmp_path / "new.json", "star"))
    reading.set()
    driver.wait_until_read()
    assert driver.session.path == tmp_path / "new.json"


@pytest.mark.parametrize("how", ["escape", "new", "close"])
def test_reading_can_be_given_up(driver: Driver, tmp_path: Path, reading: Event, how: str) -> None:
    driver.window.files.open(stored(tmp_path / "slow.json"))
    if how == "escape":
        driver.key(Qt.Key.Key_Escape)
    elif how == "new":
        driver.key(Qt.Key.Key_N, CONTROL)
    else:
        driver.window.close()
    assert not driver.window.importing.reader.busy
    reading.set()
    assert driver.session.path is None


def test_reading_tells_how_far_it_is_and_stops_between_two_rings(tmp_path: Path) -> None:
    path = stored(tmp_path / "face.json", "letters-b-8")
    told: list[float] = []
    read_project(path, Task(told.append))
    assert told[0] == 0
    assert told == sorted(told)
    assert len(told) > 2
    with pytest.raises(Cancelled):
        read_project(path, Task(should_stop=lambda: True))
