"""Faults: exceptions that nothing caught, from slots and threads, and crashes of the whole program."""

import signal
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QPushButton, QWidget

from app.recovery import journal
from app.recovery.journal import log_fault
from app.recovery.places import state_folder
from app.view.faults import FaultDialog, Faults
from app.view.main_window import MainWindow
from tests.app.driver import SQUARE, Driver
from tests.app.program import program


@pytest.fixture
def faults(window: MainWindow) -> Iterator[Faults]:
    hooks = sys.excepthook, threading.excepthook
    faults = Faults(window, window.recovering.keeper)
    faults.watch()
    yield faults
    sys.excepthook, threading.excepthook = hooks


def fail() -> None:
    raise ZeroDivisionError("in a slot")


def in_slot() -> None:
    QTimer.singleShot(0, fail)


def in_thread() -> None:
    threading.Thread(target=fail).start()


@pytest.mark.parametrize("cause", [in_slot, in_thread])
def test_a_fault_is_written_down_and_shown_with_a_report_and_the_document_is_kept(
    driver: Driver, faults: Faults, capfd: pytest.CaptureFixture[str], cause
) -> None:  # type: ignore[no-untyped-def]
    driver.draw("source", SQUARE)
    assert driver.session.unsaved
    seen: list[str] = []

    def read(dialog: QWidget) -> None:
        assert isinstance(dialog, FaultDialog)
        copy = dialog.findChild(QPushButton, "copy-report")
        assert copy is not None
        copy.click()
        seen.append(QGuiApplication.clipboard().text())
        assert "has been kept" in dialog.state.text()
        dialog.reject()

    driver.in_dialog(read)
    cause()
    driver.wait(lambda: bool(seen))
    assert "ZeroDivisionError: in a slot" in seen[0]
    assert "PySide6" in seen[0]
    assert "ZeroDivisionError: in a slot" in capfd.readouterr().err
    assert "ZeroDivisionError: in a slot" in (state_folder() / "faults.log").read_text()
    assert len(list((state_folder() / "recovery").glob("*.json"))) == 1


def test_many_faults_show_one_dialog(driver: Driver, faults: Faults) -> None:
    dialogs: list[QWidget] = []

    def read(dialog: QWidget) -> None:
        dialogs.append(dialog)
        for _ in range(50):
            in_slot()
        QTimer.singleShot(200, dialog.close)

    driver.in_dialog(read)
    in_slot()
    driver.wait(lambda: (state_folder() / "faults.log").exists() and bool(dialogs))
    driver.wait(lambda: (state_folder() / "faults.log").read_text().count("ZeroDivisionError: ") == 51)
    assert len(dialogs) == 1


def test_where_the_document_cannot_be_kept_the_dialog_says_so(driver: Driver, faults: Faults) -> None:
    state_folder().parent.mkdir(parents=True, exist_ok=True)
    state_folder().write_text("a file where the folder should be")
    driver.draw("source", SQUARE)
    seen: list[str] = []

    def read(dialog: QWidget) -> None:
        assert isinstance(dialog, FaultDialog)
        seen.append(dialog.state.text())
        dialog.reject()

    driver.in_dialog(read)
    in_slot()
    driver.wait(lambda: bool(seen))
    assert "could not be kept" in seen[0]


def test_a_log_that_has_grown_long_begins_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(journal, "MOST", 1000)
    for number in range(100):
        log_fault(f"fault {number}")
    logs = {path.name: path.read_text() for path in state_folder().iterdir()}
    assert set(logs) == {"faults.log", "faults.old.log"}
    assert "fault 99" in logs["faults.log"]
    assert all(len(text) < 1100 for text in logs.values())


def test_a_crash_leaves_the_calls_of_all_threads_and_the_unsaved_work(tmp_path: Path) -> None:
    done = program(
        tmp_path,
        """
from dataclasses import replace
window.session.store(replace(window.session.document, name="mine"), "Name")
assert window.recovering.keeper.keep_now()
import faulthandler
faulthandler._sigsegv()
""",
    )
    assert done.returncode == -signal.SIGSEGV, done.stderr
    log = (tmp_path / "starskel" / "crashes.log").read_text()
    assert "Segmentation fault" in log
    assert "in act" in log
    assert len(list((tmp_path / "starskel" / "recovery").glob("*.json"))) == 1


def test_a_fault_in_a_blend_is_shown_in_its_panel_and_written_down(tmp_path: Path) -> None:
    done = program(
        tmp_path,
        """
import app.compute.job
def fail(*_, **__):
    raise ZeroDivisionError("in a blend")
app.compute.job.blend = fail
def close():
    assert "ZeroDivisionError" in window.panels.panel("stitched").view.message
    window.close()
window.session.blends.busy_changed.connect(lambda busy: busy or QTimer.singleShot(0, close))
window.session.blends.recompute()
""",
    )
    assert done.returncode == 0, done.stderr
    for told in (done.stderr, (tmp_path / "starskel" / "faults.log").read_text()):
        assert "ZeroDivisionError: in a blend" in told
        assert "blending by stitched" in told
