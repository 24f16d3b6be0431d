import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from app.view.wording import words
from starskel.errors import InvalidMarks
from starskel.files.projects.examples import example
from tests.app.driver import CONTROL, Driver


@pytest.fixture
def squares(driver: Driver) -> Driver:
    driver.draw_both()
    return driver


def test_two_clicks_set_a_mark_and_undo_removes_it(squares: Driver) -> None:
    squares.mark((90, 10), (90, 10))
    squares.mark((90, 90), (90, 90))
    assert squares.document.marks == ((1, 1), (2, 2))
    squares.key(Qt.Key.Key_Z, CONTROL)
    assert squares.document.marks == ((1, 1),)
    assert squares.session.redoes == "Set mark"


def test_an_impossible_mark_is_refused_with_the_reason_and_both_pins(squares: Driver) -> None:
    squares.mark((10, 10), (10, 10))
    squares.mark((90, 10), (90, 90))
    squares.mark((90, 90), (90, 10))
    assert squares.document.marks == ((0, 0), (1, 2))
    refusal = squares.session.refusal
    assert refusal is not None
    assert isinstance(refusal.error, InvalidMarks)
    assert len(set(refusal.marks)) == 2
    assert (2, 1) in refusal.marks
    reason = words.reason(refusal.error, squares.document)
    assert "new mark 3 c" in reason
    squares.wait(lambda: _shows_red(squares, 90, 90) and _shows_red(squares, 90, 10, "target"))


def test_a_click_on_a_pin_removes_it_and_a_drag_moves_it(squares: Driver) -> None:
    squares.mark((10, 10), (10, 10))
    squares.mark((90, 10), (90, 10))
    squares.drag("target", (90, 10), (50, 50), (90, 90))
    assert squares.document.marks == ((0, 0), (1, 2))
    squares.click("source", (10, 10))
    assert squares.document.marks == ((1, 2),)


def test_a_drag_from_canvas_to_canvas_sets_a_mark(squares: Driver) -> None:
    squares.key(Qt.Key.Key_M)
    squares.press("target", 90, 90)
    squares.hover("target", 50, 50)
    squares.hover("source", 50, 50)
    squares.hover("source", 90, 90)
    assert squares.session.overlay("source").vertex == 2
    assert squares.window.mark_line.isVisible()
    squares.release("source", 90, 90)
    assert squares.document.marks == ((2, 2),)
    assert not squares.window.mark_line.isVisible()


def test_a_pin_that_may_not_move_is_called_by_its_own_number(squares: Driver) -> None:
    for corner in ((10, 10), (90, 10), (90, 90)):
        squares.mark(corner, corner)
    squares.press("source", 90, 10)
    squares.hover("source", 50, 50)
    squares.hover("source", 10, 90)
    refusal = squares.session.refusal
    assert refusal is not None
    assert words.reason(refusal.error, squares.document).startswith(
        "Mark 2 b, moved there, would cross mark "
    )
    squares.release("source", 10, 90)


def test_suggested_marks_are_one_step(driver: Driver) -> None:
    driver.session.show_project(example("arm"))
    driver.wait_for_blends()
    before = driver.document.marks
    driver.window.marks.count.setValue(5)
    driver.key(Qt.Key.Key_M, CONTROL)
    driver.wait(lambda: driver.document.marks != before)
    assert 2 <= len(driver.document.marks) <= 5
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert driver.document.marks == before


def test_suggested_marks_that_come_late_wait_for_the_end_of_a_drawing(driver: Driver) -> None:
    driver.session.show_project(example("arm"))
    driver.wait_for_blends()
    before = driver.document.marks
    driver.key(Qt.Key.Key_D)
    driver.session.suggest_marks(5)
    driver.click("target", (20, 20), (80, 20), (70, 40))
    driver.wait_for_blends()
    assert driver.document.marks == before
    assert driver.session.tool.busy
    assert not any(state.stale for state in driver.session.blends.results.values())
    driver.key(Qt.Key.Key_Return)
    driver.wait(lambda: driver.session.undoes == "Suggest marks")
    assert len(driver.document.vertices("target")) == 3
    assert 2 <= len(driver.document.marks) <= 3


