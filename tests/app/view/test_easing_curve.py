import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.model.easing import PRESETS, Easing
from app.view.easing_button import EasingButton
from tests.app.driver import LEFT, PLAIN, Driver


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
    assert easing.second == (2 / 3, 2 / 3)
    assert button.popup.presets.currentData() is None


def test_keys_move_the_handles(driver: Driver, button: EasingButton) -> None:
    curve = button.popup.curve
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Down, Qt.Key.Key_Space, Qt.Key.Key_Up):
        QTest.keyClick(curve, key)
    easing = driver.window.player.easing
    assert easing.first == pytest.approx((1 / 3 + 0.05, 1 / 3 - 0.05))
    assert easing.second == pytest.approx((2 / 3, 2 / 3 + 0.05))


def test_a_preset_is_chosen_and_t_stays(driver: Driver, button: EasingButton) -> None:
    driver.window.player.seek(0.3)
    QTest.keyClick(button.popup.presets, Qt.Key.Key_Down)
    assert driver.window.player.easing == PRESETS[1][1]
    assert driver.window.player.t == pytest.approx(0.3)


def test_the_button_shows_the_curve(driver: Driver, button: EasingButton) -> None:
    before = button.grab().toImage()
    driver.window.player.set_easing(Easing((0.9, 0.0), (0.1, 1.0)))
    assert button.grab().toImage() != before
