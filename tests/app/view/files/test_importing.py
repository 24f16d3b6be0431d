"""Shapes of drawings, pictures and fonts, taken in by a person at the window."""

import shutil
from collections.abc import Callable
from pathlib import Path
from threading import Event

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QLabel, QLineEdit, QMessageBox, QWidget

from app.model.selection import Selection
from app.view.files.remembered import recent_files
from app.view.files.shape_chooser import ShapeChooser, ShapeList
from app.view.files.word_field import WordField
from starskel.reading.named_shape import Reading
from starskel.reading.readers import read_shapes
from tests.app.driver import CONTROL, SQUARE, TRIANGLE, Driver, name_file

FONT = next(Path("/usr/share/fonts").rglob("DejaVuSans.ttf"), Path("no font"))

needs_font = pytest.mark.skipif(not FONT.exists(), reason="DejaVu Sans is not installed")

ICONS = Path(__file__).parents[3] / "files" / "icons"

THREE = """<svg xmlns="http://www.w3.org/2000/svg" width="90" height="90">
<rect id="box" width="40" height="20"/><circle id="sun" cx="60" cy="60" r="20"/>
<path id="bow" d="M0 50 L30 80 L30 50 L0 80 Z"/><text>no shape</text></svg>"""


pytestmark = pytest.mark.usefixtures("own_dialogs")


@pytest.fixture(autouse=True)
def files_to_import(tmp_path: Path) -> None:
    (tmp_path / "three.svg").write_text(THREE)
    shutil.copy(ICONS / "lucide-heart.svg", tmp_path / "heart.svg")


def import_file(driver: Driver, name: str) -> None:
    driver.in_dialog(lambda dialog: name_file(dialog, name))
    driver.key(Qt.Key.Key_I, CONTROL)


def in_chooser(driver: Driver, act: Callable[[ShapeChooser], None]) -> None:
    """Act in the chooser, which opens when the file has been read."""
    seen: list[bool] = []

    def attempt(dialog: QWidget) -> None:
        assert isinstance(dialog, ShapeChooser)
        seen.append(True)
        act(dialog)

    driver.in_dialog(attempt)
    driver.wait(lambda: bool(seen) and QApplication.activeModalWidget() is None)


def lists(dialog: QWidget) -> list[ShapeList]:
    return dialog.findChildren(ShapeList)


def said(dialog: QWidget) -> str:
    return "\n".join(label.text() for label in dialog.findChildren(QLabel))


def press(dialog: QWidget, key: Qt.Key) -> None:
    QTest.keyClick(QApplication.focusWidget() or dialog, key)


def accept(dialog: QWidget) -> None:
    (buttons,) = dialog.findChildren(QDialogButtonBox)
    QTest.mouseClick(buttons.button(QDialogButtonBox.StandardButton.Ok), Qt.MouseButton.LeftButton)


def size(driver: Driver, side: str) -> list[float]:
    box = np.ptp(driver.document.vertices(side), axis=0)  # type: ignore[arg-type]
    return [round(float(length), 3) for length in box]


def test_the_first_shape_becomes_the_source_and_the_second_the_target(driver: Driver) -> None:
    import_file(driver, "three.svg")
    in_chooser(driver, lambda dialog: press(dialog, Qt.Key.Key_Return))
    assert (size(driver, "source"), size(driver, "target")) == ([40, 20], [40, 40])
    assert driver.session.undoes == "Import shapes"
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert driver.document.source is driver.document.target is None


def test_shapes_are_chosen_by_keys_and_what_was_mended_is_told(driver: Driver) -> None:
    def choose(dialog: ShapeChooser) -> None:
        source, target = lists(dialog)
        dialog.activateWindow()  # no window manager does so here
        assert QTest.qWaitForWindowActive(dialog)
        assert "three.svg holds 3 shapes." in said(dialog)
        assert "Texts in the file were left out." in said(dialog)
        assert "crossed" not in said(dialog)
        assert source.hasFocus()
        press(dialog, Qt.Key.Key_Down)
        press(dialog, Qt.Key.Key_Down)
        assert source.chosen is not None
        assert source.chosen.name == "bow"
        assert "it crossed or touched itself and was cut there" in said(dialog)
        press(dialog, Qt.Key.Key_Tab)
        press(dialog, Qt.Key.Key_Home)
        assert target.chosen is None
        press(dialog, Qt.Key.Key_Return)

    driver.draw("target", SQUARE)
    import_file(driver, "three.svg")
    in_chooser(driver, choose)
    assert [len(ring) for ring in driver.document.shape("source").rings] == [3, 3]
    assert driver.corners("target") == [list(corner) for corner in SQUARE]
    assert "bow: it crossed" in driver.window.statusBar().currentMessage()


