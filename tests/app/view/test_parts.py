"""Shapes of several parts, with mouse and keys: drawn, chosen, listed, paired, hidden, coloured, placed."""

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QColorDialog, QComboBox, QLineEdit, QWidget

from app.model.news import News
from app.model.pairing import Ends
from app.view.lists.parts_list import PartsTable
from app.view.lists.parts_model import NAME, SOURCE, TARGET
from app.view.main_window import MainWindow
from app.view.wording.counts import COUNTS
from starskel.files.key_shape import KeyShape
from starskel.files.project import Project
from starskel.files.step import Link, Step
from starskel.polygon import Polygon
from starskel.shapes.shape_blend import ShapeBlend
from tests.app.driver import CONTROL, LEFT, SHIFT, SQUARE, Driver

METHODS = ("stitched", "vertex")
EYE = ((20, 55), (35, 55), (35, 70), (20, 70))


def box(x: float, y: float, width: float, height: float) -> Polygon:
    return Polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)])


FACE, LEFT_EYE, RIGHT_EYE = box(10, 10, 80, 80), box(20, 55, 15, 15), box(65, 55, 15, 15)


@pytest.fixture
def face(driver: Driver) -> Driver:
    shape = KeyShape.of(FACE, LEFT_EYE, RIGHT_EYE)
    step = Step(tuple(Link(k, k) for k in range(3)))
    driver.session.show_project(Project("face", (shape, shape), (step,), METHODS))
    driver.wait_for_blends()
    return driver


def table(driver: Driver) -> PartsTable:
    return driver.window.parts.table


def ends(driver: Driver) -> list[Ends]:
    return [link.ends for link in driver.document.way.links]


def go_to(driver: Driver, row: int, column: int) -> None:
    view = table(driver)
    place = view.visualRect(view.model().index(row, column)).center() + QPoint(20, 0)
    QTest.mouseClick(view.viewport(), LEFT, pos=place)


def drag(driver: Driver, start: tuple[int, int], stop: tuple[int, int], *, besides: bool = False) -> None:
    """Drop a cell of the list on another one, as Qt tells of it; offscreen there is no drag to follow."""
    view, model = table(driver), table(driver).model()
    data: QMimeData = model.mimeData([model.index(*start)])
    action = Qt.DropAction.CopyAction if besides else Qt.DropAction.MoveAction
    place = QPointF(view.visualRect(model.index(*stop)).center())
    keys = CONTROL if besides else Qt.KeyboardModifier.NoModifier
    event = QDropEvent(place, Qt.DropAction.MoveAction | Qt.DropAction.CopyAction, data, LEFT, keys)
    event.setDropAction(action)
    view.dropEvent(event)


def test_one_part_looks_as_simple_as_ever(driver: Driver) -> None:
    driver.draw_both()
    assert not driver.window.parts.isVisible()
    assert not driver.window.actions_table["suggest-pairing"].isEnabled()


def test_a_part_is_added_drawn_and_blended_with_its_partner(driver: Driver) -> None:
    driver.draw_both()
    driver.key(Qt.Key.Key_A, CONTROL | SHIFT)
    assert driver.session.tool.name == "draw"
    driver.click("source", *EYE)
    driver.key(Qt.Key.Key_Return)
    assert ends(driver) == [(0, 0), (1, None)]
    driver.click("target", *EYE)
    driver.key(Qt.Key.Key_Return)
    assert ends(driver) == [(0, 0), (1, 1)]
    assert driver.window.parts.isVisible()
    driver.wait_for_blends()
    result = driver.session.blends.results["stitched"].result
    assert result is not None
    assert isinstance(result.blend, ShapeBlend)
    assert result.outer == (-1, 0)
    assert result.report.simple
    for _ in range(2):
        driver.key(Qt.Key.Key_Z, CONTROL)
    assert ends(driver) == [(0, 0)]


