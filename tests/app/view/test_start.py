import sys

import pytest
from PySide6.QtWidgets import QMessageBox, QWidget

from app.view.main_window import MainWindow
from app.view.start import FIRST_EXAMPLE, Faults
from starskel.files.examples import example_names
from tests.app.driver import Driver


def fault() -> tuple[type[BaseException], BaseException, object]:
    try:
        raise ZeroDivisionError("in a slot")
    except ZeroDivisionError:
        kind, error, trace = sys.exc_info()
        assert kind is not None
        assert error is not None
        return kind, error, trace


def test_an_exception_that_nothing_caught_is_printed_and_shown(
    driver: Driver, window: MainWindow, capsys: pytest.CaptureFixture[str]
) -> None:
    seen: list[str] = []

    def read(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        seen.append(dialog.detailedText())
        dialog.accept()

    driver.in_dialog(read)
    Faults(window).take(*fault())  # type: ignore[arg-type]
    driver.wait(lambda: bool(seen))
    assert "ZeroDivisionError: in a slot" in seen[0]
    assert "ZeroDivisionError: in a slot" in capsys.readouterr().err


def test_the_first_example_is_there() -> None:
    assert FIRST_EXAMPLE in example_names()


@pytest.mark.parametrize("name", example_names())
def test_every_example_opens_and_blends_by_every_method(driver: Driver, name: str) -> None:
    driver.window.files.open_example(name)
    driver.wait_for_blends()
    assert len(driver.session.fresh_results) == len(driver.document.methods)
    assert not driver.session.unsaved
