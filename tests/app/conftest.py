"""Qt without a screen, a window to drive with real events, and a check that nothing is left alive."""

import gc
import os
from collections.abc import Iterator

os.environ["QT_QPA_PLATFORM"] = "offscreen"  # before Qt is loaded, whatever the surroundings say

import pytest
import shiboken6
from PySide6.QtCore import QCoreApplication, QEvent, QThread
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.session import Session
from app.view.main_window import MainWindow
from app.view.theme import LIGHT, apply_theme
from starskel import METHODS
from tests.app.driver import Driver


def pytest_configure(config: pytest.Config) -> None:
    # said by the offscreen platform of what means nothing without a screen, such as stacking windows
    config.addinivalue_line("qt_log_ignore", "^This plugin does not support ")


@pytest.fixture(autouse=True)
def nothing_left_alive(request: pytest.FixtureRequest) -> Iterator[None]:
    """Fail a test that leaves a widget or a running thread behind."""
    yield
    if QApplication.instance() is None:
        return
    gc.collect()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    widgets = [repr(widget) for widget in QApplication.topLevelWidgets()]
    threads = [
        thread
        for thread in shiboken6.getAllValidWrappers()
        if isinstance(thread, QThread) and thread.isRunning() and thread != QThread.currentThread()
    ]
    assert not widgets, f"{request.node.name} leaves widgets: {widgets}"
    assert not threads, f"{request.node.name} leaves {len(threads)} threads running"


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    apply_theme(application, LIGHT)
    window = MainWindow(Session(METHODS[::-1]))
    window.show()
    qtbot.waitExposed(window)
    window.session.new()
    yield window
    window.session.new()  # with nothing unsaved, closing asks nothing
    window.close()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def driver(window: MainWindow, qtbot: QtBot) -> Driver:
    return Driver(window, qtbot)
