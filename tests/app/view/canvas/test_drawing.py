import pytest
from PySide6.QtCore import Qt

from app.tools.draw import PolygonBegun
from tests.app.driver import CONTROL, SQUARE, TRIANGLE, Driver


def test_a_shape_is_drawn_by_clicks_and_closed_on_its_first_vertex(driver: Driver) -> None:
    driver.click("source", *TRIANGLE, TRIANGLE[0])
    assert driver.corners("source") == [[10, 10], [90, 10], [50, 80]]
    assert driver.session.undoes == "Draw shape"


def test_enter_closes_a_shape(driver: Driver) -> None:
    driver.click("target", *TRIANGLE)
    driver.key(Qt.Key.Key_Return)
    assert driver.corners("target") == [[10, 10], [90, 10], [50, 80]]
    assert driver.document.source is None


def test_a_crossing_edge_is_refused_in_words_and_not_stored(driver: Driver) -> None:
    driver.click("source", (10, 10), (90, 10), (50, 50), (50, -5))
    refusal = driver.session.refusal
    assert refusal is not None
    assert len(refusal.segments) == 2
    assert isinstance(driver.session.tool, PolygonBegun)
    assert len(driver.session.tool.points) == 3
    driver.click("source", (20, 40))
    assert driver.session.refusal is None
    assert len(driver.session.tool.points) == 4


def test_the_refused_edge_is_painted_red(driver: Driver) -> None:
    driver.click("source", (10, 10), (90, 10), (50, 50))
    driver.hover("source", 50, -5)
    middle = driver.place("source", 50, 30)
    driver.wait(lambda: _is_red(driver, middle))
    driver.hover("source", 20, 30)
    driver.wait(lambda: not _is_red(driver, middle))


def test_a_closing_edge_that_crosses_is_refused(driver: Driver) -> None:
    driver.click("source", (10, 10), (40, 60), (40, 10), (60, 10), (60, 60), (90, 10))
    driver.key(Qt.Key.Key_Return)
    assert driver.document.source is None
    assert driver.session.refusal is not None


def test_backspace_and_undo_take_vertices_back(driver: Driver) -> None:
    driver.click("source", *SQUARE)
    driver.key(Qt.Key.Key_Backspace)
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert isinstance(driver.session.tool, PolygonBegun)
    assert len(driver.session.tool.points) == 2


def test_escape_forgets_the_path(driver: Driver) -> None:
    driver.click("source", *SQUARE)
    driver.key(Qt.Key.Key_Escape)
    assert not driver.session.tool.busy
    driver.key(Qt.Key.Key_Return)
    assert driver.document.source is None


def test_choosing_the_drawing_tool_again_changes_nothing_in_a_drawing(driver: Driver) -> None:
    driver.click("source", *SQUARE)
    driver.key(Qt.Key.Key_D)
    assert isinstance(driver.session.tool, PolygonBegun)
    assert len(driver.session.tool.points) == 4


def test_choosing_another_tool_closes_a_drawing_where_that_is_possible(driver: Driver) -> None:
    driver.click("source", *SQUARE)
    driver.key(Qt.Key.Key_S)
    assert driver.corners("source") == [list(corner) for corner in SQUARE]
    assert driver.session.tool.name == "select"


def test_a_drawing_that_cannot_be_closed_keeps_its_tool_and_says_why(driver: Driver) -> None:
    driver.click("source", (10, 10), (40, 60), (40, 10), (60, 10), (60, 60), (90, 10))
    driver.key(Qt.Key.Key_S)
    assert isinstance(driver.session.tool, PolygonBegun)
    assert driver.session.refusal is not None
    assert driver.window.actions_table["draw"].isChecked()
    driver.key(Qt.Key.Key_A, CONTROL)
    assert isinstance(driver.session.tool, PolygonBegun)


def test_with_both_shapes_drawn_a_stray_click_begins_no_third(driver: Driver) -> None:
    driver.click("source", *TRIANGLE, TRIANGLE[0])
    driver.click("target", *SQUARE, SQUARE[0])
    assert driver.window.actions_table["select"].isChecked()
    driver.click("target", (50, 50))
    assert not driver.session.tool.busy


def test_drawing_is_undone_and_redone_as_a_whole(driver: Driver) -> None:
    driver.draw("source", TRIANGLE)
    drawn = driver.document
    driver.draw("source", SQUARE)
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert driver.document == drawn
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert driver.document.source is None
    driver.key(Qt.Key.Key_Y, CONTROL)
    assert driver.document == drawn


@pytest.mark.parametrize("tool", ["select", "mark"])
def test_an_empty_canvas_takes_every_event(driver: Driver, tool: str) -> None:
    driver.window.actions_table[tool].trigger()
    driver.click("source", (50, 50))
    driver.double_click("source", 50, 50)
    driver.drag("source", (10, 10), (60, 60))
    for key in (Qt.Key.Key_Return, Qt.Key.Key_Delete, Qt.Key.Key_Left, Qt.Key.Key_Escape):
        driver.key(key)
    assert driver.document.source is None


def _is_red(driver: Driver, place) -> bool:  # type: ignore[no-untyped-def]
    colour = driver.window.grab().toImage().pixelColor(place)
    return colour.red() > 150 and colour.green() < 80
