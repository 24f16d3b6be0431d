"""More than two key shapes: the strip, its keys and buttons, and playing through all of them."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDoubleSpinBox

from app.view.sequence.key_strip import KeyStrip
from app.view.sequence.strip_layout import StripLayout
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import read_project
from starskel.files.projects.step import Step
from starskel.polygon import Polygon
from tests.app.driver import CONTROL, LEFT, PLAIN, SHIFT, SQUARE, TRIANGLE, Driver

SHAPES = tuple(Polygon([(10, 10), (90, 10), (90, 90 - 10 * k), (10, 90)]) for k in range(4))
MARKS = tuple((k, k) for k in range(4))


@pytest.fixture
def film(driver: Driver) -> Driver:
    steps = tuple(
        replace(Step.of(marks), duration=duration)
        for marks, duration in ((MARKS, 0.2), (MARKS[:3], 0.1), (MARKS[:2], 0.2))
    )
    driver.session.show_project(
        Project("film", tuple(map(KeyShape.of, SHAPES)), steps, ("vertex", "edge-angle"))
    )
    driver.wait_for_blends()
    return driver


def strip(driver: Driver) -> KeyStrip:
    return driver.window.sequence.strip


def click(driver: Driver, place: QPointF) -> None:
    QTest.mouseClick(strip(driver), LEFT, PLAIN, place.toPoint())


def drag(driver: Driver, shape: int, slot: int) -> None:
    places = strip(driver).places
    start, stop = places.tile(shape).center().toPoint(), QPoint(round(places.slot(slot)), 30)
    QTest.mousePress(strip(driver), LEFT, PLAIN, start)
    QTest.mouseMove(strip(driver), (start + stop) / 2)
    QTest.mouseMove(strip(driver), stop)
    QTest.mouseRelease(strip(driver), LEFT, PLAIN, stop)


def order(driver: Driver) -> list[int]:
    """The shapes by the numbers that they had at first; an empty one is -1."""
    shapes = driver.document.sequence.shapes
    return [SHAPES.index(shape.rings[0]) if shape.parts else -1 for shape in shapes]


def test_a_shape_still_being_drawn_is_closed_before_it_is_duplicated(driver: Driver) -> None:
    driver.draw("source", TRIANGLE)
    driver.click("target", *SQUARE)
    driver.key(Qt.Key.Key_D, CONTROL | SHIFT)
    sizes = [sum(map(len, shape.rings)) for shape in driver.document.sequence.shapes]
    assert sizes == [3, 4, 4]


def test_two_shapes_look_as_simple_as_ever(driver: Driver) -> None:
    driver.draw_both()
    assert not driver.window.sequence.isVisible()
    driver.key(Qt.Key.Key_N, CONTROL | SHIFT)
    assert driver.window.sequence.isVisible()
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert not driver.window.sequence.isVisible()


def test_a_third_shape_is_added_drawn_and_blended(driver: Driver) -> None:
    driver.draw_both()
    driver.key(Qt.Key.Key_N, CONTROL | SHIFT)
    assert (driver.document.step, driver.document.target) == (1, None)
    assert driver.session.tool.name == "draw"
    driver.click("target", *TRIANGLE)
    driver.key(Qt.Key.Key_Return)
    driver.wait_for_blends()
    assert len(driver.document.sequence.steps) == 2
    for step in (0, 1):
        states = driver.session.blends.steps[step].values()
        assert all(state.result is not None and not state.stale for state in states)


def test_a_click_on_a_step_or_on_a_shape_shows_it(film: Driver) -> None:
    places = strip(film).places
    click(film, places.step(2).center())
    assert film.document.step == 2
    assert film.document.source == SHAPES[2]
    click(film, places.tile(0).center())
    assert (film.document.step, film.session.selection.side) == (0, "source")
    click(film, places.tile(1).center())
    assert (film.document.step, film.session.selection.side) == (0, "target")
    click(film, places.tile(3).center())
    assert (film.document.step, film.session.selection.side) == (2, "target")
    assert not film.session.unsaved
    assert film.session.undoes is None


def test_the_place_behind_the_last_shape_adds_one(film: Driver) -> None:
    click(film, strip(film).places.addition.center())
    assert order(film) == [0, 1, 2, 3, -1]
    assert film.document.step == 3


@pytest.mark.parametrize(
    ("shape", "slot", "expected"),
    [
        (0, 2, [1, 0, 2, 3]),
        (3, 0, [3, 0, 1, 2]),
        (1, 4, [0, 2, 3, 1]),
        (1, 2, [0, 1, 2, 3]),
        (1, 1, [0, 1, 2, 3]),
    ],
)
def test_a_shape_is_dragged_to_another_place_in_one_step(
    film: Driver, shape: int, slot: int, expected: list[int]
) -> None:
    drag(film, shape, slot)
    assert order(film) == expected
    moved = expected != [0, 1, 2, 3]
    assert film.session.undoes == ("Move key shape" if moved else None)
    if moved:
        assert SHAPES[shape] in (film.document.source, film.document.target)
        film.key(Qt.Key.Key_Z, CONTROL)
        assert order(film) == [0, 1, 2, 3]


def test_escape_gives_a_drag_up(film: Driver) -> None:
    places = strip(film).places
    strip(film).setFocus()
    QTest.mousePress(strip(film), LEFT, PLAIN, places.tile(0).center().toPoint())
    QTest.mouseMove(strip(film), places.tile(3).center().toPoint())
    QTest.keyClick(strip(film), Qt.Key.Key_Escape)
    QTest.mouseRelease(strip(film), LEFT, PLAIN, places.tile(3).center().toPoint())
    assert order(film) == [0, 1, 2, 3]


def test_keys_in_the_strip_go_move_and_delete(film: Driver) -> None:
    strip(film).setFocus()
    QTest.keyClick(strip(film), Qt.Key.Key_Right)
    assert film.document.step == 1
    QTest.keyClick(strip(film), Qt.Key.Key_Right, CONTROL)
    assert order(film) == [0, 2, 1, 3]
    QTest.keyClick(strip(film), Qt.Key.Key_Delete)
    assert order(film) == [0, 2, 3]
    QTest.keyClick(strip(film), Qt.Key.Key_Left)
    assert film.document.step == 0


def test_commands_duplicate_move_and_delete_the_shape_worked_on(film: Driver) -> None:
    film.key(Qt.Key.Key_PageDown)
    assert film.document.step == 1
    film.key(Qt.Key.Key_D, CONTROL | SHIFT)
    assert order(film) == [0, 1, 1, 2, 3]
    assert set(film.document.marks) == set(MARKS)
    film.key(Qt.Key.Key_Backspace, CONTROL | SHIFT)
    assert order(film) == [0, 1, 2, 3]
    actions = film.window.actions_table
    click(film, strip(film).places.tile(0).center())
    assert not actions["shape-earlier"].isEnabled()
    actions["shape-later"].trigger()
    assert order(film) == [1, 0, 2, 3]


def test_marks_that_cannot_be_kept_are_told(film: Driver) -> None:
    film.window.actions_table["shape-add"].trigger()
    assert film.session.news.lost > 0


def test_an_edit_of_a_step_computes_only_the_steps_that_it_touches(film: Driver) -> None:
    untouched = film.session.blends.steps[2]["vertex"].result
    film.key(Qt.Key.Key_S)
    film.drag("source", (90, 90), (80, 80))
    film.wait_for_blends()
    assert film.session.blends.steps[2]["vertex"].result is untouched


def test_undo_goes_to_the_step_where_the_edit_was(film: Driver) -> None:
    film.key(Qt.Key.Key_S)
    film.drag("source", (90, 90), (80, 80))
    click(film, strip(film).places.step(2).center())
    film.key(Qt.Key.Key_Z, CONTROL)
    assert film.document.step == 0
    assert order(film) == [0, 1, 2, 3]


def test_the_duration_of_a_step_is_typed(film: Driver) -> None:
    field = film.window.findChild(QDoubleSpinBox, "duration")
    assert field is not None
    field.selectAll()
    QTest.keyClicks(field, "6")
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert film.document.sequence.durations == (2.0, 0.1, 0.2)
    film.session.undo()
    assert field.value() == pytest.approx(0.6)


def test_playing_runs_through_all_shapes_and_computes_nothing(film: Driver) -> None:
    seen: list[int] = []
    film.session.step_changed.connect(lambda: seen.append(film.document.step))
    film.key(Qt.Key.Key_P)
    film.wait(lambda: 2 in seen)
    assert seen[:2] == [1, 2]
    film.wait(lambda: 0 in seen)  # and back again
    assert not film.session.blends.busy
    assert film.session.undoes is None
    film.window.player.pause()
    assert film.window.player.step == film.document.step


def test_a_new_document_ends_playing_in_whatever_step_it_is(film: Driver) -> None:
    film.window.player.play()
    film.wait(lambda: film.document.step == 2)
    film.session.new()
    assert (film.document.step, film.window.player.step, film.window.player.playing) == (0, 0, False)


def test_one_step_can_be_played_alone(film: Driver) -> None:
    film.key(Qt.Key.Key_P, CONTROL)
    seen: list[int] = []
    film.session.step_changed.connect(lambda: seen.append(film.document.step))
    film.window.player.set_speed(4)
    film.key(Qt.Key.Key_P)
    QTest.qWait(500)  # three times as long as the step
    assert not seen
    film.key(Qt.Key.Key_P, CONTROL)
    film.wait(lambda: bool(seen))


def test_a_gesture_under_way_keeps_its_step_on_the_canvases(film: Driver) -> None:
    film.key(Qt.Key.Key_S)
    film.window.player.play()
    film.press("source", 90, 90)
    film.hover("source", 80, 80)
    QTest.qWait(900)  # longer than the step
    assert film.document.step == 0
    film.release("source", 80, 80)
    assert film.session.undoes == "Move vertices"


def test_going_frame_by_frame_leads_into_the_next_step(film: Driver) -> None:
    film.key(Qt.Key.Key_End)
    film.window.actions_table["step-forward"].trigger()
    assert film.document.step == 1
    assert film.window.player.t == pytest.approx(0.01)


def test_the_whole_sequence_is_saved(film: Driver, tmp_path) -> None:  # type: ignore[no-untyped-def]
    film.key(Qt.Key.Key_D, CONTROL | SHIFT)
    film.save(tmp_path / "film.json")
    assert not film.session.unsaved
    click(film, strip(film).places.step(0).center())
    assert not film.session.unsaved
    saved = read_project(tmp_path / "film.json")
    assert saved.shapes == film.document.sequence.shapes
    film.open(tmp_path / "film.json")
    assert film.document.showing(0) == replace(film.document, name="film")


def test_canvases_are_called_by_the_letters_of_their_shapes(film: Driver) -> None:
    before = film.window.canvases["source"].grab().toImage()
    film.window.actions_table["step-after"].trigger()
    assert film.window.canvases["source"].grab().toImage() != before


def test_a_drawing_is_finished_before_another_step_is_shown(film: Driver) -> None:
    film.key(Qt.Key.Key_D)
    film.click("source", *SQUARE)
    film.key(Qt.Key.Key_PageDown)
    assert film.document.step == 1
    film.key(Qt.Key.Key_PageUp)
    assert film.corners("source") == [list(corner) for corner in SQUARE]


def test_tiles_steps_and_slots_lie_side_by_side() -> None:
    places = StripLayout(3)
    for shape in range(3):
        assert places.tile_at(places.tile(shape).center()) == shape
        assert places.step_at(places.tile(shape).center()) is None
    assert [places.step_at(places.step(step).center()) for step in range(2)] == [0, 1]
    assert [places.slot_at(places.slot(slot)) for slot in range(4)] == [0, 1, 2, 3]
    assert places.size.width() > places.addition.right()
