from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialogButtonBox,
    QFileDialog,
    QLineEdit,
    QMessageBox,
    QProgressBar,
    QWidget,
)

from app.playback import Repeat
from app.view.files import exporting, files
from app.view.files.dialogs import PairDialog, SaveDialog
from app.view.files.export_dialog import ExportDialog
from app.view.files.look_fields import LookFields
from app.view.files.waiting import Waiting
from app.view.main_window import MainWindow
from starskel.easing import Easing
from starskel.files.examples import example
from starskel.files.pairs import ShapePair, write_pairs
from starskel.files.project_file import read_project
from tests.app.driver import CONTROL, SHIFT, SQUARE, Driver, name_file, type_name


@pytest.fixture(autouse=True)
def own_dialogs(qapp, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:  # type: ignore[no-untyped-def]
    """Take Qt's own file dialogs, which can be typed into, not the desktop's; begin in an empty folder."""
    qapp.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    monkeypatch.chdir(tmp_path)


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
    driver.window.files.open(path)
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
    driver.window.files.open(path)
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
    driver.window.files.open(path)
    assert driver.document.name == "star"
    assert driver.document.marks == _pair("star").marks
    assert "star" in driver.window.windowTitle()


def test_keyframes_are_exported_through_the_dialogs(driver: Driver, tmp_path: Path) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    for row, name in enumerate(
        ("row.svg", "frame.eps", "pages.ps", "sheet.svg", "lottie.json", "numbers.csv")
    ):
        driver.in_dialog(_exporting(driver, row, tmp_path / name))
        driver.key(Qt.Key.Key_E, CONTROL)
        assert (tmp_path / name).stat().st_size > 500
        assert name in driver.window.statusBar().currentMessage()


def test_keyframes_are_exported_as_far_apart_as_they_are_played(driver: Driver, tmp_path: Path) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    driver.session.store(driver.document.steer(easing=Easing((0.4, 0.0), (0.6, 1.0))), "Set easing")
    driver.in_dialog(_exporting(driver, 0, tmp_path / "eased.svg"))
    driver.key(Qt.Key.Key_E, CONTROL)
    assert "t = 0.2<" not in (tmp_path / "eased.svg").read_text()
    driver.session.undo()
    driver.in_dialog(_exporting(driver, 0, tmp_path / "even.svg"))
    driver.key(Qt.Key.Key_E, CONTROL)
    assert "t = 0.2<" in (tmp_path / "even.svg").read_text()


def test_there_is_nothing_to_export_before_there_is_a_blend(driver: Driver) -> None:
    assert not driver.window.actions_table["export"].isEnabled()


def test_save_as_goes_to_another_file(driver: Driver, tmp_path: Path) -> None:
    driver.draw("source", SQUARE)
    for name in ("one.json", "two.json"):
        driver.in_dialog(lambda dialog, name=name: name_file(dialog, name))
        driver.key(Qt.Key.Key_S, CONTROL | SHIFT)
        assert (tmp_path / name).exists()
    assert driver.session.path == tmp_path / "two.json"


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


def test_an_animation_takes_as_long_as_it_plays(driver: Driver, tmp_path: Path) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    driver.window.player.set_speed(2.0)
    for repeat, seconds in ((Repeat.LOOP, "1.5s"), (Repeat.PING_PONG, "3s")):
        driver.window.player.set_repeat(repeat)
        path = tmp_path / f"{repeat.value}.svg"
        driver.in_dialog(_exporting(driver, 4, path))
        driver.key(Qt.Key.Key_E, CONTROL)
        assert f'dur="{seconds}"' in path.read_text()


def test_a_long_export_shows_how_far_it_is_and_can_be_given_up(driver: Driver, tmp_path: Path) -> None:
    driver.session.show_project(example("figure-10-dog"))
    driver.wait_for_blends()
    path = tmp_path / "morph.apng"

    def give_up(dialog: QWidget) -> None:
        assert isinstance(dialog, Waiting)
        bar = dialog.findChild(QProgressBar)
        assert bar is not None
        driver.wait(lambda: bar.value() > 12)
        cancel = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Cancel)  # type: ignore[union-attr]
        QTest.mouseClick(cancel, Qt.MouseButton.LeftButton)

    def name(dialog: QWidget) -> None:
        driver.in_dialog(give_up)
        name_file(dialog, path.name)

    def choose(dialog: QWidget) -> None:
        assert isinstance(dialog, ExportDialog)
        layouts = dialog.findChildren(QComboBox)[0]
        layouts.setCurrentIndex(layouts.findData("morph"))
        driver.in_dialog(name)
        dialog.accept()

    driver.in_dialog(choose)
    driver.key(Qt.Key.Key_E, CONTROL)
    assert not path.exists()
    assert not driver.window.statusBar().currentMessage().startswith("Exported")


