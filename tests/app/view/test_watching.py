import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QDoubleSpinBox, QLabel
from pytestqt.qtbot import QtBot

from app.playback import Repeat
from app.session import USUAL_METHODS, Session
from app.view.main_window import MainWindow
from app.view.panels.panels import columns_for
from app.view.wording.fitting_label import FittingLabel
from starskel.files.projects.examples import example
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.project import Project
from starskel.files.projects.step import Step
from starskel.polygon import Polygon
from tests.app.driver import CONTROL, LEFT, PLAIN, TRIANGLE, Driver


@pytest.fixture
def arm(driver: Driver) -> Driver:
    driver.session.show_project(example("arm"))
    driver.wait_for_blends()
    return driver


def verdict(driver: Driver, method: str) -> str:
    label = driver.window.findChild(QLabel, f"{method}-verdict")
    assert label is not None
    return label.text()


def test_drawing_two_shapes_is_enough_for_all_blends(driver: Driver) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    assert [result.method for result in driver.session.blends.fresh] == list(USUAL_METHODS)


def test_each_method_gets_a_verdict(arm: Driver) -> None:
    for method in USUAL_METHODS:
        assert verdict(arm, method)
    assert verdict(arm, "stitched").startswith("✓ simple")
    assert verdict(arm, "vertex").startswith("✕ crosses at t = .")


def test_a_narrow_panel_gets_a_short_verdict(arm: Driver) -> None:
    label = arm.window.findChild(FittingLabel, "vertex-verdict")
    assert label is not None
    texts = []
    for width in (400, 140, 70):
        label.resize(width, label.height())
        texts.append(label.text().replace(".39", "…"))
        assert label.sizeHint().width() <= width
    assert texts == ["✕ crosses at t = …, area 57 %", "✕ crosses at t = …", "✕ crosses"]


def test_undoing_everything_stops_what_is_playing(driver: Driver) -> None:
    driver.draw_both()
    driver.key(Qt.Key.Key_P)
    driver.wait(lambda: driver.window.player.t > 0.02)
    for _ in range(2):
        assert driver.window.actions_table["play"].isEnabled()
        driver.key(Qt.Key.Key_Z, CONTROL)
        assert (driver.window.player.playing, driver.window.player.t) == (False, 0)
        driver.key(Qt.Key.Key_Y, CONTROL)
        driver.key(Qt.Key.Key_P)
        assert driver.window.player.playing
    driver.key(Qt.Key.Key_Z, CONTROL)
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert not driver.window.player.playing
    assert not driver.window.actions_table["play"].isEnabled()


def test_play_moves_t_and_pause_holds_it(arm: Driver) -> None:
    arm.key(Qt.Key.Key_P)
    assert arm.window.player.playing
    arm.wait(lambda: arm.window.player.t > 0.02)
    arm.key(Qt.Key.Key_P)
    held = arm.window.player.t
    QTest.qWait(50)
    assert arm.window.player.t == held
    field = arm.window.findChild(QDoubleSpinBox, "t")
    assert field is not None
    assert field.value() == pytest.approx(held, abs=0.006)


def test_playing_computes_nothing(arm: Driver) -> None:
    results = dict(arm.session.blends.results)
    arm.key(Qt.Key.Key_P)
    QTest.qWait(100)
    arm.key(Qt.Key.Key_P)
    assert arm.session.blends.results == results
    assert not arm.session.blends.busy