@pytest.mark.parametrize("given_up", [False, True])
def test_marks_suggested_before_a_drag_are_those_of_the_shape_after_it(
    squares: Driver, given_up: bool
) -> None:
    squares.key(Qt.Key.Key_S)
    squares.session.suggest_marks(4)
    squares.press("source", 90, 90)
    squares.hover("source", 80, 70)
    squares.hover("source", 70, 60)
    if given_up:
        squares.key(Qt.Key.Key_Escape)
    squares.release("source", 70, 60)
    squares.wait_for_blends()
    assert squares.session.undoes == "Suggest marks"
    assert squares.corners("source")[2] == ([90, 90] if given_up else [70, 60])


def test_of_two_wishes_for_marks_the_newer_is_granted(squares: Driver) -> None:
    squares.session.suggest_marks(4)
    squares.session.suggest_marks(2)
    squares.wait_for_blends()
    assert len(squares.document.marks) == 2
    squares.key(Qt.Key.Key_Z, CONTROL)
    squares.wait_for_blends()
    assert squares.document.marks == ()


def test_a_wish_for_marks_can_be_given_up(squares: Driver) -> None:
    squares.session.suggest_marks(4)
    squares.session.cancel()
    squares.key(Qt.Key.Key_S)
    squares.drag("source", (90, 90), (80, 70), (70, 60))
    squares.wait_for_blends()
    assert squares.document.marks == ()


def test_a_vertex_hovered_over_shows_its_partner_and_its_way(squares: Driver) -> None:
    squares.mark((10, 10), (90, 10))
    squares.wait_for_blends()
    squares.key(Qt.Key.Key_S)
    squares.hover("source", 50, 50)
    target, panel = squares.window.canvases["target"], squares.window.panels.panel("stitched").view
    plain = target.grab().toImage(), panel.grab().toImage()
    squares.hover("source", 10, 90)
    matched = squares.session.matched_vertex
    assert matched is not None
    assert (matched.source_vertex, matched.target_vertex) == (3, 0)
    assert target.grab().toImage() != plain[0]
    assert panel.grab().toImage() != plain[1]
    squares.hover("source", 50, 50)
    assert (target.grab().toImage(), panel.grab().toImage()) == plain


def test_escape_gives_a_begun_mark_up(squares: Driver) -> None:
    squares.key(Qt.Key.Key_M)
    squares.click("source", (10, 10))
    squares.key(Qt.Key.Key_Escape)
    squares.click("target", (10, 10))
    assert squares.document.marks == ()


def test_inserting_a_vertex_keeps_marks_on_their_vertices(squares: Driver) -> None:
    squares.mark((90, 90), (90, 90))
    squares.key(Qt.Key.Key_S)
    squares.double_click("source", 50, 10)
    assert squares.document.marks == ((3, 2),)
    assert squares.corners("source")[3] == [90, 90]


def test_labels_count_in_numbers_and_letters() -> None:
    assert [words.mark(index) for index in (0, 25, 26, 27, 701)] == [
        "1 a",
        "26 z",
        "27 aa",
        "28 ab",
        "702 zz",
    ]


def _shows_red(driver: Driver, x: float, y: float, side: str = "source") -> bool:
    """Look for the red ring round a vertex."""
    QApplication.processEvents()
    image = driver.window.grab().toImage()
    middle = driver.place(side, x, y)  # type: ignore[arg-type]
    colours = [image.pixelColor(middle.x() + dx, middle.y()) for dx in (-12, -11, -10, 10, 11, 12)]
    return any(colour.red() > 150 and colour.green() < 60 and colour.blue() < 80 for colour in colours)
