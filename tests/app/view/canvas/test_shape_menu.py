import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSlider, QSpinBox

from app.model.marks import Side
from app.view.canvas.clipboard import leave_clipboard
from tests.app.driver import CONTROL, LEFT, PLAIN, SHIFT, SQUARE, TRIANGLE, Driver

FLAG = ((10, 10), (90, 10), (90, 60), (50, 40), (10, 60))


def aside(driver: Driver, side: Side = "source") -> None:
    """Click beside the shape."""
    canvas = driver.window.canvases[side]
    corner = canvas.mapTo(driver.window, QPoint(25, canvas.height() - 15))
    QTest.mouseClick(driver.window.windowHandle(), LEFT, PLAIN, corner)


@pytest.fixture
def pair(driver: Driver) -> Driver:
    driver.draw("source", FLAG)
    driver.draw("target", SQUARE)
    aside(driver)
    return driver


def act(driver: Driver, name: str) -> None:
    driver.window.actions_table[name].trigger()


def test_the_whole_shape_is_mirrored_and_marks_stay_on_their_vertices(pair: Driver) -> None:
    pair.mark((10, 10), (10, 10))
    pair.mark((90, 60), (90, 90))
    aside(pair)
    act(pair, "mirror-across")
    ring = pair.document.vertices("source").round()
    ends = [ring[source].tolist() for source, _ in pair.document.marks]
    assert ends == [[90, 10], [10, 60]]
    assert pair.session.undoes == "Mirror"
    assert not pair.session.news


def test_marks_that_would_cross_when_mirrored_are_left_out_and_that_is_said(pair: Driver) -> None:
    for corner in SQUARE[:2]:
        pair.mark(corner, corner)
    pair.mark((90, 60), (90, 90))
    aside(pair)
    before = pair.window.canvases["source"].grab().toImage()
    act(pair, "mirror-across")
    assert len(pair.document.marks) == 2
    assert pair.session.news.lost == 1
    assert pair.window.canvases["source"].grab().toImage() != before
    pair.key(Qt.Key.Key_Z, CONTROL)
    assert len(pair.document.marks) == 3
    assert not pair.session.news


def test_a_part_that_would_cross_when_mirrored_is_refused(pair: Driver) -> None:
    pair.drag("source", (80, 0), (100, 70))
    before = pair.document
    pair.click("source", (50, 40), modifier=SHIFT)
    act(pair, "mirror-across")
    assert pair.document == before
    assert pair.session.refusal is not None


def test_simplify_leaves_out_vertices_but_marked_ones_and_follows_its_slider(pair: Driver) -> None:
    pair.mark((50, 40), (90, 90))
    aside(pair)
    act(pair, "refine")
    assert len(pair.document.vertices("source")) == 17
    act(pair, "simplify")
    assert len(pair.document.vertices("source")) == 5
    slider = pair.window.options.pages["simplify"].findChild(QSlider, "tolerance")
    assert slider is not None
    slider.setFocus()
    for _ in range(10):
        QTest.keyClick(slider, Qt.Key.Key_PageUp)
    corners = pair.document.vertices("source").round().tolist()
    assert [50, 40] in corners
    pair.key(Qt.Key.Key_Z, CONTROL)
    assert len(pair.document.vertices("source")) == 17


def test_refine_adds_vertices_evenly_and_follows_its_number(pair: Driver) -> None:
    act(pair, "refine")
    field = pair.window.options.pages["refine"].findChild(QSpinBox, "added")
    assert field is not None
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "40")
    QTest.keyClick(field, Qt.Key.Key_Return)
    ring = pair.document.vertices("source")
    assert len(ring) == 45
    lengths = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
    assert lengths.max() < 2 * lengths.min()
    assert pair.window.options.name.text() == "Refine"
    pair.key(Qt.Key.Key_Z, CONTROL)
    assert len(pair.document.vertices("source")) == 5
    assert pair.window.options.name.text() == "Select"  # what is undone cannot be adjusted


def test_the_first_vertex_is_set_and_marks_follow(pair: Driver) -> None:
    pair.mark((90, 60), (90, 90))
    pair.key(Qt.Key.Key_S)
    pair.click("source", (90, 60))
    act(pair, "set-first")
    assert pair.corners("source")[0] == [90, 60]
    assert pair.document.marks == ((0, 2),)
    assert pair.session.selection.vertices == {0}


