"""Outlines traced in the picture behind a shape, through the dialog."""

from collections.abc import Callable

import numpy as np
import pytest
import shapely
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QComboBox, QDialogButtonBox, QLabel, QSlider, QWidget

from app.model import placing
from app.model.selection import Selection
from app.view.pictures.trace_dialog import TraceDialog
from starskel.files.projects.picture import Picture
from starskel.files.raster_writing import png_of
from tests.app.driver import CONTROL, SQUARE, Driver

SIZE = 80
KIND = QDialogButtonBox.StandardButton


def discs() -> bytes:
    """A large disc with a hole and a small disc, opaque on nothing."""
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5
    large, small = np.hypot(x - 30, y - 40), np.hypot(x - 68, y - 40)
    pixels = np.zeros((SIZE, SIZE, 4), dtype=np.uint8)
    pixels[((large < 25) & (large > 8)) | (small < 8)] = (20, 90, 200, 255)
    return png_of(pixels)


@pytest.fixture
def pictured(driver: Driver) -> Driver:
    picture = Picture(discs(), (50.0, 50.0), (80.0, 80.0), rotation=0.5)
    driver.session.store(driver.document.put_picture("source", picture), "Place picture")
    driver.session.choose_tool("picture")
    return driver


def tracing(driver: Driver, act: Callable[[TraceDialog], None]) -> None:
    """Open the dialog, wait for the first outline, act, and close what is still open."""

    def inside(dialog: QWidget) -> None:
        assert isinstance(dialog, TraceDialog)
        driver.wait(lambda: dialog.found is not None)
        act(dialog)
        if dialog.isVisible():
            dialog.reject()

    driver.in_dialog(inside)
    driver.window.actions_table["picture-trace"].trigger()


def press(dialog: TraceDialog, button: KIND) -> None:
    box = dialog.findChild(QDialogButtonBox)
    assert box is not None
    QTest.mouseClick(box.button(button), Qt.MouseButton.LeftButton)


def slide(dialog: TraceDialog, name: str, value: int) -> None:
    slider = dialog.findChild(QSlider, name)
    assert slider is not None
    slider.setValue(value)


def verdict(dialog: TraceDialog) -> str:
    label = dialog.findChild(QLabel, "verdict")
    assert label is not None
    return label.text()


def boxes(dialog: TraceDialog) -> list[QCheckBox]:
    return dialog.findChildren(QCheckBox)


def test_the_outline_of_what_is_opaque_becomes_the_shape_as_one_step(pictured: Driver) -> None:
    before = pictured.document
    tracing(pictured, lambda dialog: press(dialog, KIND.Ok))
    shape = pictured.document.shape("source")
    assert shape.shape.outer == (-1, 0)
    assert pictured.session.undoes == "Trace outline"
    picture = pictured.document.picture("source")
    assert picture is not None
    middle = placing.place_on(picture, 30 / SIZE, 1 - 40 / SIZE)  # as the picture is turned
    disc = shapely.Point(middle).buffer(25, 64)
    assert shapely.hausdorff_distance(shapely.Polygon(shape.rings[0].vertices), disc) < 1.6
    pictured.key(Qt.Key.Key_Z, CONTROL)
    assert pictured.document == before


def test_all_parts_come_with_their_holes_where_they_are_wanted(pictured: Driver) -> None:
    def every_part(dialog: TraceDialog) -> None:
        assert "1 hole" in verdict(dialog)
        boxes(dialog)[0].setChecked(True)
        pictured.wait(lambda: dialog.found is not None and len(dialog.found.shape) == 3)
        assert "2 parts, 1 hole" in verdict(dialog)
        boxes(dialog)[1].setChecked(False)
        pictured.wait(lambda: dialog.found is not None and len(dialog.found.shape) == 2)
        press(dialog, KIND.Ok)

    tracing(pictured, every_part)
    assert pictured.document.shape("source").shape.outer == (-1, -1)


def test_a_larger_tolerance_leaves_fewer_vertices(pictured: Driver) -> None:
    def simplify(dialog: TraceDialog) -> None:
        found = dialog.found
        assert found is not None
        slide(dialog, "tolerance", 60)
        pictured.wait(lambda: dialog.found is not None and dialog.found is not found)
        assert dialog.found is not None
        assert len(dialog.found.shape.rings[0]) < len(found.shape.rings[0])

    tracing(pictured, simplify)


def test_where_nothing_is_found_it_says_so_and_nothing_can_be_taken(pictured: Driver) -> None:
    def nothing(dialog: TraceDialog) -> None:
        by = dialog.findChild(QComboBox)
        assert by is not None
        assert by.currentData() == "alpha"
        QTest.keyClick(by, Qt.Key.Key_Down)
        QTest.keyClick(by, Qt.Key.Key_Down)  # light, where there is but blue
        slide(dialog, "level", 98)
        pictured.wait(lambda: dialog.found is None and verdict(dialog).startswith("✕"))
        assert "Nothing in the picture is light enough at a level of 0.98" in verdict(dialog)
        box = dialog.findChild(QDialogButtonBox)
        assert box is not None
        assert not box.button(KIND.Ok).isEnabled()
        dialog.accept()
        assert dialog.isVisible()
        slide(dialog, "level", 20)
        pictured.wait(lambda: dialog.found is not None)

    tracing(pictured, nothing)
    assert not pictured.document.shape("source").parts


def test_cancel_leaves_the_shape_as_it_is(pictured: Driver) -> None:
    pictured.draw("source", SQUARE)
    before = pictured.document
    tracing(pictured, lambda dialog: press(dialog, KIND.Cancel))
    assert pictured.document == before


def test_what_is_traced_takes_the_place_of_the_shape_and_is_paired_anew(pictured: Driver) -> None:
    pictured.draw_both()
    pictured.mark(SQUARE[0], SQUARE[0])
    pictured.session.choose_tool("picture")
    pictured.session.choose(Selection("source"))

    def every_part(dialog: TraceDialog) -> None:
        boxes(dialog)[0].setChecked(True)
        dialog.accept()  # while it is being traced: that is waited for
        pictured.wait(lambda: not dialog.isVisible())

    tracing(pictured, every_part)
    assert len(pictured.document.shape("source")) == 3
    assert len(pictured.document.way.links) == 3
    assert not pictured.document.marks
    pictured.wait_for_blends()


def test_a_damaged_picture_is_told(driver: Driver) -> None:
    driver.session.store(
        driver.document.put_picture("source", Picture(b"no", (0, 0), (9, 9))), "Place picture"
    )

    def inside(dialog: QWidget) -> None:
        assert isinstance(dialog, TraceDialog)
        driver.wait(lambda: "no picture" in verdict(dialog))
        dialog.reject()

    driver.in_dialog(inside)
    driver.session.choose_tool("picture")
    driver.window.actions_table["picture-trace"].trigger()
