"""Files dropped on the window."""

from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox, QWidget

from tests.app.driver import LEFT, PLAIN, SQUARE, Driver, square_project


def drop(driver: Driver, path: Path, on: QWidget) -> bool:
    """Drop a file as a file manager does; tell whether it was taken."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    copy, left, place = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton, QPoint(60, 60)
    entering = QDragEnterEvent(place, copy, data, left, PLAIN)
    QApplication.sendEvent(on, entering)
    if entering.isAccepted():
        QApplication.sendEvent(on, QDropEvent(QPointF(place), copy, data, left, PLAIN))
    return entering.isAccepted()


def test_a_dropped_project_is_opened_after_the_question_about_changes(driver: Driver, tmp_path: Path) -> None:
    path = square_project(tmp_path / "dropped.json")
    driver.draw("source", SQUARE)

    def discard(dialog: QWidget) -> None:
        assert isinstance(dialog, QMessageBox)
        QTest.mouseClick(dialog.button(QMessageBox.StandardButton.Discard), LEFT)

    driver.in_dialog(discard)
    assert drop(driver, path, driver.window.canvases["target"])
    driver.wait(lambda: driver.session.path == path)


@pytest.mark.parametrize("side", ["source", "target"])
def test_a_dropped_svg_becomes_the_shape_of_the_canvas_under_it(
    driver: Driver, tmp_path: Path, side: str
) -> None:
    path = tmp_path / "outline.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L10 0 L10 10 Z"/></svg>')
    assert drop(driver, path, driver.window.canvases[side])  # type: ignore[index]
    driver.wait(lambda: driver.document.polygon(side) is not None)  # type: ignore[arg-type]
    assert driver.session.undoes == "Import shapes"


def test_an_svg_without_outlines_is_refused_with_the_reason(driver: Driver, tmp_path: Path) -> None:
    path = tmp_path / "empty.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
    drop(driver, path, driver.window.canvases["source"])
    driver.wait(lambda: driver.session.refusal is not None)
    assert "empty.svg" in str(driver.session.refusal and driver.session.refusal.error)


def test_other_files_are_not_taken_by_the_window(driver: Driver, tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.touch()
    assert not drop(driver, path, driver.window)