def test_the_shape_is_copied_to_the_other_canvas_with_its_marks(pair: Driver) -> None:
    pair.mark((90, 60), (90, 90))
    aside(pair)
    act(pair, "copy-across")
    assert pair.corners("target") == pair.corners("source")
    assert pair.document.marks == ((2, 2),)


def test_source_and_target_are_exchanged(pair: Driver) -> None:
    pair.mark((90, 60), (90, 90))
    source, target = pair.corners("source"), pair.corners("target")
    act(pair, "exchange")
    assert (pair.corners("source"), pair.corners("target")) == (target, source)
    assert pair.session.undoes == "Reverse"
    act(pair, "exchange")
    assert (pair.corners("source"), pair.corners("target")) == (source, target)


def test_a_shape_is_copied_and_pasted_on_the_other_canvas(pair: Driver) -> None:
    pair.key(Qt.Key.Key_C, CONTROL)
    aside(pair, "target")
    pair.key(Qt.Key.Key_V, CONTROL)
    assert pair.document.vertices("target").tolist() == pair.document.vertices("source").tolist()
    assert pair.session.undoes == "Paste shape"


def test_a_shape_is_cut_and_pasted_within_its_canvas(pair: Driver) -> None:
    before = pair.document.vertices("source").tolist()
    pair.key(Qt.Key.Key_X, CONTROL)
    assert pair.document.source is None
    pair.key(Qt.Key.Key_V, CONTROL)
    assert pair.document.vertices("source").tolist() == before


def test_other_programs_get_svg_and_theirs_is_taken(pair: Driver) -> None:
    pair.key(Qt.Key.Key_C, CONTROL)
    assert "<svg" in QGuiApplication.clipboard().text()
    data = QMimeData()
    data.setData("image/svg+xml", b'<svg><g transform="scale(2)"><rect width="300" height="100"/></g></svg>')
    QGuiApplication.clipboard().setMimeData(data)
    pair.key(Qt.Key.Key_V, CONTROL)
    pair.wait(lambda: pair.session.undoes == "Paste shape")
    np.testing.assert_allclose(np.ptp(pair.document.vertices("source"), axis=0), (600, 200))
    canvas = pair.window.canvases["source"]
    screen = canvas.camera.to_screen(pair.document.vertices("source"))
    assert (screen >= 0).all()
    assert (screen <= (canvas.width(), canvas.height())).all()


def test_a_pasted_shape_too_small_to_see_is_shown_larger(pair: Driver) -> None:
    QGuiApplication.clipboard().setText('<svg><path d="M50 50h3v2h-3z"/></svg>')
    pair.key(Qt.Key.Key_V, CONTROL)
    pair.wait(lambda: pair.session.undoes == "Paste shape")
    canvas = pair.window.canvases["source"]
    assert np.ptp(pair.document.vertices("source"), axis=0).tolist() == [3.0, 2.0]
    assert 3 * canvas.camera.scale > canvas.width() / 2


@pytest.mark.parametrize("text", ["just words", "<svg><path d='M0 0 L9 9'/></svg>", "<svg"])
def test_what_is_no_shape_is_refused_in_words(pair: Driver, text: str) -> None:
    before = pair.document
    QGuiApplication.clipboard().setText(text)
    pair.key(Qt.Key.Key_V, CONTROL)
    pair.wait(lambda: pair.session.refusal is not None)
    assert pair.document == before


def test_deleted_marks_are_said(pair: Driver) -> None:
    pair.mark((90, 60), (90, 90))
    pair.key(Qt.Key.Key_S)
    pair.click("source", (90, 60))
    pair.key(Qt.Key.Key_Delete)
    assert pair.session.news.lost == 1
    aside(pair)
    assert not pair.session.news


@pytest.mark.parametrize(
    "name", ["mirror-across", "simplify", "refine", "set-first", "copy-across", "cut", "copy"]
)
def test_on_empty_canvases_nothing_happens(driver: Driver, name: str) -> None:
    before = driver.document
    act(driver, name)
    assert driver.document == before


def test_a_triangle_stays_a_triangle(driver: Driver) -> None:
    driver.draw("source", TRIANGLE)
    act(driver, "simplify")
    assert len(driver.document.vertices("source")) == 3


def test_what_was_copied_outlives_the_program_as_text(driver: Driver) -> None:
    """As data of Python it would be asked for when Python has ended, and crash."""
    driver.draw("source", SQUARE)
    driver.window.actions_table["copy"].trigger()
    leave_clipboard()
    data = QGuiApplication.clipboard().mimeData()
    assert data.formats() == ["text/plain"]
    assert data.text().startswith("<svg")