def test_a_name_typed_narrows_the_choice(driver: Driver) -> None:
    def choose(dialog: ShapeChooser) -> None:
        (field,) = dialog.findChildren(QLineEdit)
        QTest.keyClicks(field, "SU")
        assert [own.chosen.name for own in lists(dialog) if own.chosen] == ["sun", "sun"]
        QTest.keyClicks(field, "nny")
        (buttons,) = dialog.findChildren(QDialogButtonBox)
        assert not buttons.button(QDialogButtonBox.StandardButton.Ok).isEnabled()
        field.clear()
        accept(dialog)

    import_file(driver, "three.svg")
    in_chooser(driver, choose)
    assert driver.document.source is not None


@needs_font
def test_words_of_a_font_are_set_for_each_canvas(driver: Driver) -> None:
    def choose(dialog: ShapeChooser) -> None:
        words = dialog.findChildren(WordField)
        (buttons,) = dialog.findChildren(QDialogButtonBox)
        ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        for field, text in zip(words, ("Ti", "\u4e00o"), strict=True):
            field.insert(text)
            assert not ok.isEnabled()
            driver.wait(lambda field=field: not field.pending)
        assert 'the font has no letter "\u4e00"' in said(dialog).casefold()
        assert ok.isEnabled()
        words[1].clear()
        QTest.keyClicks(words[1], "oo")
        driver.wait(lambda: not words[1].pending)
        assert [own.chosen.name for own in lists(dialog) if own.chosen] == ["Ti", "oo"]
        accept(dialog)

    shutil.copy(FONT, "sans.ttf")
    import_file(driver, "sans.ttf")
    in_chooser(driver, choose)
    assert [len(driver.document.shape(side)) for side in ("source", "target")] == [3, 4]


def test_leaving_the_chooser_changes_nothing(driver: Driver) -> None:
    driver.draw("source", SQUARE)
    before = driver.document
    import_file(driver, "three.svg")
    in_chooser(driver, lambda dialog: press(dialog, Qt.Key.Key_Escape))
    assert driver.document is before


def test_a_single_shape_goes_to_the_canvas_last_worked_on_and_is_seen_whole(driver: Driver) -> None:
    driver.draw("source", SQUARE)
    driver.draw("target", TRIANGLE)
    driver.session.choose(Selection("target"))
    import_file(driver, "heart.svg")
    driver.wait(lambda: driver.session.undoes == "Import shapes")
    assert driver.corners("source") == [list(corner) for corner in SQUARE]
    canvas = driver.window.canvases["target"]
    screen = canvas.camera.to_screen(driver.document.extent("target"))
    assert (screen >= 0).all()
    assert (screen <= (canvas.width(), canvas.height())).all()


def test_a_drawing_that_is_opened_begins_a_new_document(driver: Driver, tmp_path: Path) -> None:
    driver.in_dialog(lambda dialog: name_file(dialog, "three.svg"))
    driver.key(Qt.Key.Key_O, CONTROL)
    in_chooser(driver, lambda dialog: press(dialog, Qt.Key.Key_Return))
    assert (size(driver, "source"), size(driver, "target")) == ([40, 20], [40, 40])
    assert driver.document.name == "three"
    assert not driver.session.unsaved
    assert driver.session.path is None
    assert list(recent_files()) == [tmp_path / "three.svg"]


def test_what_is_drawn_while_a_drawing_is_read_is_not_lost(
    driver: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = Event()

    def slowly(path: Path) -> Reading:
        drawn.wait()
        return read_shapes(path)

    def stay(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        QTest.mouseClick(dialog.button(QMessageBox.StandardButton.Cancel), Qt.MouseButton.LeftButton)

    monkeypatch.setattr("starskel.reading.readers.read_shapes", slowly)
    driver.in_dialog(lambda dialog: name_file(dialog, "heart.svg"))
    driver.key(Qt.Key.Key_O, CONTROL)
    driver.draw("source", SQUARE)
    asked: list[QWidget] = []
    driver.in_dialog(lambda dialog: (asked.append(dialog), stay(dialog)))
    drawn.set()
    driver.wait(lambda: bool(asked))
    assert driver.corners("source") == [list(corner) for corner in SQUARE]


def test_what_cannot_be_read_is_explained(driver: Driver, tmp_path: Path) -> None:
    (tmp_path / "empty.svg").write_text("<svg xmlns='http://www.w3.org/2000/svg'/>")
    texts = []

    def read(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        texts.append(f"{dialog.text()} {dialog.informativeText()}")
        dialog.accept()

    import_file(driver, "empty.svg")
    driver.in_dialog(read)
    driver.wait(lambda: bool(texts))
    assert "empty.svg cannot be read" in texts[0]
    assert "closed outline" in texts[0]


def test_several_shapes_on_the_clipboard_are_offered_for_one_canvas(driver: Driver) -> None:
    def choose(dialog: ShapeChooser) -> None:
        (only,) = lists(dialog)
        only.choose(1)
        accept(dialog)

    QGuiApplication.clipboard().setText(THREE)
    driver.key(Qt.Key.Key_V, CONTROL)
    in_chooser(driver, choose)
    assert size(driver, "source") == [40, 40]
    assert driver.document.target is None
    assert driver.session.undoes == "Paste shape"
