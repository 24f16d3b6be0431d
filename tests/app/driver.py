"""A person at the window."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QWindow
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.model.filing import stored
from app.model.marks import Side
from app.session import Session
from app.view.main_window import MainWindow
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import write_project
from starskel.files.projects.step import Step
from starskel.polygon import Polygon

LEFT = Qt.MouseButton.LeftButton
MIDDLE = Qt.MouseButton.MiddleButton
PLAIN = Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CONTROL = Qt.KeyboardModifier.ControlModifier

TRIANGLE = ((10, 10), (90, 10), (50, 80))
SQUARE = ((10, 10), (90, 10), (90, 90), (10, 90))


class Driver:
    """Drives a window as a person does: with mouse and keys, at places of the document."""

    def __init__(self, window: MainWindow, qtbot: QtBot) -> None:
        self.window = window
        self.session = window.session
        self._qtbot = qtbot

    def place(self, side: Side, x: float, y: float) -> QPoint:
        """Give the pixel of the window under which a place of the document lies."""
        canvas = self.window.canvases[side]
        place = canvas.camera.to_screen(np.array([x, y]))
        return canvas.mapTo(self.window, QPoint(round(place[0]), round(place[1])))

    def click(self, side: Side, *places: tuple[float, float], modifier: Qt.KeyboardModifier = PLAIN) -> None:
        for x, y in places:
            self.hover(side, x, y)
            QTest.mouseClick(self._handle, LEFT, modifier, self.place(side, x, y))

    def double_click(self, side: Side, x: float, y: float) -> None:
        QTest.mouseDClick(self._handle, LEFT, PLAIN, self.place(side, x, y))

    def hover(self, side: Side, x: float, y: float) -> None:
        QTest.mouseMove(self._handle, self.place(side, x, y))

    def press(self, side: Side, x: float, y: float) -> None:
        QTest.mousePress(self._handle, LEFT, PLAIN, self.place(side, x, y))

    def release(self, side: Side, x: float, y: float) -> None:
        QTest.mouseRelease(self._handle, LEFT, PLAIN, self.place(side, x, y))

    def drag(self, side: Side, *stops: tuple[float, float]) -> None:
        self.press(side, *stops[0])
        for stop in stops[1:]:
            self.hover(side, *stop)
        self.release(side, *stops[-1])

    def key(self, key: Qt.Key, modifier: Qt.KeyboardModifier = PLAIN) -> None:
        self.window.activateWindow()  # no window manager does so here when a dialog has closed
        assert QTest.qWaitForWindowActive(self.window)
        QTest.keyClick(self._handle, key, modifier)

    def wait(self, condition: Callable[[], bool]) -> None:
        self._qtbot.waitUntil(condition, timeout=20_000)

    def wait_for_blends(self) -> None:
        """Wait until every method has its blend, or failed."""
        self.wait(lambda: not self.session.blends.busy)

    @property
    def document(self) -> Document:
        return self.session.document

    def corners(self, side: Side) -> list[list[float]]:
        """Give the vertices in whole units: a pixel is less than one."""
        return self.document.vertices(side).round(0).tolist()

    def open(self, path: Path) -> None:
        """Open a file and wait until it is read, and what it asks is answered."""
        self.window.files.open(path)
        self.wait_until_read()

    def wait_until_read(self) -> None:
        self.wait(lambda: not self.window.importing.reader.busy)

    def save(self, path: Path) -> None:
        """Save, as the command does after it has asked."""
        save(self.session, path)

    def draw(self, side: Side, places: tuple[tuple[float, float], ...]) -> None:
        """Draw a shape with the drawing tool and close it by Enter."""
        self.key(Qt.Key.Key_D)
        self.click(side, *places)
        self.key(Qt.Key.Key_Return)

    def draw_both(self) -> None:
        self.draw("source", SQUARE)
        self.draw("target", SQUARE)

    def mark(self, source: tuple[float, float], target: tuple[float, float]) -> None:
        """Set a mark with the marking tool."""
        self.key(Qt.Key.Key_M)
        self.click("source", source)
        self.click("target", target)

    def in_dialog(self, act: Callable[[QWidget], None]) -> None:
        """Act as soon as a dialog is open that is not yet; to be called before what opens it."""
        before = QApplication.activeModalWidget()

        def attempt() -> None:
            dialog = QApplication.activeModalWidget()
            if dialog is None or dialog is before:
                QTimer.singleShot(20, attempt)
                return
            try:
                act(dialog)
            except BaseException:
                dialog.close()  # or the test would wait for it forever
                raise

        QTimer.singleShot(20, attempt)

    @property
    def _handle(self) -> QWindow:
        handle = self.window.windowHandle()
        assert handle is not None
        return handle


def save(session: Session, path: Path) -> None:
    """Write what is open to a file, and note that."""
    session.note_saved(session.document, stored(session.document, path))


def name_file(dialog: QWidget, name: str) -> None:
    """Save or open a file of the dialog's folder."""
    type_name(dialog, name)
    assert not dialog.isVisible(), f"{name} was not taken"


def type_name(dialog: QWidget, name: str) -> None:
    """Type the name of a file and press Enter."""
    field = dialog.findChild(QLineEdit, "fileNameEdit")
    assert field is not None
    field.selectAll()
    QTest.keyClicks(field, name)
    QTest.keyClick(field, Qt.Key.Key_Return)


def square_project(path: Path) -> Path:
    """Write a project whose key shapes are both the square."""
    shape = KeyShape.of(Polygon(SQUARE))
    write_project(path, Project(path.stem, (shape, shape), (Step.of(),), ("vertex",)))
    return path
