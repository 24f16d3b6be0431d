"""Exports, through their dialogs."""

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFileDialog,
    QMessageBox,
    QProgressBar,
    QWidget,
)

from app.export import Choice
from app.playback import Repeat
from app.view.files.export.dialog import ExportDialog
from app.view.files.export.look_fields import LookFields
from app.view.files.export.times_field import TimesField
from app.view.files.waiting import Waiting
from starskel.easing import Easing
from starskel.files.projects.examples import example
from starskel.sheet.drawing import Stroke
from starskel.sheet.keyframe import Shown
from starskel.sheet.style import Look
from tests.app.driver import CONTROL, Driver, name_file

pytestmark = pytest.mark.usefixtures("own_dialogs")


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


def test_the_format_that_was_chosen_last_is_offered_first(driver: Driver, tmp_path: Path) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    driver.in_dialog(_exporting(driver, 4, tmp_path / "one.gif"))
    driver.key(Qt.Key.Key_E, CONTROL)
    offered: list[str] = []

    def look(dialog: QWidget) -> None:
        assert isinstance(dialog, QFileDialog)
        offered.extend((Path(dialog.selectedFiles()[0]).suffix, dialog.selectedNameFilter()))
        dialog.reject()

    _export(driver, "animation", look)
    assert offered == [".gif", "GIF (*.gif)"]


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
        QTest.keyClick(dialog, Qt.Key.Key_Return)
        assert dialog.isVisible(), "Enter gives nothing up"
        cancel = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Cancel)  # type: ignore[union-attr]
        QTest.mouseClick(cancel, Qt.MouseButton.LeftButton)

    def name(dialog: QWidget) -> None:
        driver.in_dialog(give_up)
        name_file(dialog, path.name)

    _export(driver, "morph", name)
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

        _export(driver, "pages", name)

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
    assert text.count("<circle") == 6 * len(driver.session.blends.fresh[0].pairs[0])
    assert 'fill="#ffffff"/>' in text
    assert text.count("<path") == 7
    assert 'stroke="#20262e" stroke-width="0.7"' not in text


def test_what_is_drawn_is_exported_while_a_third_shape_is_empty(driver: Driver, tmp_path: Path) -> None:
    titles: list[str] = []

    def choose(dialog: QWidget) -> None:
        titles.append(dialog.windowTitle())
        _exporting(driver, 0, tmp_path / "there.svg")(dialog)

    driver.draw_both()
    driver.wait_for_blends()
    driver.window.actions_table["shape-add"].trigger()
    assert driver.document.step == 1
    assert driver.window.actions_table["export"].isEnabled()
    driver.in_dialog(choose)
    driver.key(Qt.Key.Key_E, CONTROL)
    assert titles == ["Export keyframes: A-B"]
    assert (tmp_path / "there.svg").read_text().count('id="frame-') == 6


def test_times_gap_and_tolerance_are_as_wanted(driver: Driver, tmp_path: Path) -> None:
    def write(layout: str, name: str, times: str, gap: float, tolerance: float) -> str:
        def choose(dialog: QWidget) -> None:
            assert isinstance(dialog, ExportDialog)
            _choose_layout(dialog, layout)
            field = dialog.findChild(TimesField)
            assert field is not None
            save = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)  # type: ignore[union-attr]
            if field.isEnabled():
                QTest.keyClicks(field, "0 two")
                assert not save.isEnabled()
                field.clear()
                QTest.keyClicks(field, times)
            _number(dialog, "Between frames").setValue(gap)
            _number(dialog, "Tolerance").setValue(tolerance)
            driver.in_dialog(lambda inner: _name(inner, tmp_path / name))
            save.click()

        driver.in_dialog(choose)
        driver.key(Qt.Key.Key_E, CONTROL)
        return (tmp_path / name).read_text()

    driver.session.show_project(example("arm"))
    driver.wait_for_blends()
    near, far = (write("row", name, "0 0.3 1", gap, 0.1) for name, gap in (("near.svg", 0), ("far.svg", 50)))
    assert re.findall(r">(t = [^<]*)<", near) == ["t = 0", "t = 0.3", "t = 1"]
    widths = [float(re.findall(r'width="([\d.]+)pt"', text)[0]) for text in (near, far)]
    assert widths[1] - widths[0] == pytest.approx(100)
    fine, rough = (
        write("animation", name, "", 0, share) for name, share in (("fine.svg", 0.02), ("rough.svg", 5))
    )
    assert len(fine) > len(rough)