def test_a_click_chooses_the_part_under_it_and_a_drag_moves_it(face: Driver) -> None:
    face.key(Qt.Key.Key_S)
    face.click("source", (72, 62))
    assert (face.document.link, face.session.selection.vertices) == (2, frozenset(range(4)))
    assert face.session.undoes is None
    face.drag("source", (72, 62), (72, 42), (72, 32))
    assert face.document.shape("source").rings[:2] == (FACE, LEFT_EYE)
    assert np.allclose(face.document.vertices("source").mean(axis=0), (72.5, 32.5), atol=1)
    face.click("target", (50, 30))
    assert face.document.link == 0
    face.click("target", (20, 60))
    assert face.document.link == 1


def test_parts_nudged_one_after_the_other_are_put_back_one_by_one(face: Driver) -> None:
    face.key(Qt.Key.Key_S)
    for eye in ((27, 62), (72, 62)):
        face.click("source", eye)
        face.key(Qt.Key.Key_Right)
        face.key(Qt.Key.Key_Right)
    face.key(Qt.Key.Key_Z, CONTROL)
    assert face.document.shape("source").rings[2] == RIGHT_EYE
    assert face.document.shape("source").rings[1] != LEFT_EYE
    face.key(Qt.Key.Key_Z, CONTROL)
    assert face.document.shape("source").rings == (FACE, LEFT_EYE, RIGHT_EYE)


def test_marks_are_set_on_the_part_that_is_marked(face: Driver) -> None:
    face.mark((35, 70), (35, 70))
    assert face.document.way.links[1].marks == ((2, 2),)
    assert face.document.marks == ((2, 2),)
    face.window.actions_table["suggest"].trigger()
    face.wait(lambda: len(face.document.marks) > 1)
    assert [bool(link.marks) for link in face.document.way.links] == [False, True, False]


def test_marks_suggested_for_a_part_that_was_left_meanwhile_mark_no_other(face: Driver) -> None:
    face.session.show_link(1)
    face.session.suggest_marks(4)
    face.session.show_link(2)
    face.wait_for_blends()
    assert not any(link.marks for link in face.document.way.links)
    assert not any(state.stale for state in face.session.blends.results.values())


def test_holes_that_meet_are_refused_and_shown(face: Driver) -> None:
    face.key(Qt.Key.Key_S)
    face.click("source", (72, 62))
    face.drag("source", (72, 62), (40, 66), (30, 66))
    refusal = face.session.refusal
    assert refusal is not None
    assert refusal.places
    assert face.document.shape("source").rings == (FACE, LEFT_EYE, RIGHT_EYE)


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


def _area(ring: np.ndarray) -> float:
    x, y = ring.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def test_a_part_alone_grows_from_where_the_user_says(face: Driver) -> None:
    go_to(face, 0, NAME)
    face.key(Qt.Key.Key_B, CONTROL | SHIFT)
    assert ends(face)[2:] == [(2, None), (None, 2)]
    face.wait_for_blends()
    face.key(Qt.Key.Key_G, CONTROL | SHIFT)
    face.click("target", (50, 30))
    assert face.session.undoes == "Set place of growth"
    face.wait_for_blends()
    result = face.session.blends.results["stitched"].result
    assert result is not None
    assert np.allclose(result.rings_at(1.0)[2], face.document.pair.place, atol=1e-6)
    assert np.allclose(face.document.pair.place, (50, 30), atol=1)
    face.window.actions_table["usual-place"].trigger()
    assert face.document.pair.place is None


def test_removed_parts_come_back(face: Driver) -> None:
    go_to(face, 0, NAME)
    QTest.keyClick(table(face), Qt.Key.Key_Delete)
    assert ends(face) == [(0, 0), (1, 1)]
    face.key(Qt.Key.Key_Z, CONTROL)
    assert ends(face) == [(0, 0), (1, 1), (2, 2)]


def test_a_pairing_is_suggested_and_parts_move_each_by_itself(face: Driver) -> None:
    drag(face, (0, TARGET), (1, TARGET))
    face.window.actions_table["suggest-pairing"].trigger()
    assert set(ends(face)) == {(0, 0), (1, 1), (2, 2)}
    face.window.actions_table["joined"].trigger()
    assert not face.document.way.joined
    assert face.session.undoes == "Move separately"
    face.wait_for_blends()
    result = face.session.blends.results["stitched"].result
    assert result is not None
    assert isinstance(result.blend, ShapeBlend)
    assert result.blend.meta_skeleton is None


