import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.view.canvas.canvas import TAP
from tests.app.driver import CONTROL, LEFT, MIDDLE, PLAIN, SHIFT, SQUARE, Driver


@pytest.fixture
def square(driver: Driver) -> Driver:
    driver.draw("source", SQUARE)
    driver.key(Qt.Key.Key_S)
    return driver


def test_a_vertex_is_dragged_and_the_drag_is_one_step(square: Driver) -> None:
    square.drag("source", (90, 90), (60, 80), (50, 60), (70, 70))
    assert square.corners("source")[2] == [70, 70]
    assert square.session.undoes == "Move vertices"
    square.key(Qt.Key.Key_Z, CONTROL)
    assert square.corners("source") == [list(corner) for corner in SQUARE]


def test_a_drag_that_would_cross_is_shown_and_snaps_back(square: Driver) -> None:
    before = square.document
    square.press("source", 90, 90)
    square.hover("source", 70, 70)
    assert square.session.refusal is None
    square.hover("source", -20, 50)
    assert square.session.refusal is not None
    square.release("source", -20, 50)
    assert square.document == before
    assert square.session.refusal is not None
    square.hover("source", 50, 50)
    assert square.session.refusal is not None, "the reason stays to be read"
    square.click("source", (50, 50))
    assert square.session.refusal is None


def test_escape_ends_a_drag(square: Driver) -> None:
    before = square.document
    square.press("source", 90, 90)
    square.hover("source", 70, 70)
    square.key(Qt.Key.Key_Escape)
    square.release("source", 70, 70)
    assert square.document == before


def test_a_double_click_on_an_edge_inserts_and_delete_removes(square: Driver) -> None:
    square.double_click("source", 50, 10)
    assert square.corners("source")[1] == [50, 10]
    assert square.session.selection.vertices == {1}
    square.key(Qt.Key.Key_Delete)
    assert square.corners("source") == [list(corner) for corner in SQUARE]
    assert square.session.undoes == "Delete vertices"


def test_a_rubber_band_and_shift_select_and_arrows_nudge_as_one_step(square: Driver) -> None:
    square.drag("source", (0, 0), (100, 50))
    assert square.session.selection.vertices == {0, 1}
    square.click("source", (90, 90), modifier=SHIFT)
    assert square.session.selection.vertices == {0, 1, 2}
    before = square.document
    for _ in range(3):
        square.key(Qt.Key.Key_Right)
    scale = square.window.canvases["source"].camera.scale
    moved = square.document.vertices("source") - before.vertices("source")
    np.testing.assert_allclose(moved[:3], [[3 / scale, 0]] * 3, atol=1e-9)
    square.key(Qt.Key.Key_Z, CONTROL)
    assert square.document == before


def test_select_all_and_delete_remove_the_shape(square: Driver) -> None:
    square.key(Qt.Key.Key_A, CONTROL)
    square.key(Qt.Key.Key_Delete)
    assert square.document.source is None


def test_deleting_all_but_two_is_refused(square: Driver) -> None:
    square.drag("source", (0, 0), (100, 50))
    square.key(Qt.Key.Key_Delete)
    assert len(square.corners("source")) == 4
    assert square.session.refusal is not None


def test_undo_keeps_what_is_selected_where_vertices_keep_their_numbers(square: Driver) -> None:
    square.drag("source", (90, 90), (70, 70))
    square.key(Qt.Key.Key_Z, CONTROL)
    assert square.session.selection.vertices == {2}
    square.double_click("source", 50, 10)
    square.key(Qt.Key.Key_Z, CONTROL)
    assert not square.session.selection


