"""Saving where it fails, and what is left after a crash: with real disks, real crashes and real dialogs."""

import json
import shutil
from dataclasses import replace
from pathlib import Path
from threading import Event

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QFileDialog, QMessageBox, QPushButton, QWidget

from app.model.document import Document
from app.model.filing import Filed, stored
from app.recovery.places import Place, state_folder
from app.recovery.record import Record, write_record
from app.view.files import files
from app.view.files.dialogs import folder_with_room
from app.view.files.recovery_dialog import RecoveryDialog
from app.view.files.waiting import Waiting
from app.view.start import begin
from starskel.files.file_name import file_name_of
from starskel.files.projects.examples import example
from starskel.files.projects.project_file import read_project, write_project
from tests.app.driver import CONTROL, SQUARE, Driver, name_file
from tests.disks import filled, read_only, small_disk

pytestmark = pytest.mark.usefixtures("own_dialogs")


def click(dialog: QWidget, text: str) -> None:
    """Click the button that says this."""
    (button,) = [each for each in dialog.findChildren(QPushButton) if each.text().replace("&", "") == text]
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def saved(driver: Driver, path: Path) -> Path:
    """Draw and save."""
    driver.draw("source", SQUARE)
    driver.save(path)
    return path


def changed(driver: Driver) -> None:
    driver.draw("target", SQUARE)
    assert driver.session.unsaved


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Let the user have a home, without a folder for documents."""
    home = tmp_path / "home"
    home.mkdir()
    monkeypatch.setenv("HOME", str(home))
    return home


def save_elsewhere(driver: Driver, home: Path, expected: str) -> list[str]:
    """Press Ctrl+S, which fails, and take the offer of another place, which has room."""
    said: list[str] = []

    def name(dialog: QWidget) -> None:
        assert isinstance(dialog, QFileDialog)
        assert dialog.selectedFiles() == [str(home / "a.json")]
        name_file(dialog, "elsewhere.json")

    def answer(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        said.append(f"{dialog.text()} {dialog.informativeText()}")
        driver.in_dialog(name)
        click(dialog, "Save Elsewhere…")

    driver.in_dialog(answer)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert expected in said[0], said
    return said


def test_on_a_full_disk_it_is_said_the_old_file_stays_and_another_place_is_offered(
    driver: Driver, home: Path, tmp_path: Path
) -> None:
    with small_disk(tmp_path / "small") as disk:
        path = saved(driver, disk / "a.json")
        old = path.read_bytes()
        changed(driver)
        with filled(disk):
            save_elsewhere(driver, home, "No space left on device")
        assert path.read_bytes() == old
        assert sorted(each.name for each in disk.iterdir()) == ["a.json"]
    assert not driver.session.unsaved
    assert driver.session.path is not None
    assert driver.session.path == home / "elsewhere.json"
    assert read_project(driver.session.path).shapes[1].parts


def test_the_place_offered_is_one_that_takes_any_project(home: Path) -> None:
    assert folder_with_room(home / "full") == home
    with small_disk(home / "Documents"):
        assert folder_with_room(home / "full") == home
    assert folder_with_room(home / "full") == home / "Documents"
    assert folder_with_room(home / "Documents") == home
    shutil.rmtree(home)
    assert folder_with_room(home / "full") == home / "full"


def test_a_read_only_disk_is_named_and_cancelling_keeps_the_document_unsaved(
    driver: Driver, tmp_path: Path
) -> None:
    with small_disk(tmp_path / "small") as disk:
        path = saved(driver, disk / "a.json")
        changed(driver)
        kept = driver.document
        read_only(disk)
        said: list[str] = []

        def cancel(dialog: QWidget) -> None:
            assert isinstance(dialog, QMessageBox)
            said.append(dialog.informativeText())
            click(dialog, "Cancel")

        driver.in_dialog(cancel)
        driver.key(Qt.Key.Key_S, CONTROL)
        assert "Read-only file system" in said[0]
        assert driver.session.unsaved
        assert driver.document == kept
        assert driver.session.path == path


def test_a_folder_that_has_gone_is_named_and_another_place_is_offered(
    driver: Driver, home: Path, tmp_path: Path
) -> None:
    (tmp_path / "folder").mkdir()
    saved(driver, tmp_path / "folder" / "a.json")
    changed(driver)
    shutil.rmtree(tmp_path / "folder")
    save_elsewhere(driver, home, "No such file or directory")
    assert not driver.session.unsaved


def test_a_slow_disk_lets_the_window_go_on_and_what_it_wrote_is_what_counts_as_saved(
    driver: Driver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = saved(driver, tmp_path / "a.json")
    changed(driver)
    written, may_end = driver.document, Event()

    def slowly(document: Document, place: Path) -> Filed:
        may_end.wait()
        return stored(document, place)

    def go_on(dialog: QWidget) -> None:
        assert isinstance(dialog, Waiting)
        QTest.keyClick(dialog, Qt.Key.Key_Escape)
        assert dialog.isVisible(), "what is written cannot be unwritten"
        driver.session.store(driver.document.compare(("vertex",)), "Choose methods")
        may_end.set()

    monkeypatch.setattr(files, "stored", slowly)
    driver.in_dialog(go_on)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert read_project(path).shapes == written.sequence.shapes
    assert driver.session.unsaved
    driver.session.undo()
    assert not driver.session.unsaved


@pytest.mark.parametrize("answer", ["Overwrite", "Save Elsewhere…", "Cancel"])
def test_a_file_changed_by_another_program_is_not_overwritten_unasked(
    driver: Driver, tmp_path: Path, answer: str
) -> None:
    path = saved(driver, tmp_path / "a.json")
    changed(driver)
    write_project(path, example("arm"))
    foreign = path.read_bytes()

    def act(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        assert "changed by another program" in dialog.text()
        if answer.startswith("Save"):
            driver.in_dialog(lambda inner: name_file(inner, "elsewhere.json"))
        click(dialog, answer)

    driver.in_dialog(act)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert (path.read_bytes() == foreign) is (answer != "Overwrite")
    assert driver.session.unsaved is (answer == "Cancel")


def test_saving_again_after_overwriting_asks_nothing_nor_does_a_file_written_anew_as_it_was(
    driver: Driver, tmp_path: Path
) -> None:
    path = saved(driver, tmp_path / "a.json")
    path.write_bytes(path.read_bytes())
    changed(driver)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert not driver.session.unsaved
    path.unlink()
    driver.key(Qt.Key.Key_A, CONTROL)
    driver.key(Qt.Key.Key_Delete)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert path.exists(), "a file that was deleted meanwhile is there again"


def left(name: str, origin: Path | None = None) -> Place:
    """Leave a record as a crash does."""
    place = Place.new()
    write_record(place.path, Record(example(name), origin and Filed(origin, None)))
    place.release()
    return place


def test_a_start_after_a_crash_offers_each_document_and_opens_one_as_unsaved(
    driver: Driver, tmp_path: Path
) -> None:
    places = [left("arm", tmp_path / "mine.json"), left("arm")]
    seen: list[str] = []

    def open_mine(dialog: QWidget) -> None:
        assert isinstance(dialog, RecoveryDialog)
        items = [dialog.documents.item(row) for row in range(dialog.documents.count())]
        seen.extend(item.text() for item in items)
        assert not any(item.icon().isNull() for item in items)
        dialog.documents.setCurrentItem(next(item for item in items if item.text().startswith("mine")))
        click(dialog, "Open")

    driver.in_dialog(open_mine)
    begin(driver.window, None)
    assert len(seen) == 2
    assert any("never saved" in text for text in seen)
    assert driver.session.path == tmp_path / "mine.json"
    assert driver.session.unsaved
    assert driver.document.source == example("arm").shapes[0].rings[0]
    driver.save(tmp_path / "mine.json")
    driver.wait(lambda: not places[0].path.exists())
    assert places[1].path.exists()


def test_discarding_asks_and_later_leaves_all(driver: Driver) -> None:
    places = [left("arm"), left("arm")]

    def discard_one(dialog: QWidget) -> None:
        for answer in ("Cancel", "Discard"):
            driver.in_dialog(lambda question, answer=answer: click(question, answer))
            click(dialog, "Discard…")
        assert isinstance(dialog, RecoveryDialog)
        assert dialog.documents.count() == 1
        click(dialog, "Later")

    driver.in_dialog(discard_one)
    driver.window.actions_table["recover"].trigger()
    assert sorted(place.path.exists() for place in places) == [False, True]
    assert driver.document.source is None


def test_what_a_newer_program_left_is_called_so_and_kept(driver: Driver) -> None:
    place = left("arm")
    document = json.loads(place.path.read_text())
    newer = json.dumps({**document, "version": 1000, "shapes": {}, "recovery": ["of", "another", "kind"]})
    place.path.write_text(newer)
    said: list[str] = []

    def keep(question: QWidget) -> None:
        assert isinstance(question, QMessageBox)
        said.append(question.text())
        click(question, "Cancel")

    def look(dialog: QWidget) -> None:
        assert isinstance(dialog, RecoveryDialog)
        said.append(dialog.documents.item(0).text())
        assert not dialog.open_button.isEnabled()
        driver.in_dialog(keep)
        click(dialog, "Discard…")
        click(dialog, "Later")

    driver.in_dialog(look)
    driver.window.actions_table["recover"].trigger()
    assert said[0].startswith("Of a newer version of starskel")
    assert said[1].startswith("Discard what cannot be opened here?")
    assert place.path.read_text() == newer


def test_without_anything_left_the_command_says_so(driver: Driver) -> None:
    driver.window.actions_table["recover"].trigger()
    assert driver.window.statusBar().currentMessage() == "There are no recovered documents."
    assert not driver.window.findChildren(QDialog), "nothing that waited is left"


def test_recovering_does_not_lose_what_is_open(driver: Driver) -> None:
    left("arm")
    driver.draw("source", SQUARE)
    kept = driver.document

    def open_it(dialog: QWidget) -> None:
        driver.in_dialog(lambda question: click(question, "Cancel"))
        click(dialog, "Open")

    driver.in_dialog(open_it)
    driver.window.actions_table["recover"].trigger()
    assert driver.document == kept


def test_a_window_that_is_closed_leaves_no_record(driver: Driver) -> None:
    driver.draw("source", SQUARE)
    assert driver.window.recovering.keeper.keep_now()
    assert list((state_folder() / "recovery").glob("*.json"))
    driver.in_dialog(lambda question: click(question, "Discard"))
    driver.window.close()
    assert not list((state_folder() / "recovery").iterdir())


@pytest.mark.parametrize("name", ["../../elsewhere", "/elsewhere", "a\0b", "/", "a" * 5000, "nul"])
def test_a_document_of_any_name_is_offered_to_be_saved_in_the_folder(
    driver: Driver, tmp_path: Path, name: str
) -> None:
    driver.session.show_project(replace(example("star"), name=name))
    offered: list[str] = []

    def look(dialog: QWidget) -> None:
        assert isinstance(dialog, QFileDialog)
        offered.extend(dialog.selectedFiles())
        QTest.keyClick(dialog, Qt.Key.Key_Escape)

    driver.in_dialog(look)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert [Path(path).parent for path in offered] == [tmp_path]
    assert Path(offered[0]).name == f"{file_name_of(name)}.json"
