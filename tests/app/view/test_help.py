"""What the program tells of itself."""

from collections.abc import Callable

from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton, QWidget

from app.view.about import AboutDialog, versions
from tests.app.driver import LEFT, Driver


def with_dialog(driver: Driver, kind: type[QWidget], act: Callable[[QWidget], None]) -> None:
    def check(dialog: QWidget) -> None:
        assert isinstance(dialog, kind)
        act(dialog)

    driver.in_dialog(check)


def test_the_versions_can_be_copied(driver: Driver) -> None:
    def copy(dialog: QWidget) -> None:
        button = dialog.findChild(QPushButton, "copy-versions")
        assert button is not None
        QTest.mouseClick(button, LEFT)
        dialog.close()

    with_dialog(driver, AboutDialog, copy)
    driver.window.actions_table["about"].trigger()
    assert QGuiApplication.clipboard().text() == versions()
    assert "numpy" in versions()
    assert "Python" in versions()
