import json
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QComboBox,
    QDialogButtonBox,
    QFileDialog,
    QLineEdit,
    QMessageBox,
    QWidget,
)

from app.model.marks import SIDES
from app.view.files import files
from app.view.files.dialogs import PairDialog, SaveDialog
from app.view.files.export import exporting
from app.view.files.remembered import last_folder
from app.view.main_window import MainWindow
from starskel.files.pairs import ShapePair, write_pairs
from starskel.files.projects.examples import example
from starskel.files.projects.project_file import read_project
from starskel.files.raster_writing import write_image
from tests.app.driver import CONTROL, SHIFT, SQUARE, Driver, name_file, type_name
from tests.starskel.images.drawn import waves

pytestmark = pytest.mark.usefixtures("own_dialogs")


def press(kind: QMessageBox.StandardButton):  # type: ignore[no-untyped-def]
    def act(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        QTest.mouseClick(dialog.button(kind), Qt.MouseButton.LeftButton)

    return act


def test_a_drawing_is_saved_and_opened_again(driver: Driver, tmp_path: Path) -> None:
    driver.draw_both()
    driver.mark((10, 10), (10, 10))
    saved = driver.document
    assert driver.window.isWindowModified()
    driver.in_dialog(lambda dialog: name_file(dialog, "boxes"))
    driver.key(Qt.Key.Key_S, CONTROL)
    assert not driver.window.isWindowModified()
    assert "boxes" in driver.window.windowTitle()
    assert read_project(tmp_path / "boxes.json").shapes == saved.sequence.shapes
    driver.key(Qt.Key.Key_N, CONTROL)
    assert driver.document.source is None
    driver.in_dialog(lambda dialog: name_file(dialog, "boxes.json"))
    driver.key(Qt.Key.Key_O, CONTROL)
    driver.wait_until_read()
    assert driver.document.source == saved.source
    assert driver.document.marks == saved.marks


def test_saving_again_asks_nothing_and_undo_back_to_the_saved_state_is_clean(
    driver: Driver, tmp_path: Path
) -> None:
    driver.draw("source", SQUARE)
    driver.in_dialog(lambda dialog: name_file(dialog, "box.json"))
    driver.key(Qt.Key.Key_S, CONTROL)
    driver.key(Qt.Key.Key_A, CONTROL)
    driver.key(Qt.Key.Key_Delete)
    assert driver.window.isWindowModified()
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert not driver.window.isWindowModified()
    driver.key(Qt.Key.Key_Y, CONTROL)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert not read_project(tmp_path / "box.json").shapes[0].parts


def test_closing_asks_about_unsaved_changes(driver: Driver, tmp_path: Path) -> None:
    driver.draw("source", SQUARE)
    driver.in_dialog(press(QMessageBox.StandardButton.Cancel))
    driver.window.close()
    assert driver.window.isVisible()

    def save(dialog: QWidget) -> None:
        driver.in_dialog(lambda inner: name_file(inner, "kept.json"))
        press(QMessageBox.StandardButton.Save)(dialog)

    driver.in_dialog(save)
    driver.window.close()
    assert not driver.window.isVisible()
    assert read_project(tmp_path / "kept.json").shapes[0].parts


def test_a_drawing_begun_is_not_lost_by_closing(driver: Driver) -> None:
    driver.key(Qt.Key.Key_D)
    driver.click("source", *SQUARE)
    driver.in_dialog(press(QMessageBox.StandardButton.Cancel))
    driver.window.close()
    assert driver.window.isVisible()
    assert driver.corners("source") == [list(corner) for corner in SQUARE]
    driver.in_dialog(press(QMessageBox.StandardButton.Discard))
    driver.window.close()
    assert not driver.window.isVisible()


def test_discarding_is_possible(driver: Driver) -> None:
    driver.draw("source", SQUARE)
    driver.in_dialog(press(QMessageBox.StandardButton.Discard))
    driver.key(Qt.Key.Key_N, CONTROL)
    assert driver.document.source is None


@pytest.mark.parametrize(
    "content", ["", "{", '{"format": "starskel-project", "version": 1}', '{"format": "other"}', "[1]"]
)
def test_a_damaged_file_is_explained_and_nothing_is_lost(
    driver: Driver, tmp_path: Path, content: str
) -> None:
    driver.draw("source", SQUARE)
    kept = driver.document
    path = tmp_path / "damaged.json"
    path.write_text(content)
    said: list[str] = []

    def read(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        said.append(dialog.text() + dialog.informativeText())
        dialog.accept()

    driver.in_dialog(read)
    driver.open(path)
    assert "damaged.json" in said[0]
    assert driver.document == kept
    assert driver.session.undoes == "Draw shape"


def test_a_project_whose_marks_cross_is_explained(driver: Driver, tmp_path: Path) -> None:
    rows = "[[0,0],[9,0],[9,9],[0,9]]"
    path = tmp_path / "crossed.json"
    path.write_text(
        f'{{"format":"starskel-project","version":1,"name":"x","source":{rows},"target":{rows},'
        '"marks":[[0,0],[1,2],[2,1]],"methods":[]}'
    )
    said: list[str] = []

    def read(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        said.append(dialog.informativeText())
        dialog.accept()

    driver.in_dialog(read)
    driver.open(path)
    assert "order" in said[0]
    assert driver.document.source is None


def test_one_of_many_pairs_is_chosen_by_its_name(driver: Driver, tmp_path: Path) -> None:
    names = ("arm", "star", "ribbon")
    path = tmp_path / "pairs.json"
    write_pairs(path, [_pair(name) for name in names])

    def choose(dialog: QWidget) -> None:
        assert isinstance(dialog, PairDialog)
        field = dialog.findChild(QLineEdit)
        assert field is not None
        QTest.keyClicks(field, "sta")
        QTest.keyClick(field, Qt.Key.Key_Return)

    driver.in_dialog(choose)
    driver.open(path)
    assert driver.document.name == "star"
    assert driver.document.marks == _pair("star").marks
    assert "star" in driver.window.windowTitle()


def test_save_as_goes_to_another_file(driver: Driver, tmp_path: Path) -> None:
    driver.draw("source", SQUARE)
    for name in ("one.json", "two.json"):
        driver.in_dialog(lambda dialog, name=name: name_file(dialog, name))
        driver.key(Qt.Key.Key_S, CONTROL | SHIFT)
        assert (tmp_path / name).exists()
    assert driver.session.path == tmp_path / "two.json"


def test_all_dialogs_begin_where_a_file_was_chosen_last(driver: Driver, tmp_path: Path) -> None:
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    seen: list[str] = []

    def look(dialog: QWidget) -> None:
        assert isinstance(dialog, QFileDialog)
        seen.append(dialog.directory().absolutePath())
        dialog.reject()

    def save_there(dialog: QWidget) -> None:
        assert isinstance(dialog, QFileDialog)
        dialog.setDirectory(str(folder))
        name_file(dialog, "boxes")

    driver.draw_both()
    driver.in_dialog(save_there)
    driver.key(Qt.Key.Key_S, CONTROL)
    for key, modifiers in (
        (Qt.Key.Key_I, CONTROL),
        (Qt.Key.Key_O, CONTROL | SHIFT),
        (Qt.Key.Key_S, CONTROL | SHIFT),
        (Qt.Key.Key_O, CONTROL),
    ):
        driver.in_dialog(look)
        driver.key(key, modifiers)
    assert seen == [str(folder)] * 4
    assert last_folder() == folder
    shutil.rmtree(folder)
    assert last_folder() == tmp_path


def test_what_was_typed_counts_though_the_folder_was_not_read_yet(window: MainWindow, tmp_path: Path) -> None:
    """Qt reads folders in a thread; a person who types at once must not get the file that was suggested."""
    (tmp_path / "one.json").write_text("kept")
    dialog = SaveDialog(window, "Save", tmp_path / "one.json", [".json"])
    dialog.open()
    type_name(dialog, "two")
    assert not dialog.isVisible()
    assert [Path(path).name for path in dialog.selectedFiles()] == ["two.json"]


def test_a_file_is_not_overwritten_unasked_though_its_ending_was_not_typed(
    driver: Driver, tmp_path: Path
) -> None:
    other = tmp_path / "boxes.json"
    other.write_text("somebody's work")
    driver.draw("source", SQUARE)
    asked: list[str] = []

    def refuse(question: QWidget) -> None:
        assert isinstance(question, QMessageBox)
        asked.append(question.text())
        press(QMessageBox.StandardButton.No)(question)

    def save(dialog: QWidget) -> None:
        driver.in_dialog(refuse)
        type_name(dialog, "boxes")
        dialog.close()

    driver.in_dialog(save)
    driver.key(Qt.Key.Key_S, CONTROL)
    assert "boxes.json" in asked[0]
    assert other.read_text() == "somebody's work"
    assert driver.session.unsaved


def test_the_kind_chosen_in_the_dialog_decides_the_format(driver: Driver, tmp_path: Path) -> None:
    driver.draw_both()
    driver.wait_for_blends()

    def choose(dialog: QWidget) -> None:
        kinds = dialog.findChild(QComboBox, "fileTypeCombo")
        assert kinds is not None
        QTest.keyClick(kinds, Qt.Key.Key_Down)
        field = dialog.findChild(QLineEdit, "fileNameEdit")
        assert field is not None
        assert field.text() == "Untitled.eps"
        QTest.keyClick(field, Qt.Key.Key_Return)

    def export(dialog: QWidget) -> None:
        driver.in_dialog(choose)
        buttons = dialog.findChild(QDialogButtonBox)
        assert buttons is not None
        QTest.mouseClick(buttons.button(QDialogButtonBox.StandardButton.Save), Qt.MouseButton.LeftButton)

    driver.in_dialog(export)
    driver.key(Qt.Key.Key_E, CONTROL)
    assert (tmp_path / "Untitled.eps").read_text().startswith("%!PS-Adobe-3.0 EPSF-3.0")


@pytest.mark.parametrize("path", ["folder", "file/inside.svg"])
def test_where_nothing_can_be_written_export_and_save_say_so(
    driver: Driver, tmp_path: Path, path: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The file dialog lets some of these through, on a disk that has changed since it looked."""
    (tmp_path / "folder").mkdir()
    (tmp_path / "file").write_text("no folder")
    driver.draw_both()
    driver.wait_for_blends()
    for module in (files, exporting):
        monkeypatch.setattr(module, "path_to_save", lambda *_: (tmp_path / path).with_suffix(".svg"))
    (tmp_path / "folder.svg").mkdir()
    said: list[str] = []

    def read(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        said.append(dialog.text())
        assert dialog.informativeText()
        dialog.accept()

    driver.in_dialog(read)
    driver.key(Qt.Key.Key_S, CONTROL)
    driver.in_dialog(lambda dialog: (driver.in_dialog(read), dialog.accept()))  # type: ignore[attr-defined]
    driver.key(Qt.Key.Key_E, CONTROL)
    assert "was not saved" in said[0]
    assert "was not written" in said[1]
    assert driver.session.unsaved


def _name(dialog: QWidget, path: Path) -> None:
    assert isinstance(dialog, QFileDialog), type(dialog)
    name_file(dialog, path.name)


def _pair(name: str) -> ShapePair:
    return replace(example(name).pair(0), id=name)


def test_a_pair_of_pictures_is_opened_with_them(driver: Driver, tmp_path: Path) -> None:
    write_image(tmp_path / "a.png", waves(40, 30))
    side = {"image": "a.png", "outline": [[5, 5], [5, 25], [25, 25], [25, 5]]}
    path = tmp_path / "images.json"
    entry = {"id": "one", "p": side, "q": side}
    path.write_text(json.dumps({"format": "image-pairs/1", "pairs": [entry]}))
    driver.open(path)
    for name in SIDES:
        picture = driver.document.picture(name)
        assert picture is not None
        assert picture.size == (40, 30)
    driver.wait_for_blends()
    assert all(state.error is None for state in driver.session.blends.results.values())
