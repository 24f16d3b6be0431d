"""Qt without a screen, a window to drive with real events, and a check that nothing is left alive."""

import gc
import os
from collections.abc import Iterator
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"  # before Qt is loaded, whatever the surroundings say

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QSettings, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.session import Session
from app.view.canvas.clipboard import leave_clipboard
from app.view.main_window import MainWindow
from app.view.painting.theme import LIGHT, apply_theme
from tests.app.driver import Driver
from tests.app.leftovers import every_dialog_answered, left_alive

PATIENCE = 30_000
"""Milliseconds after which a dialog counts as forgotten."""


def pytest_configure(config: pytest.Config) -> None:
    # said by the offscreen platform of what means nothing without a screen, such as stacking windows
    config.addinivalue_line("qt_log_ignore", "^This plugin does not support ")


@pytest.fixture(autouse=True)
def nothing_left_alive(request: pytest.FixtureRequest) -> Iterator[None]:
    """Fail a test that leaves a window or a running thread behind."""
    yield
    left = left_alive()
    assert not left, f"{request.node.name} leaves {left}"


@pytest.fixture(autouse=True)
def garbage_left_to_this_thread() -> Iterator[None]:
    """Let no worker destroy a widget of a test; between tests all garbage is collected here."""
    gc.disable()
    yield
    gc.enable()


@pytest.fixture(autouse=True)
def settings_of_its_own(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no test read or write what the user of this machine has set, or has left unsaved."""
    tmp_path = tmp_path_factory.mktemp("settings")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    for kind in (QSettings.Format.NativeFormat, QSettings.Format.IniFormat):
        QSettings.setPath(kind, QSettings.Scope.UserScope, str(tmp_path))


@pytest.fixture
def own_dialogs(qapp: QApplication, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Take Qt's own file dialogs, which can be typed into, not the desktop's; begin in an empty folder."""
    qapp.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    apply_theme(application, LIGHT)
    window = MainWindow(Session())
    window.resize(1280, 860)  # its usual size, which the screen that there is not would not allow
    window.show()
    qtbot.waitExposed(window)
    window.session.new()
    try:
        with every_dialog_answered(PATIENCE):
            yield window
    finally:
        window.session.new()  # with nothing unsaved, closing asks nothing
        window.close()
        leave_clipboard()
        window.deleteLater()
        application.clipboard().clear()  # without a screen it would outlive Python, and end it with a signal
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def driver(window: MainWindow, qtbot: QtBot) -> Driver:
    return Driver(window, qtbot)