def test_the_next_export_begins_with_what_was_chosen_though_no_file_was_named(driver: Driver) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    wanted = Choice(
        "pages",
        "vertex",
        frames=9,
        shown=Shown(marks=True, pictures=False),
        seconds=driver.window.player.duration,
        returning=True,
        pixels=300,
        rate=12,
        look=Look(("#102030", "#405060"), Stroke("#708090", 2.5), "#a0b0c0", 5, 7, 90, signs=False),
        times=(0.0, 0.125, 1.0),
        tolerance=0.005,
    )
    found: list[Choice] = []

    def think_better_of_it(dialog: QWidget) -> None:
        assert isinstance(dialog, ExportDialog)
        dialog.begin_with(wanted)
        driver.in_dialog(lambda files: files.close())
        dialog.accept()

    def look(dialog: QWidget) -> None:
        assert isinstance(dialog, ExportDialog)
        found.append(dialog.choice)
        dialog.reject()

    for act in (think_better_of_it, look):
        driver.in_dialog(act)
        driver.key(Qt.Key.Key_E, CONTROL)
    assert found == [replace(wanted, t=driver.window.player.t)]


@pytest.mark.parametrize(
    ("language", "text", "times"),
    [
        ("en", "", ()),
        ("en", " 0, .25  0.5;1 ", (0, 0.25, 0.5, 1)),
        ("de", "0 0,25; 0.5 1", (0, 0.25, 0.5, 1)),
        ("en", "0 1.5", None),
        ("de", "nan", None),
    ],
)
def test_times_are_read_as_the_language_writes_them(
    driver: Driver, language: str, text: str, times: tuple[float, ...] | None
) -> None:
    field = TimesField(driver.window)
    field.setLocale(QLocale(language))
    field.setText(text)
    assert field.times == times


def _number(dialog: QWidget, name: str) -> QDoubleSpinBox:
    return next(field for field in dialog.findChildren(QDoubleSpinBox) if field.accessibleName() == name)


def _choose_layout(dialog: ExportDialog, layout: str) -> None:
    layouts = dialog.findChildren(QComboBox)[0]
    layouts.setCurrentIndex(layouts.findData(layout))


def _export(driver: Driver, layout: str, name: Callable[[QWidget], None]) -> None:
    """Choose a layout, and do something in the dialog that asks for the file."""

    def choose(dialog: QWidget) -> None:
        assert isinstance(dialog, ExportDialog)
        _choose_layout(dialog, layout)
        driver.in_dialog(name)
        dialog.accept()

    driver.in_dialog(choose)
    driver.key(Qt.Key.Key_E, CONTROL)


def _exporting(driver: Driver, row: int, path: Path):  # type: ignore[no-untyped-def]
    def act(dialog: QWidget) -> None:
        assert isinstance(dialog, ExportDialog)
        layouts = dialog.findChildren(QComboBox)[0]
        QTest.keyClick(layouts, Qt.Key.Key_Home)
        for _ in range(row):
            QTest.keyClick(layouts, Qt.Key.Key_Down)
        driver.in_dialog(lambda inner: _name(inner, path))
        save = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)  # type: ignore[union-attr]
        QTest.mouseClick(save, Qt.MouseButton.LeftButton)

    return act


def _name(dialog: QWidget, path: Path) -> None:
    assert isinstance(dialog, QFileDialog), type(dialog)
    name_file(dialog, path.name)
