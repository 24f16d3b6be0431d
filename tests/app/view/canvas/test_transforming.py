import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDoubleSpinBox

from app.tools.handles import handle_places
from app.tools.settings import Snapping, ToolSettings
from app.tools.tool import Pointer
from tests.app.driver import CONTROL, SHIFT, SQUARE, Driver

ALT = Qt.KeyboardModifier.AltModifier


@pytest.fixture
def square(driver: Driver) -> Driver:
    driver.draw("source", SQUARE)
    driver.key(Qt.Key.Key_S)
    driver.key(Qt.Key.Key_A, CONTROL)
    driver.window.canvases["source"].zoom(0.8)
    driver.session.set(ToolSettings(snapping=Snapping(vertices=False, edges=False)))
    return driver


def is_at(driver: Driver, *corners: tuple[float, float], within: float = 2.5) -> None:
    np.testing.assert_allclose(driver.document.vertices("source"), corners, atol=within)


def handle(driver: Driver, name: str) -> tuple[float, float]:
    frame = driver.session.overlay("source").frame
    assert frame is not None
    camera = driver.window.canvases["source"].camera
    return handle_places(frame, 1 / camera.scale, camera.seen)[name]


def drag_handle(driver: Driver, name: str, x: float, y: float) -> None:
    """Drag a handle by a way."""
    start = handle(driver, name)
    driver.hover("source", *start)
    assert driver.session.overlay("source").handle == name
    driver.drag("source", start, (start[0] + x / 2, start[1] + y / 2), (start[0] + x, start[1] + y))


def test_a_corner_scales_and_the_opposite_one_stays(square: Driver) -> None:
    drag_handle(square, "north-east", 40, 20)
    is_at(square, (10, 10), (130, 10), (130, 110), (10, 110))
    assert square.session.undoes == "Scale"
    square.key(Qt.Key.Key_Z, CONTROL)
    is_at(square, *SQUARE)


def test_a_side_scales_one_way(square: Driver) -> None:
    drag_handle(square, "west", 20, 15)
    is_at(square, (30, 10), (90, 10), (90, 90), (30, 90))


def test_the_stalk_turns(square: Driver) -> None:
    x, y = handle(square, "turn")
    square.drag("source", (x, y), (x + 20, y), (50 + (y - 50), 50))
    np.testing.assert_allclose(square.corners("source"), [[10, 90], [10, 10], [90, 10], [90, 90]], atol=2)
    assert square.session.undoes == "Turn"


def test_a_side_dragged_over_the_opposite_one_mirrors(square: Driver) -> None:
    drag_handle(square, "east", -120, 0)
    assert square.session.refusal is None
    np.testing.assert_allclose(square.document.vertices("source").min(axis=0), (-30, 10), atol=2.5)
    np.testing.assert_allclose(square.document.vertices("source").max(axis=0), (10, 90), atol=2.5)
    assert square.session.selection.vertices == {0, 1, 2, 3}


def test_dragging_inside_the_frame_moves_the_whole_shape(square: Driver) -> None:
    square.drag("source", (50, 50), (55, 60), (63, 71))
    is_at(square, (23, 31), (103, 31), (103, 111), (23, 111))
    assert square.session.selection.vertices == {0, 1, 2, 3}


def test_a_click_inside_selects_the_shape_and_one_beside_it_nothing(square: Driver) -> None:
    square.click("source", (140, 140))
    assert not square.session.selection
    square.click("source", (50, 50))
    assert square.session.selection.vertices == {0, 1, 2, 3}


def test_an_edge_is_dragged_with_both_its_ends(square: Driver) -> None:
    square.click("source", (140, 140))
    square.drag("source", (50, 90), (52, 100), (57, 113))
    is_at(square, (10, 10), (90, 10), (97, 113), (17, 113))


def test_arrow_keys_with_alt_turn_and_scale(square: Driver) -> None:
    square.click("source", (50, 50))
    for _ in range(6):
        square.key(Qt.Key.Key_Left, SHIFT | ALT)
    np.testing.assert_allclose(square.corners("source")[0], [90, 10], atol=0.6)
    square.key(Qt.Key.Key_Up, SHIFT | ALT)
    np.testing.assert_allclose(np.ptp(square.document.vertices("source"), axis=0), (88, 88), atol=1)
    square.key(Qt.Key.Key_Z, CONTROL)
    square.key(Qt.Key.Key_Z, CONTROL)
    is_at(square, *SQUARE)


