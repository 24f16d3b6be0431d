import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.model.easing import PRESETS
from app.view.timeline.easing_button import EasingButton
from starskel.easing import EVEN, Easing
from tests.app.driver import CONTROL, LEFT, PLAIN, SHIFT, Driver


@pytest.fixture
def button(driver: Driver) -> EasingButton:
    button = driver.window.timeline.easing
    QTest.mouseClick(button, LEFT)
    assert button.popup.isVisible()
    return button


def pixel(button: EasingButton, x: float, y: float) -> QPoint:
    return button.popup.curve.on_screen((x, y)).toPoint()


def test_a_handle_is_dragged(driver: Driver, button: EasingButton) -> None:
    curve = button.popup.curve
    QTest.mousePress(curve, LEFT, PLAIN, pixel(button, 1 / 3, 1 / 3))
    QTest.mouseMove(curve, pixel(button, 0.5, 0.1))
    QTest.mouseRelease(curve, LEFT, PLAIN, pixel(button, 0.5, 0.1))
    easing = driver.window.player.easing
    assert easing.first == pytest.approx((0.5, 0.1), abs=0.01)
    assert easing.second == EVEN.second
    assert button.popup.presets.currentData() is None


def test_keys_move_the_handles(driver: Driver, button: EasingButton) -> None:
    curve = button.popup.curve
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Down, Qt.Key.Key_Space, Qt.Key.Key_Up):
        QTest.keyClick(curve, key)
    easing = driver.window.player.easing
    assert easing.first == pytest.approx((1 / 3 + 0.05, 1 / 3 - 0.05), abs=1e-6)
    assert easing.second == pytest.approx((2 / 3, 2 / 3 + 0.05), abs=1e-6)


def test_a_preset_is_chosen_and_t_stays(driver: Driver, button: EasingButton) -> None:
    driver.window.player.seek(0.3)
    QTest.keyClick(button.popup.presets, Qt.Key.Key_Down)
    assert driver.window.player.easing == PRESETS[1][1]
    assert driver.window.player.t == pytest.approx(0.3)


def test_the_button_shows_the_curve(driver: Driver, button: EasingButton) -> None:
    before = button.grab().toImage()
    driver.session.store(driver.document.steer(easing=Easing((0.9, 0.0), (0.1, 1.0))), "Set easing")
    assert button.grab().toImage() != before


def test_a_drag_is_one_step_of_the_history_and_the_next_is_another(
    driver: Driver, button: EasingButton
) -> None:
    curve, session = button.popup.curve, driver.session
    for end in ((0.5, 0.1), (0.7, 0.3)):
        QTest.mousePress(curve, LEFT, PLAIN, pixel(button, *driver.window.player.easing.first))
        for share in (0.5, 1.0):
            QTest.mouseMove(curve, pixel(button, share * end[0], share * end[1]))
        QTest.mouseRelease(curve, LEFT, PLAIN, pixel(button, *end))
    assert session.unsaved
    session.undo()
    assert driver.window.player.easing.first == pytest.approx((0.5, 0.1), abs=0.01)
    session.undo()
    assert driver.window.player.easing == EVEN
    assert button.popup.presets.currentIndex() == 0
    assert (session.undoes, session.redoes) == (None, "Set easing")


def test_an_easing_is_spread_to_all_steps(driver: Driver, button: EasingButton) -> None:
    assert not button.popup.alike.isVisible()  # where there is but one
    QTest.keyClick(button.popup.presets, Qt.Key.Key_Down)
    button.popup.hide()
    driver.key(Qt.Key.Key_N, CONTROL | SHIFT)
    assert driver.window.player.easing == EVEN
    driver.key(Qt.Key.Key_PageUp)
    QTest.mouseClick(button, LEFT)
    QTest.mouseClick(button.popup.alike, LEFT)
    assert [step.easing for step in driver.document.sequence.steps] == [PRESETS[1][1]] * 2
    assert not button.popup.alike.isEnabled()
