import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QSlider, QSpinBox

from starskel.quality import ShapeReport
from tests.app.driver import CONTROL, SHIFT, SQUARE, Driver


def spin(driver: Driver, name: str, value: int) -> None:
    """Type a number into a field of the options bar."""
    field = driver.window.options.findChild(QSpinBox, name)
    assert field is not None
    field.selectAll()
    QTest.keyClicks(field, str(value))
    QTest.keyClick(field, Qt.Key.Key_Return)


def turns(ring: np.ndarray) -> np.ndarray:  # type: ignore[type-arg]
    way = np.roll(ring, -1, axis=0) - ring
    return np.hypot(*way.T)


def test_a_rectangle_is_dragged_from_corner_to_corner(driver: Driver) -> None:
    driver.key(Qt.Key.Key_R)
    driver.drag("source", (80, 60), (50, 40), (20, 10))
    assert driver.corners("source") == [[20, 10], [80, 10], [80, 60], [20, 60]]
    assert driver.session.undoes == "Draw rectangle"
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert driver.document.source is None


def test_a_figure_is_shown_while_it_is_dragged(driver: Driver) -> None:
    driver.key(Qt.Key.Key_R)
    driver.press("source", 20, 20)
    driver.hover("source", 70, 50)
    assert driver.session.overlay("source").figure is not None
    driver.key(Qt.Key.Key_Escape)
    driver.release("source", 70, 50)
    assert driver.document.source is None


def test_an_ellipse_has_as_many_vertices_as_are_set(driver: Driver) -> None:
    driver.key(Qt.Key.Key_E)
    spin(driver, "roundness", 20)
    driver.drag("target", (10, 20), (60, 60), (90, 80))
    ring = driver.document.vertices("target")
    assert len(ring) == 20
    np.testing.assert_allclose(np.ptp(ring, axis=0), (80, 60), atol=1)


def test_a_regular_polygon_has_as_many_corners_as_are_set(driver: Driver) -> None:
    driver.key(Qt.Key.Key_G)
    spin(driver, "corners", 7)
    driver.drag("source", (50, 50), (60, 70), (50, 85))
    ring = driver.document.vertices("source")
    assert len(ring) == 7
    np.testing.assert_allclose(turns(ring), turns(ring)[0])


def test_a_star_has_points_and_an_inner_radius_as_set(driver: Driver) -> None:
    driver.key(Qt.Key.Key_G, SHIFT)
    spin(driver, "points", 6)
    spin(driver, "inner", 30)
    driver.drag("source", (50, 50), (60, 70), (50, 90))
    radii = np.hypot(
        *(driver.document.vertices("source") - driver.document.vertices("source").mean(axis=0)).T
    )
    assert len(radii) == 12
    np.testing.assert_allclose(radii[1::2] / radii[::2], 0.3)


@pytest.mark.parametrize("key", [Qt.Key.Key_R, Qt.Key.Key_E, Qt.Key.Key_G, Qt.Key.Key_H])
def test_a_click_draws_nothing(driver: Driver, key: Qt.Key) -> None:
    driver.key(key)
    driver.click("source", (50, 50))
    assert driver.document.source is None
    assert not driver.session.tool.busy


def test_the_second_figure_is_selected_and_ready_to_be_moved(driver: Driver) -> None:
    driver.draw("source", SQUARE)
    driver.key(Qt.Key.Key_R)
    driver.drag("target", (20, 20), (60, 60))
    assert driver.session.tool.name == "select"
    assert driver.session.selection.vertices == {0, 1, 2, 3}


def sketch(driver: Driver) -> None:
    angles = np.linspace(0.1, 6.2, 60)
    radii = 30 + 1.5 * np.sin(9 * angles)
    places = np.stack([50 + radii * np.cos(angles), 50 + radii * np.sin(angles)], axis=1)
    driver.key(Qt.Key.Key_H)
    driver.drag("source", *((x, y) for x, y in places.tolist()))


def test_freehand_is_simplified_and_follows_the_tolerance_as_one_step(driver: Driver) -> None:
    sketch(driver)
    first = len(driver.document.vertices("source"))
    assert 5 <= first < 50
    slider = driver.window.options.pages["freehand"].findChild(QSlider, "tolerance")
    assert slider is not None
    assert slider.isVisible()
    slider.setFocus()
    for _ in range(5):
        QTest.keyClick(slider, Qt.Key.Key_PageUp)
    coarse = len(driver.document.vertices("source"))
    assert coarse < first
    assert driver.session.overlay("source").trail is not None
    for _ in range(10):
        QTest.keyClick(slider, Qt.Key.Key_PageDown)
    assert len(driver.document.vertices("source")) >= first
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert driver.document.source is None


def test_a_line_that_crosses_itself_is_refused_and_stays_to_be_seen(driver: Driver) -> None:
    driver.key(Qt.Key.Key_H)
    driver.drag("source", (10, 10), (50, 50), (90, 90), (90, 50), (90, 10), (50, 52), (10, 90))
    assert driver.document.source is None
    refusal = driver.session.refusal
    assert refusal is not None
    assert len(refusal.segments) == 2
    assert driver.session.overlay("source").trail is not None
    driver.key(Qt.Key.Key_Escape)
    assert driver.session.overlay("source").trail is None


def type_text(driver: Driver, text: str) -> None:
    driver.key(Qt.Key.Key_T)
    field = driver.window.options.findChild(QLineEdit, "text")
    assert field is not None
    field.selectAll()
    QTest.keyClicks(field, text)


def test_a_letter_is_set_in_outlines(driver: Driver) -> None:
    type_text(driver, "L")
    driver.hover("source", 40, 40)
    driver.hover("source", 50, 50)
    assert driver.session.overlay("source").figure is not None
    driver.click("source", (50, 50))
    ring = driver.document.vertices("source")
    assert len(ring) == 6
    np.testing.assert_allclose((ring.min(axis=0) + ring.max(axis=0)) / 2, (50, 50), atol=1)
    assert driver.session.undoes == "Set text"


def test_all_outlines_of_a_text_are_shown_before_they_are_set(driver: Driver) -> None:
    type_text(driver, "i")
    driver.hover("source", 40, 40)
    driver.hover("source", 50, 50)
    overlay = driver.session.overlay("source")
    assert len(overlay.beside) == 1
    assert overlay.figure is not None
    assert np.ptp(overlay.figure, axis=0).max() > np.ptp(overlay.beside[0], axis=0).max()


def test_a_text_without_outlines_sets_nothing(driver: Driver) -> None:
    type_text(driver, " ")
    driver.click("source", (50, 50))
    assert driver.document.source is None


def test_holes_in_letters_are_parts_of_the_shape(driver: Driver) -> None:
    for side, text, outer in (("source", "A", (-1, 0)), ("target", "R", (-1, 0))):
        type_text(driver, text)
        driver.click(side, (50, 50))
        assert driver.document.shape(side).shape.outer == outer
    assert [link.ends for link in driver.document.way.links] == [(0, 0), (1, 1)]
    driver.wait_for_blends()
    for state in driver.session.blends.results.values():
        assert state.result is not None
        assert isinstance(state.result.report, ShapeReport)
        assert state.result.report.holes_inside
    type_text(driver, "i")
    driver.click("target", (50, 50))
    assert {link.ends for link in driver.document.way.links} == {(0, 0), (1, None), (None, 1)}
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert len(driver.document.way.links) == 2


def test_islands_in_letters_are_filled(driver: Driver) -> None:
    type_text(driver, "\N{REGISTERED SIGN}")
    driver.click("source", (50, 50))
    assert driver.document.shape("source").shape.outer == (-1, 0, -1, 2)
