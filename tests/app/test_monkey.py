"""Random actions on the real window: nothing raises, Qt warns of nothing, and undo and redo lose nothing."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, QUrl, Slot
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QDialog
from pytestqt.qtbot import QtBot

from app.model.filing import project_of
from app.view.main_window import MainWindow
from starskel.files.projects.project_file import read_project, write_project
from tests.app.monkey import Monkey

STRETCH = 100
"""Actions from one look at the history to the next."""


class Nowhere(QObject):
    """Takes links, so that no other program is started."""

    @Slot(QUrl)
    def take(self, link: QUrl) -> None:
        assert link.isValid()


@pytest.fixture(autouse=True)
def at_home(qapp, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:  # type: ignore[no-untyped-def]
    """Take Qt's own file dialogs; begin in an empty folder; let no link leave the program."""
    qapp.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
    monkeypatch.chdir(tmp_path)
    nowhere = Nowhere()
    for scheme in ("file", "https"):
        QDesktopServices.setUrlHandler(scheme, nowhere, "take")
    yield
    for scheme in ("file", "https"):
        QDesktopServices.unsetUrlHandler(scheme)


def written(window: MainWindow, path: Path) -> bytes:
    """Write the document, see that it comes back the same, and give the bytes."""
    project = project_of(window.session.document, "")
    write_project(path, project)
    assert read_project(path) == project
    return path.read_bytes()


def there_and_back(window: MainWindow, path: Path) -> None:
    """Redo what there is, undo all, redo all: the same documents come by, to the byte."""
    session = window.session
    session.cancel()
    session.finish()
    while session.redoes is not None:
        session.redo()
    there = [written(window, path)]
    while session.undoes is not None:
        session.undo()
        there.append(written(window, path))
    back = [written(window, path)]
    while session.redoes is not None:
        session.redo()
        back.append(written(window, path))
    assert back == there[::-1]


@pytest.mark.endurance(usual=1_000, long=10_000)
def test_a_monkey_at_the_window_breaks_nothing(
    window: MainWindow, qtbot: QtBot, tmp_path: Path, rounds: int
) -> None:
    folder = tmp_path / "files"
    folder.mkdir()
    window.resize(800, 600)  # what is larger takes longer to paint, and shows no more
    monkey = Monkey(window, folder, seed=8)
    try:
        with qtbot.captureExceptions() as raised:
            for number in range(1, rounds + 1):
                monkey.act()
                assert not raised, raised[0][1]
                assert not monkey.faults, monkey.faults[0]
                if number % STRETCH == 0:
                    monkey.rest()
                    there_and_back(window, tmp_path / "document.json")
    except BaseException:
        print("\n".join(monkey.told[-40:]))
        raise
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    left = [dialog for dialog in window.findChildren(QDialog) if not dialog.isVisible()]
    assert not left, "dialogs that were closed are still there"
