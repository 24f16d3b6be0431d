from pathlib import Path

import pytest
from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QToolButton

from app.view.main_window import MainWindow
from app.view.status import Status, seconds_left
from tests.app.driver import LEFT, Driver


@pytest.mark.parametrize(
    ("elapsed", "fraction", "left"),
    [(1.0, 0.5, None), (60.0, 0.0, None), (4.0, 0.5, 4), (3.0, 0.99, 1), (9.0, 0.3, 25), (3.0, 1.0, 1)],
)
def test_how_long_it_still_takes_is_told_as_soon_as_the_pace_is_known(
    elapsed: float, fraction: float, left: int | None
) -> None:
    assert seconds_left(elapsed, fraction) == left


def test_a_narrow_window_gets_fewer_sentences_of_the_hint(window: MainWindow) -> None:
    bar = window.statusBar()
    assert isinstance(bar, Status)
    hint = bar.hint
    window.actions_table["select"].trigger()
    whole = hint.toolTip()
    hint.resize(2000, hint.height())
    assert hint.text() == whole
    hint.resize(hint.sizeHint().width() - 20, hint.height())
    assert whole.startswith(hint.text())
    assert hint.text().endswith(".")
    assert len(hint.text()) < len(whole)


def test_the_folder_of_an_export_is_a_click_away(
    driver: Driver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[QUrl] = []
    monkeypatch.setattr(QDesktopServices, "openUrl", opened.append)
    button = driver.window.findChild(QToolButton, "open-folder")
    assert button is not None
    assert not button.isVisible()
    driver.window.files.exported.emit(tmp_path / "row.svg")
    assert "row.svg" in driver.window.statusBar().currentMessage()
    QTest.mouseClick(button, LEFT)
    assert [url.toLocalFile() for url in opened] == [str(tmp_path)]