def test_the_wheel_zooms_at_the_cursor(square: Driver) -> None:
    canvas = square.window.canvases["source"]
    place = QPointF(120, 80)
    fixed = canvas.camera.to_document(120, 80)
    scale = canvas.camera.scale
    event = QWheelEvent(
        place,
        QPointF(canvas.mapToGlobal(place)),
        QPoint(),
        QPoint(0, 240),
        Qt.MouseButton.NoButton,
        PLAIN,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(canvas, event)
    assert canvas.camera.scale > 1.5 * scale
    np.testing.assert_allclose(canvas.camera.to_document(120, 80), fixed)


@pytest.mark.parametrize("by_space", [True, False])
def test_middle_button_and_space_pan(square: Driver, by_space: bool) -> None:
    canvas = square.window.canvases["source"]
    under = canvas.camera.to_document(100, 100)
    button = LEFT if by_space else MIDDLE
    handle = square.window.windowHandle()
    start, stop = (canvas.mapTo(square.window, QPoint(x, y)) for x, y in ((100, 100), (160, 130)))
    if by_space:
        QTest.keyPress(canvas, Qt.Key.Key_Space)
    QTest.mousePress(handle, button, PLAIN, start)
    QTest.mouseMove(handle, stop)
    QTest.mouseRelease(handle, button, PLAIN, stop)
    if by_space:
        QTest.keyRelease(canvas, Qt.Key.Key_Space)
    np.testing.assert_allclose(canvas.camera.to_document(160, 130), under)
    assert not square.session.selection


def test_a_tap_of_space_plays_but_space_held_to_pan_does_not(driver: Driver) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    canvas, player = driver.window.canvases["source"], driver.window.player
    for playing in (True, False):
        QTest.keyClick(canvas, Qt.Key.Key_Space)
        assert player.playing is playing
    QTest.keyPress(canvas, Qt.Key.Key_Space)
    QTest.mousePress(canvas, LEFT, PLAIN, QPoint(100, 100))
    QTest.mouseRelease(canvas, LEFT, PLAIN, QPoint(100, 100))
    QTest.keyRelease(canvas, Qt.Key.Key_Space)
    assert not player.playing
    QTest.keyPress(canvas, Qt.Key.Key_Space)
    QTest.qWait(round(1100 * TAP))
    QTest.keyRelease(canvas, Qt.Key.Key_Space)
    assert not player.playing


def test_a_vertex_is_let_go_though_the_view_is_panned_meanwhile(square: Driver) -> None:
    canvas = square.window.canvases["source"]
    square.press("source", 90, 90)
    square.hover("source", 70, 70)
    place = canvas.camera.to_screen(np.array([70, 70])).astype(int)
    QTest.mousePress(canvas, MIDDLE, PLAIN, QPoint(*place.tolist()))
    QTest.mouseMove(canvas, QPoint(*(place + 40).tolist()))
    QTest.mouseRelease(canvas, LEFT, PLAIN, QPoint(*(place + 40).tolist()))
    assert not square.session.tool.busy
    under = canvas.camera.to_document(200, 200)
    QTest.mouseMove(canvas, QPoint(*(place + 60).tolist()))
    QTest.mouseRelease(canvas, MIDDLE, PLAIN, QPoint(*(place + 60).tolist()))
    np.testing.assert_allclose(canvas.camera.to_document(220, 220), under)


def test_a_canvas_that_is_left_with_space_held_has_its_own_cursor_again(square: Driver) -> None:
    canvas = square.window.canvases["source"]
    canvas.setFocus()
    QTest.keyPress(canvas, Qt.Key.Key_Space)
    assert canvas.cursor().shape() == Qt.CursorShape.OpenHandCursor
    square.window.canvases["target"].setFocus()
    assert canvas.cursor().shape() == Qt.CursorShape.ArrowCursor


def test_fit_shows_the_whole_shape(square: Driver) -> None:
    canvas = square.window.canvases["source"]
    canvas.zoom(40)
    square.key(Qt.Key.Key_F)
    places = canvas.camera.to_screen(square.document.vertices("source"))
    assert (places > 0).all()
    assert (places < (canvas.width(), canvas.height())).all()


def test_a_pointer_over_empty_ground_paints_nothing_anew(square: Driver) -> None:
    square.hover("source", 50, 50)
    emitted: list[None] = []
    square.session.changed.connect(lambda: emitted.append(None))
    square.hover("source", 40, 50)
    square.hover("source", 60, 40)
    assert not emitted
    square.hover("source", 90, 90)
    assert emitted


def test_editing_does_not_move_the_view(square: Driver) -> None:
    camera = square.window.canvases["source"].camera
    square.drag("source", (90, 90), (120, 130))
    assert square.corners("source")[2] == [120, 130]
    assert square.window.canvases["source"].camera == camera
