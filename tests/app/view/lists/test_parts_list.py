"""The list of parts, with mouse and keys: chosen, named, hidden, coloured, exchanged, copied."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QColorDialog, QComboBox, QLineEdit, QWidget

from app.view.lists.parts_list import PartsTable
from app.view.lists.parts_model import NAME, SOURCE, TARGET
from app.view.main_window import MainWindow
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project
from starskel.files.projects.step import Link, Step
from starskel.files.raster_writing import png_of
from tests.app.driver import CONTROL, LEFT, SHIFT, Driver
from tests.app.view.faces import FACE, LEFT_EYE, METHODS, RIGHT_EYE, box, drag, ends, go_to, table


def test_the_list_follows_and_chooses_the_part_worked_on(face: Driver) -> None:
    assert table(face).isVisible()
    go_to(face, 0, NAME)
    assert face.document.link == 2  # what is painted last is on top
    face.key(Qt.Key.Key_PageUp, SHIFT)
    assert face.document.link == 1
    assert table(face).currentIndex().row() == 1
    QTest.keyClick(table(face), Qt.Key.Key_Down)
    assert face.document.link == 0
    assert face.session.undoes is None


def test_a_part_is_hidden_renamed_and_coloured(face: Driver) -> None:
    go_to(face, 1, NAME)
    view = face.window.panels.panel("stitched").view
    before = view.grab().toImage()
    QTest.keyClick(table(face), Qt.Key.Key_Space)
    assert [part.visible for part in face.document.shape("source").parts] == [True, False, True]
    assert face.session.undoes == "Hide part"
    assert view.grab().toImage() != before
    QTest.keyClick(table(face), Qt.Key.Key_Return)
    editor = table(face).findChild(QLineEdit)
    assert editor is not None
    editor.selectAll()
    QTest.keyClicks(editor, "eye")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    face.wait(lambda: face.document.shape("target").parts[1].name == "eye")

    def choose(dialog: QWidget) -> None:
        assert isinstance(dialog, QColorDialog)
        dialog.setCurrentColor(QColor("#118833"))
        dialog.accept()

    face.in_dialog(choose)
    face.window.actions_table["part-colour"].trigger()
    assert face.document.shape("source").parts[1].colour == "#118833"
    assert not face.session.blends.busy  # looks are not blended anew
    face.window.actions_table["part-usual-colour"].trigger()
    assert face.document.shape("source").parts[1].colour == ""


def test_a_dragged_partner_is_exchanged(face: Driver) -> None:
    drag(face, (0, TARGET), (1, TARGET))
    assert ends(face) == [(0, 0), (1, 2), (2, 1)]
    assert face.session.undoes == "Pair parts"
    drag(face, (0, SOURCE), (1, NAME))
    assert ends(face) == [(0, 0), (1, 1), (2, 2)]
    face.wait_for_blends()
    assert all(state.error is None for state in face.session.blends.results.values())


def test_a_dragged_name_is_painted_elsewhere(face: Driver) -> None:
    drag(face, (0, NAME), (2, NAME))
    assert ends(face) == [(2, 2), (0, 0), (1, 1)]
    face.key(Qt.Key.Key_Up, CONTROL | SHIFT)
    assert ends(face) == [(0, 0), (2, 2), (1, 1)]


def test_the_keyboard_alone_leaves_parts_alone_and_pairs_them(face: Driver) -> None:
    view = table(face)
    view.setFocus()
    view.setCurrentIndex(view.model().index(0, TARGET))
    QTest.keyClick(view, Qt.Key.Key_Return)
    choose(view, 3)
    assert ends(face) == [(0, 0), (1, 1), (2, None), (None, 2)]
    view.setCurrentIndex(view.model().index(1, TARGET))
    QTest.keyClick(view, Qt.Key.Key_Return)
    choose(view, 2)
    assert ends(face) == [(0, 0), (1, 1), (2, 2)]


def choose(view: PartsTable, index: int) -> None:
    box = view.findChildren(QComboBox)[-1]
    box.setCurrentIndex(index)
    box.activated.emit(index)


def _area(ring: np.ndarray) -> float:
    x, y = ring.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def test_a_part_is_split_by_a_drag_with_control(driver: Driver) -> None:
    one, two = KeyShape.of(FACE), KeyShape.of(box(10, 10, 30, 80), box(60, 10, 30, 80))
    step = Step((Link(0, 0), Link(None, 1)))
    driver.session.show_project(Project("split", (one, two), (step,), METHODS))
    drag(driver, (0, TARGET), (1, TARGET), besides=True)
    assert ends(driver) == [(0, 0), (0, 1)]
    driver.wait_for_blends()
    result = driver.session.blends.results["stitched"].result
    assert result is not None
    assert sum(abs(_area(ring)) for ring in result.rings_at(0.0)) == pytest.approx(FACE.area, rel=1e-6)


def choose_rows(driver: Driver, *rows: int) -> None:
    """Click rows of the list, with Control from the second on."""
    view = table(driver)
    for number, row in enumerate(rows):
        place = view.visualRect(view.model().index(row, NAME)).center() + QPoint(20, 0)
        QTest.mouseClick(view.viewport(), LEFT, CONTROL if number else Qt.KeyboardModifier.NoModifier, place)


def test_parts_chosen_in_the_list_are_copied_cut_and_pasted_together(face: Driver) -> None:
    face.window.actions_table["parts"].trigger()
    choose_rows(face, 0, 1)  # both eyes
    assert face.session.selection.links == {1, 2}
    face.window.actions_table["cut"].trigger()
    assert face.document.shape("source").rings == (FACE,)
    assert len(face.document.shape("target")) == 3
    face.window.actions_table["paste"].trigger()
    assert set(face.document.shape("source").rings) == {FACE, LEFT_EYE, RIGHT_EYE}
    assert set(ends(face)) == {(0, 0), (1, 1), (2, 2)}  # what is put back finds its partners
    assert face.session.undoes == "Paste shape"
    face.session.undo()
    face.session.undo()
    assert len(face.document.shape("source")) == 3


def test_a_click_in_the_list_chooses_one_part_again(face: Driver) -> None:
    face.window.actions_table["parts"].trigger()
    choose_rows(face, 0, 1, 2)
    assert face.session.selection.links == {0, 1, 2}
    choose_rows(face, 1)
    assert not face.session.selection.links
    assert face.document.link == 1


def test_the_list_that_opens_with_several_parts_does_not_make_the_window_wider(
    driver: Driver, window: MainWindow
) -> None:
    window.resize(1024, 760)
    window.files.open_example("letters-a-r")
    driver.wait(window.parts.isVisible)
    driver.wait(lambda: bool(window.session.blends.fresh))
    assert window.width() == 1024


def names(driver: Driver) -> list[str]:
    """Give what the list calls the parts, from the top."""
    model = table(driver).model()
    return [model.data(model.index(row, NAME)) for row in range(model.rowCount())]


def test_no_two_parts_have_the_same_number_for_a_name(face: Driver) -> None:
    assert names(face) == ["Part 3", "Part 2", "Part 1"]
    go_to(face, 0, NAME)
    face.key(Qt.Key.Key_B, CONTROL | SHIFT)
    assert names(face) == ["New part 3", "Part 3", "Part 2", "Part 1"]
    drag(face, (1, SOURCE), (0, SOURCE))
    drag(face, (0, TARGET), (1, TARGET), besides=True)
    assert len(set(names(face))) == len(names(face))


def test_a_name_that_is_not_changed_is_none(face: Driver) -> None:
    go_to(face, 0, NAME)
    QTest.keyClick(table(face), Qt.Key.Key_Return)
    editor = table(face).findChild(QLineEdit)
    assert editor is not None
    QTest.keyClick(editor, Qt.Key.Key_Return)
    face.wait(lambda: table(face).findChild(QLineEdit) is None)
    assert face.document.shape("source").parts[2].name == ""
    assert face.session.undoes is None


def test_a_part_has_the_same_icon_until_it_looks_different(face: Driver) -> None:
    def icons() -> list[int]:
        model = table(face).model()
        return [model.index(row, SOURCE).data(Qt.ItemDataRole.DecorationRole).cacheKey() for row in range(3)]

    before = icons()
    assert icons() == before
    face.key(Qt.Key.Key_S)
    face.drag("source", (10, 10), (12, 12))
    assert [a == b for a, b in zip(icons(), before, strict=True)] == [True, True, False]


def test_a_picture_behind_nothing_tells_of_no_rows(driver: Driver) -> None:
    driver.session.show_project(Project("empty", (KeyShape(), KeyShape()), (Step(()),), METHODS))
    told = []
    table(driver).model().dataChanged.connect(lambda first, last: told.append((first, last)))
    pixels = png_of(np.full((20, 20, 4), 255, dtype=np.uint8))
    behind = Picture(pixels, (0, 0), (20, 20))
    driver.session.store(driver.document.put_picture("source", behind), "Place picture")
    driver.session.store(driver.document.draw("source", FACE), "Draw")
    driver.session.store(driver.document.put_picture("source", None), "Take picture away")
    assert told
    assert all(first.isValid() and last.isValid() for first, last in told)