def test_numbered_files_are_not_overwritten_unasked(driver: Driver, tmp_path: Path) -> None:
    def refuse(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        assert "walk-0002.svg" in dialog.informativeText()
        dialog.reject()

    def export(answer: Callable[[QWidget], None]) -> None:
        def name(dialog: QWidget) -> None:
            driver.in_dialog(answer)
            _name(dialog, tmp_path / "walk.svg")

        def choose(dialog: QWidget) -> None:
            assert isinstance(dialog, ExportDialog)
            layouts = dialog.findChildren(QComboBox)[0]
            layouts.setCurrentIndex(layouts.findData("pages"))
            driver.in_dialog(name)
            dialog.accept()

        driver.in_dialog(choose)
        driver.key(Qt.Key.Key_E, CONTROL)

    driver.draw_both()
    driver.wait_for_blends()
    (tmp_path / "walk-0002.svg").write_text("mine")
    export(refuse)
    assert [path.name for path in tmp_path.glob("*.svg")] == ["walk-0002.svg"]
    assert (tmp_path / "walk-0002.svg").read_text() == "mine"

    def overwrite(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        dialog.buttons()[0].click()

    export(overwrite)
    assert len(list(tmp_path.glob("walk-*.svg"))) == 6
    assert "<svg" in (tmp_path / "walk-0002.svg").read_text()


def test_an_export_looks_as_it_was_wanted(driver: Driver, tmp_path: Path) -> None:
    def choose(dialog: QWidget) -> None:
        assert isinstance(dialog, ExportDialog)
        fields = dialog.findChild(LookFields)
        assert fields is not None
        for box in fields.findChildren(QCheckBox):
            box.setChecked(box.text() == "Paper")
        for box in dialog.findChildren(QCheckBox):
            if box.text() == "Vertices":
                box.click()
        fields.findChildren(QComboBox)[0].setCurrentIndex(2)
        driver.in_dialog(lambda inner: _name(inner, tmp_path / "own.svg"))
        dialog.accept()

    driver.draw_both()
    driver.wait_for_blends()
    driver.in_dialog(choose)
    driver.key(Qt.Key.Key_E, CONTROL)
    text = (tmp_path / "own.svg").read_text()
    assert "t = 0" not in text
    assert text.count("<circle") == 6 * len(driver.session.fresh_results[0].pairs[0])
    assert 'fill="#ffffff"/>' in text
    assert text.count("<path") == 7
    assert 'stroke="#20262e" stroke-width="0.7"' not in text


def _exporting(driver: Driver, row: int, path: Path):  # type: ignore[no-untyped-def]
    def act(dialog: QWidget) -> None:
        assert isinstance(dialog, ExportDialog)
        layouts = dialog.findChildren(QComboBox)[0]
        for _ in range(row):
            QTest.keyClick(layouts, Qt.Key.Key_Down)
        driver.in_dialog(lambda inner: _name(inner, path))
        save = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)  # type: ignore[union-attr]
        QTest.mouseClick(save, Qt.MouseButton.LeftButton)

    return act


def _name(dialog: QWidget, path: Path) -> None:
    assert isinstance(dialog, QFileDialog), type(dialog)
    name_file(dialog, path.name)


def _pair(name: str) -> ShapePair:
    return replace(example(name).pair(0), id=name)
