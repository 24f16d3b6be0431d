"""Shapes of several parts, with mouse and keys: drawn, chosen, paired, placed, removed, saved."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.model.news import News
from app.view.lists.parts_model import NAME, TARGET
from app.view.wording.counts import COUNTS
from starskel.shapes.shape_blend import ShapeBlend
from tests.app.driver import CONTROL, SHIFT, SQUARE, Driver
from tests.app.view.faces import (
    EYE,
    FACE,
    LEFT_EYE,
    RIGHT_EYE,
    drag,
    ends,
    go_to,
    table,
)


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
    face.save(tmp_path / "face.json")
    saved = face.document
    face.session.new()
    face.open(tmp_path / "face.json")
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