def test_a_click_on_the_slider_and_on_the_chart_goes_there(arm: Driver) -> None:
    for widget in (arm.window.timeline.slider, arm.window.timeline.chart):
        for share in (0.25, 0.75):
            x = widget.inset + share * (widget.width() - 2 * widget.inset)
            QTest.mouseClick(widget, LEFT, PLAIN, QPoint(round(x), widget.height() // 2))
            assert arm.window.player.t == pytest.approx(share, abs=0.005)


def test_the_chart_shows_the_newest_blends(arm: Driver) -> None:
    chart = arm.window.timeline.chart
    arm.window.player.seek(0.5)
    before = chart.grab().toImage()
    arm.session.show_project(example("ribbon"))
    arm.wait_for_blends()
    assert chart.grab().toImage() != before


def test_chart_and_slider_have_one_scale(arm: Driver) -> None:
    slider, chart = arm.window.timeline.slider, arm.window.timeline.chart
    assert slider.width() == chart.width()
    assert slider.mapTo(arm.window, QPoint()).x() == chart.mapTo(arm.window, QPoint()).x()
    assert slider.inset == chart.inset


def test_home_and_end_go_to_the_shapes(arm: Driver) -> None:
    arm.key(Qt.Key.Key_End)
    assert arm.window.player.t == 1
    arm.key(Qt.Key.Key_Home)
    assert arm.window.player.t == 0


def test_repeat_and_speed_are_chosen_by_keys(arm: Driver) -> None:
    repeat, speed = (arm.window.findChild(QComboBox, name) for name in ("repeat", "speed"))
    assert repeat is not None
    assert speed is not None
    QTest.keyClick(repeat, Qt.Key.Key_Down)
    assert arm.window.player.repeat is Repeat.LOOP
    QTest.keyClick(speed, Qt.Key.Key_Down)
    assert arm.window.player.speed == 2


@pytest.mark.parametrize(
    "switches", [("pieces",), ("skeleton",), ("pieces", "skeleton"), ("onion",), ("ways",), ("numbers",)]
)
def test_pieces_and_skeleton_change_what_is_painted(arm: Driver, switches: tuple[str, ...]) -> None:
    arm.window.player.seek(0.4)
    view = arm.window.panels.panel("stitched").view
    plain = view.grab().toImage()
    for name in switches:
        arm.window.actions_table[name].trigger()
    assert view.grab().toImage() != plain
    for name in switches:
        arm.window.actions_table[name].trigger()
    assert view.grab().toImage() == plain


@pytest.mark.parametrize("switch", ["pieces", "skeleton", "numbers"])
def test_the_canvases_show_it_too(arm: Driver, switch: str) -> None:
    canvas = arm.window.canvases["target"]
    plain = canvas.grab().toImage()
    arm.window.actions_table[switch].trigger()
    assert canvas.grab().toImage() != plain


def test_the_wheel_zooms_all_panels_and_a_double_click_shows_everything(arm: Driver) -> None:
    views = [arm.window.panels.panel(method).view for method in ("stitched", "vertex")]
    fitted = [view.camera for view in views]
    place = QPointF(30, 40)
    turn = QWheelEvent(
        *(place, QPointF(views[0].mapToGlobal(place.toPoint())), QPoint(), QPoint(0, 120)),
        *(Qt.MouseButton.NoButton, PLAIN, Qt.ScrollPhase.NoScrollPhase, False),
    )
    QApplication.sendEvent(views[0], turn)
    for view, camera in zip(views, fitted, strict=True):
        assert view.camera.scale == pytest.approx(1.25 * camera.scale)
    assert views[0].camera.centre == views[1].camera.centre
    QTest.mousePress(views[1], LEFT, PLAIN, QPoint(50, 50))
    QTest.mouseMove(views[1], QPoint(70, 50))
    QTest.mouseRelease(views[1], LEFT, PLAIN, QPoint(70, 50))
    assert views[0].camera.centre[0] == pytest.approx(views[1].camera.centre[0])
    QTest.mouseDClick(views[0], LEFT, PLAIN, QPoint(50, 50))
    assert [view.camera for view in views] == fitted


def test_methods_are_chosen_from_the_menu_and_the_choice_is_undone(arm: Driver) -> None:
    (menu,) = (
        m
        for m in arm.window.findChildren(type(arm.window.menuBar().actions()[0].menu()))
        if "Methods" in m.title()
    )
    vertex = next(action for action in menu.actions() if action.data() == "vertex")
    vertex.trigger()
    assert "vertex" not in arm.document.methods
    assert len(arm.session.blends.fresh) == len(USUAL_METHODS) - 1
    arm.session.undo()
    arm.wait_for_blends()
    assert len(arm.session.blends.fresh) == len(USUAL_METHODS)


def test_an_edit_leaves_the_last_blend_on_screen_marked_out_of_date(arm: Driver) -> None:
    before = arm.session.blends.results["stitched"].result
    x, y = arm.document.vertices("source")[0].tolist()
    arm.key(Qt.Key.Key_S)
    arm.drag("source", (x, y), (x - 3, y - 3))
    assert arm.session.blends.results["stitched"].result is before
    assert "out of date" in verdict(arm, "stitched")
    arm.wait_for_blends()
    assert arm.session.blends.results["stitched"].result is not before
    assert "out of date" not in verdict(arm, "stitched")


def test_frames_follow_a_vertex_while_it_is_dragged(arm: Driver) -> None:
    before = arm.session.blends.results["stitched"].result
    x, y = arm.document.vertices("source")[0].tolist()
    arm.key(Qt.Key.Key_S)
    arm.press("source", x, y)
    arm.hover("source", x - 2, y - 2)
    arm.hover("source", x - 3, y - 3)
    shown = arm.session.blends.results["stitched"]
    assert shown.result is not None
    assert shown.stale or shown.result is not before  # a quick worker may have been there already
    arm.wait_for_blends()
    held = arm.session.blends.results["stitched"].result
    assert held is not None
    assert np.abs(held.blend.at(0)[0] - (x - 3, y - 3)).max() < 1
    assert arm.corners("source")[0] == [round(x), round(y)]
    arm.key(Qt.Key.Key_Escape)
    assert arm.session.blends.results["stitched"].result is before
    assert not arm.session.blends.busy
    arm.release("source", x - 3, y - 3)


def test_undo_shows_the_former_blends_at_once(arm: Driver) -> None:
    before = arm.session.blends.results["stitched"].result
    x, y = arm.document.vertices("source")[0].tolist()
    arm.key(Qt.Key.Key_S)
    arm.drag("source", (x, y), (x - 2, y), (x - 3, y - 3))
    arm.wait_for_blends()
    arm.session.undo()
    assert not arm.session.blends.busy
    assert arm.session.blends.results["stitched"].result is before
    assert not arm.session.blends.results["stitched"].stale


def test_escape_cancels_the_computation_and_f5_takes_it_up_again(arm: Driver) -> None:
    arm.session.blends.recompute()
    assert arm.session.blends.busy
    arm.key(Qt.Key.Key_Escape)
    assert not arm.session.blends.busy
    QTest.qWait(100)
    assert arm.session.blends.results["stitched"].stale
    arm.key(Qt.Key.Key_F5)
    arm.wait_for_blends()
    assert not arm.session.blends.results["stitched"].stale


@pytest.mark.parametrize(
    ("width", "height", "extent", "columns"),
    [
        (1280, 270, (1, 2), 5),  # tall shapes stand in a row
        (1280, 600, (4, 1), 2),  # wide ones lie over one another
        (700, 500, (1, 1), 3),  # no narrower than a verdict
        (150, 500, (1, 1), 2),
    ],
)
def test_panels_are_laid_out_so_that_frames_are_largest(
    width: int, height: int, extent: tuple[int, int], columns: int
) -> None:
    assert columns_for(5, width, height, np.array([(0, 0), extent], dtype=float)) == columns


def test_the_grid_follows_the_shapes(arm: Driver) -> None:
    shown = []
    for source, width in ((TRIANGLE, 1.0), (TRIANGLE, 30.0)):
        shape = Polygon(np.array(source) * (width, 1.0))
        arm.session.show_project(Project("", (KeyShape.of(shape),) * 2, (Step.of(),)))
        arm.wait_for_blends()
        QApplication.processEvents()
        panels = [arm.window.panels.panel(method) for method in arm.document.methods]
        shown.append(len({panel.x() for panel in panels}))
        assert all(panel.isVisible() for panel in panels)
    assert shown[0] > shown[1]


def test_the_skeleton_of_a_single_piece_is_its_origin(driver: Driver) -> None:
    driver.draw_both()
    driver.wait_for_blends()
    view = driver.window.panels.panel("stitched").view
    without = view.grab().toImage()
    driver.window.actions_table["skeleton"].trigger()
    assert driver.window.display.layers.skeleton
    assert view.grab().toImage() != without


def test_a_cancelled_computation_says_how_to_go_on(arm: Driver) -> None:
    arm.session.show_project(example("ribbon"))
    arm.key(Qt.Key.Key_Escape)
    messages = [arm.window.panels.panel(method).view.message for method in USUAL_METHODS]
    assert all("F5" in message for message in messages)
    arm.key(Qt.Key.Key_F5)
    arm.wait_for_blends()
    assert all(arm.window.panels.panel(method).view.message == "" for method in USUAL_METHODS)


def test_a_panel_whose_method_is_no_longer_compared_is_not_painted_again(arm: Driver) -> None:
    """It follows no more, so what it would paint belongs to another document."""
    former = arm.window.panels.panel("vertex")
    arm.session.store(arm.document.compare(("stitched",)), "Choose methods")
    assert not former.isVisible()


@pytest.mark.parametrize("size", [(1008, 652), (800, 620)], ids=["a small screen", "smaller"])
def test_a_window_on_a_small_screen_is_no_larger_than_it_was_told(
    qtbot: QtBot, size: tuple[int, int]
) -> None:
    small = MainWindow(Session())
    small.resize(*size)
    small.show()
    qtbot.waitExposed(small)
    small.actions_table["begin"].trigger()
    QApplication.processEvents()
    found = small.size().toTuple(), small.statusBar().geometry().bottom()
    small.close()
    small.deleteLater()
    assert found[0] == size
    assert found[1] < size[1]
