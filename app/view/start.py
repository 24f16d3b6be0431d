"""Start: the program, its window, and what is open in it first."""

import signal
import sys
from pathlib import Path

from PySide6.QtCore import QLocale, Qt
from PySide6.QtWidgets import QApplication

from app.recovery.journal import crashes_logged, faults_logged
from app.session import Session
from app.view.beginning import begun
from app.view.canvas.clipboard import leave_clipboard
from app.view.collecting import collecting_here
from app.view.faults import Faults
from app.view.files.remembered import last_file, theme_name
from app.view.main_window import MainWindow
from app.view.painting.theme import DARK, LIGHT, Theme, apply_theme
from app.view.window_state import restore_window
from app.view.wording.language import chosen, speak, spoken

FIRST_EXAMPLE = "arm"


def run(path: Path | None) -> int:
    """Open the window with a file, or with the first example playing, until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # Qt's loop would keep Ctrl+C in a terminal waiting
    application = QApplication(sys.argv[:1])
    application.setApplicationName("starskel")
    application.setOrganizationName("starskel")
    speak(application, spoken(chosen(), QLocale.system()))
    apply_theme(application, _theme(application))
    with crashes_logged(), faults_logged(), collecting_here():
        window = MainWindow(Session())
        Faults(window, window.recovering.keeper).watch()
        restore_window(window, window.actions_table)
        window.show()
        begin(window, path)
        status = application.exec()
        leave_clipboard()
    return status


def begin(window: MainWindow, path: Path | None) -> None:
    """Open what a crash left behind, if that is wished; else this file, the last one or the first example."""
    if window.recovering.offer_kept() and window.session.unsaved:
        return
    path = path or last_file()
    if path is not None:
        window.files.open(path)
    else:
        window.files.open_example(FIRST_EXAMPLE)
        window.player.play()
        if not begun():
            window.actions_table["begin"].trigger()


def _theme(application: QApplication) -> Theme:
    """Give the theme that the user chose, else the one that goes with the system."""
    name = theme_name()
    if name in (LIGHT.name, DARK.name):
        return DARK if name == DARK.name else LIGHT
    return DARK if application.styleHints().colorScheme() == Qt.ColorScheme.Dark else LIGHT
