"""Every place of the window in a language of long words: nothing cut off, nothing forgotten, all named."""

import os
import subprocess
import sys
from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QTimer
from PySide6.QtWidgets import QApplication, QColorDialog, QFileDialog, QWidget
from pytestqt.qtbot import QtBot

from app.tools.toolbox import TOOLS
from app.view.commands.table import COMMANDS
from app.view.files.dialogs import PairDialog, ask_about_changes, complain
from app.view.main_window import MainWindow
from app.view.pictures.trace_dialog import TraceDialog
from starskel.errors import InvalidFile, told
from starskel.files.projects.picture import Picture
from starskel.files.raster_writing import png_of
from tests.app.driver import Driver
from tests.app.pseudo import Pseudo
from tests.app.reading import clipped, unnamed, untranslated

USUAL = 1280
"""Width of the window, in pixels that grow with the screen's scale."""


@pytest.fixture(autouse=True)
def pseudo(qapp: QApplication) -> Iterator[None]:
    """Speak the pseudo-language; asked for before the window, which is made of its texts."""
    translator = Pseudo()
    qapp.installTranslator(translator)
    yield
    qapp.removeTranslator(translator)


def begin(driver: Driver) -> None:
    """Open an example, with the table of marks, in a window of usual size."""
    driver.window.files.open_example("arm")
    driver.wait_for_blends()
    driver.window.actions_table["shape-duplicate"].trigger()  # so that the strip of key shapes is shown
    driver.wait_for_blends()
    driver.window.actions_table["marks"].trigger()
    QApplication.processEvents()
    driver.window.setFixedSize(USUAL, 800)
    QApplication.processEvents()


def faults(root: QWidget, *names: str) -> list[str]:
    QApplication.processEvents()  # so that everything has the size that it asked for
    QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)  # of news just come
    return [*clipped(root), *unnamed(root), *untranslated(root, *names)]


def test_the_window_with_every_tool_and_its_options(driver: Driver, window: MainWindow) -> None:
    begin(driver)
    found = {}
    for tool in TOOLS:
        driver.session.choose_tool(tool)
        QApplication.processEvents()
        found[tool] = faults(window, driver.document.name)
    assert not {tool: each for tool, each in found.items() if each}
    assert window.minimumSizeHint().width() <= USUAL


def test_every_command_and_every_dialog_that_it_opens(
    driver: Driver, window: MainWindow, qtbot: QtBot
) -> None:
    begin(driver)
    found: dict[str, list[str]] = {}
    for command in COMMANDS:
        if command.name == "quit":
            continue
        timer = QTimer(singleShot=True, interval=50)
        timer.timeout.connect(lambda name=command.name: found.update({name: looked_at_dialog(driver)}))
        timer.start()
        window.actions_table[command.name].trigger()
        qtbot.waitUntil(lambda name=command.name: name in found)
        driver.wait_for_blends()  # or the words about progress change between two layouts of the status bar
        found[command.name] += faults(window, driver.document.name)
    assert not {name: each for name, each in found.items() if each}


def looked_at_dialog(driver: Driver) -> list[str]:
    """Look at the dialog that is open, if there is one, and close it; those of Qt are Qt's own affair."""
    dialog = QApplication.activeModalWidget()
    if dialog is None:
        return []
    found = [] if isinstance(dialog, QFileDialog | QColorDialog) else faults(dialog, driver.document.name)
    dialog.close()
    return found


def test_messages_and_the_choice_of_a_pair(driver: Driver, window: MainWindow) -> None:
    found: list[str] = []

    def read(dialog: QWidget) -> None:
        found.extend(faults(dialog, "bird"))
        dialog.close()

    driver.in_dialog(read)
    ask_about_changes(window, "bird")
    driver.in_dialog(read)
    error = InvalidFile(
        told("{path} cannot be read: {reason}", path="bird", reason=told("Permission denied"))
    )
    complain(window, "bird", error)
    picture = Picture(png_of(np.full((20, 20, 4), 255, dtype=np.uint8)), (0, 0), (20, 20))
    for dialog in (PairDialog(["bird"], window), TraceDialog(picture, "source", window)):
        dialog.show()
        found.extend(faults(dialog, "bird"))
        dialog.close()
    assert not found


def test_all_of_it_on_a_screen_of_twice_the_density() -> None:
    environment = {**os.environ, "QT_SCALE_FACTOR": "2"}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", __file__, "-k", "not density"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