def test_a_shape_larger_than_its_canvas_can_be_turned(square: Driver) -> None:
    canvas = square.window.canvases["source"]
    canvas.zoom(2)
    x, y = handle(square, "turn")
    assert canvas.rect().contains(*map(round, canvas.camera.to_screen(np.array([x, y])).tolist()))
    drag_handle(square, "turn", 50 - x - (y - 50), 50 - y)
    assert square.session.undoes == "Turn"
    np.testing.assert_allclose(square.corners("source"), [[90, 10], [90, 90], [10, 90], [10, 10]], atol=2)


def enter(driver: Driver, name: str, text: str) -> None:
    field = driver.window.options.pages["select"].findChild(QDoubleSpinBox, name)
    assert field is not None
    assert field.isEnabled()
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)


def number(driver: Driver, name: str) -> float:
    field = driver.window.options.pages["select"].findChild(QDoubleSpinBox, name)
    assert field is not None
    return field.value()


def test_numbers_show_and_set_place_and_size(square: Driver) -> None:
    assert [round(number(square, name)) for name in ("x", "y", "width", "height")] == [50, 50, 80, 80]
    enter(square, "x", "70")
    enter(square, "height", "40")
    np.testing.assert_allclose(
        square.document.vertices("source").round(), [[30, 30], [110, 30], [110, 70], [30, 70]], atol=1
    )


def test_numbers_turn_from_where_the_selection_was(square: Driver) -> None:
    enter(square, "turn", "90")
    np.testing.assert_allclose(square.corners("source")[0], [90, 10], atol=1)
    assert number(square, "turn") == 90
    enter(square, "turn", "0")
    np.testing.assert_allclose(square.corners("source")[0], [10, 10], atol=1)


def test_a_turn_that_was_taken_back_can_be_entered_again(square: Driver) -> None:
    for _ in range(2):
        enter(square, "turn", "90")
        np.testing.assert_allclose(square.corners("source")[0], [90, 10], atol=1)
        square.key(Qt.Key.Key_Z, CONTROL)
        is_at(square, *SQUARE)
        assert number(square, "turn") == 0


def test_what_is_being_typed_stays_while_the_pointer_moves_over_the_canvas(square: Driver) -> None:
    field = square.window.options.pages["select"].findChild(QDoubleSpinBox, "x")
    assert field is not None
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "70")
    square.hover("source", 90, 90)
    assert square.session.overlay("source").vertex == 2
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert round(square.corners("source")[0][0]) == 30
    assert field.text() == "70.00"


def test_escape_gives_up_what_is_typed_and_then_the_selection(square: Driver) -> None:
    field = square.window.options.pages["select"].findChild(QDoubleSpinBox, "x")
    assert field is not None
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "70")
    square.key(Qt.Key.Key_Escape)
    assert field.text() == "50.00"
    assert len(square.session.selection.vertices) == 4
    square.key(Qt.Key.Key_Escape)
    assert not square.session.selection
    is_at(square, *SQUARE)


def test_one_vertex_has_a_place_but_no_size(square: Driver) -> None:
    square.click("source", (140, 140))
    square.click("source", (90, 90))
    enter(square, "y", "60")
    assert square.corners("source")[2] == [90, 60]
    field = square.window.options.pages["select"].findChild(QDoubleSpinBox, "width")
    assert field is not None
    assert not field.isEnabled()


def test_a_dragged_vertex_is_caught_by_the_height_of_another_unless_control_is_held(square: Driver) -> None:
    square.session.set(ToolSettings())
    square.click("source", (140, 140))
    square.press("source", 90, 90)
    square.hover("source", 70, 70)
    near = (70.0, 11.5)
    square.hover("source", *near)
    catch = square.session.overlay("source").catch
    assert catch is not None
    assert catch.kind == "aligned"
    assert catch.at[1] == square.document.vertices("source")[0, 1]
    pixel = 1 / square.window.canvases["source"].camera.scale
    square.session.move(Pointer("source", near, 9 * pixel, free=True))
    catch = square.session.overlay("source").catch
    assert catch is not None
    assert catch.kind == ""


def test_the_grid_is_switched_shown_and_catches(square: Driver) -> None:
    plain = square.window.canvases["source"].grab().toImage()
    square.key(Qt.Key.Key_G, CONTROL | ALT)
    assert square.window.canvases["source"].grab().toImage() != plain
    square.click("source", (140, 140))
    square.drag("source", (90, 90), (104, 104), (118.4, 117.7))
    assert square.document.vertices("source")[2].tolist() == [120, 120]