def test_everything_is_saved(face: Driver, tmp_path) -> None:  # type: ignore[no-untyped-def]
    go_to(face, 0, NAME)
    face.key(Qt.Key.Key_B, CONTROL | SHIFT)
    face.window.partnering.rename(0, "face")
    face.session.save(tmp_path / "face.json")
    saved = face.document
    face.session.new()
    face.session.open(tmp_path / "face.json")
    assert face.document.showing(0, 0).sequence == saved.sequence
    assert not face.session.unsaved


def test_a_new_shape_in_the_sequence_keeps_the_parts_apart(face: Driver) -> None:
    face.window.actions_table["shape-duplicate"].trigger()
    assert ends(face) == [(0, 0), (1, 1), (2, 2)]
    face.window.actions_table["shape-add"].trigger()
    assert ends(face) == [(0, None), (1, None), (2, None)]
    face.draw("target", SQUARE)
    assert ends(face) == [(0, 0), (1, None), (2, None)]


@pytest.mark.parametrize("switch", ["pieces", "skeleton"])
def test_star_pieces_and_skeletons_of_parts_with_holes_are_shown(face: Driver, switch: str) -> None:
    views = [face.window.canvases["source"], face.window.panels.panel("stitched").view]
    holes = [view.camera.to_screen(np.array([27.5, 62.5])).round().astype(int) for view in views]
    before = [view.grab().toImage() for view in views]
    face.window.actions_table[switch].trigger()
    after = [view.grab().toImage() for view in views]
    for one, other, (x, y) in zip(before, after, holes, strict=True):
        assert one != other
        assert one.pixelColor(x, y) == other.pixelColor(x, y)  # a hole stays empty
    face.window.actions_table[switch].trigger()
    assert [view.grab().toImage() for view in views] == before


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


def test_select_all_takes_the_part_and_once_more_all_parts(face: Driver) -> None:
    face.key(Qt.Key.Key_A, CONTROL)
    assert face.session.selection.vertices == {0, 1, 2, 3}
    assert not face.session.selection.links
    face.key(Qt.Key.Key_A, CONTROL)
    assert face.session.selection.links == {0, 1, 2}
    face.window.actions_table["copy"].trigger()
    face.key(Qt.Key.Key_Delete)
    assert not face.document.shape("source").parts
    assert face.session.undoes == "Delete parts"
    face.window.actions_table["paste"].trigger()
    assert face.document.shape("source").rings == (FACE, LEFT_EYE, RIGHT_EYE)


def test_a_hole_that_becomes_a_part_is_told(face: Driver) -> None:
    face.key(Qt.Key.Key_S)
    face.click("source", (72, 62))
    before = face.window.canvases["source"].grab().toImage()
    face.drag("source", (72, 62), (80, 64), (92, 66))
    assert face.document.shape("source").shape.outer == (-1, 0, -1)
    assert face.session.news == News(filled=1)
    assert "parts now" in COUNTS.news(face.session.news)
    assert face.window.canvases["source"].grab().toImage() != before
    face.key(Qt.Key.Key_Escape)
    assert not face.session.news
    face.drag("source", (96, 66), (80, 64), (76, 62))
    assert face.session.news == News(opened=1)
    face.click("source", (50, 30))
    assert not face.session.news


def test_a_part_has_the_same_icon_until_it_looks_different(face: Driver) -> None:
    def icons() -> list[int]:
        model = table(face).model()
        return [model.index(row, SOURCE).data(Qt.ItemDataRole.DecorationRole).cacheKey() for row in range(3)]

    before = icons()
    assert icons() == before
    face.key(Qt.Key.Key_S)
    face.drag("source", (10, 10), (12, 12))
    assert [a == b for a, b in zip(icons(), before, strict=True)] == [True, True, False]
