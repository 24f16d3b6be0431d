"""Names that look like markup, at every place where the program shows a name."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np
import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QColorDialog, QFileDialog, QLabel, QWidget
from pytestqt.qtbot import QtBot

from app.model.filing import Filed
from app.recovery.places import Place
from app.recovery.record import Record, write_record
from app.view.commands.table import COMMANDS
from app.view.files import dialogs
from app.view.files.dialogs import PairDialog
from app.view.files.shape_chooser import ShapeChooser
from app.view.files.waiting import Waiting
from app.view.main_window import MainWindow
from app.view.pictures.trace_dialog import TraceDialog
from starskel.errors import InvalidFile, told
from starskel.files.projects.examples import example
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import write_project
from starskel.files.raster_writing import png_of
from starskel.reading.readers import read_shapes
from tests.app.driver import Driver
from tests.app.markup import NAME, misread, shows

PATH = Path(f"{NAME}.json")

ERROR = InvalidFile(told("{path} is damaged", path=NAME), told("take {name}", name=NAME))

SVG = '<svg xmlns="http://www.w3.org/2000/svg">{}</svg>'


def named(project: Project) -> Project:
    """Give the same with everything in it that can have a name called so."""
    shapes = [
        replace(shape, parts=tuple(replace(part, name=NAME) for part in shape.parts))
        for shape in project.shapes
    ]
    return replace(project, name=NAME, description=NAME, shapes=tuple(shapes))


def drawing(path: Path) -> Path:
    """Write a drawing of shapes that are called so, one of them mended."""
    names = quoteattr(NAME)
    bow, box = "M0 0L9 9L9 0L0 9Z", "M20 0h9v9h-9z"
    paths = f"<path id={names} d='{bow}'/><path inkscape:label={names} id='b' d='{box}'/>"
    space = "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'"
    path.write_text(SVG.format(f"<g {space}>{paths}</g>"))
    return path


@pytest.fixture
def renamed(driver: Driver, tmp_path: Path) -> Driver:
    """Open a project of several parts, all called so, from a file called so; and have it among the recent."""
    path = tmp_path / PATH
    write_project(path, named(example("letters-b-8")))
    driver.open(path)
    driver.wait_for_blends()
    for list_at_the_side in ("parts", "marks", "history"):
        driver.window.actions_table[list_at_the_side].trigger()
    driver.window.recent.aboutToShow.emit()
    return driver


def test_the_window_with_its_menus_and_lists(renamed: Driver) -> None:
    assert not misread(renamed.window)
    assert renamed.window.windowTitle().startswith("<b>fat & [*][*] co[*]")
    assert shows(renamed.window.parts)
    assert shows(renamed.window.recent)


def test_what_is_said_of_files(renamed: Driver, tmp_path: Path) -> None:
    status = renamed.window.statusBar()
    renamed.window.files.exported.emit(tmp_path / NAME / PATH)
    status.reading.begin(NAME)  # type: ignore[attr-defined]
    status.reading.report(0.5)  # type: ignore[attr-defined]
    renamed.session.blends.busy_changed.emit(True)
    assert shows(status)
    assert not misread(status)


def test_every_command_and_the_dialog_that_it_opens(renamed: Driver, qtbot: QtBot) -> None:
    found: dict[str, list[str]] = {}

    def look(command: str) -> None:
        dialog = QApplication.activeModalWidget()
        ours = dialog is not None and not isinstance(dialog, QFileDialog | QColorDialog)
        found[command] = misread(dialog) if ours else []
        if dialog is not None:
            dialog.close()

    for command in [each.name for each in COMMANDS if each.name != "quit"]:
        QTimer.singleShot(20, partial(look, command))
        renamed.window.actions_table[command].trigger()
        qtbot.waitUntil(lambda command=command: command in found)
        found[command] += misread(renamed.window)
    assert not {command: each for command, each in found.items() if each}


QUESTIONS: dict[str, Callable[[MainWindow], object]] = {
    "changes": lambda window: dialogs.ask_about_changes(window, NAME),
    "overtaken": lambda window: dialogs.ask_about_overtaking(window, PATH),
    "elsewhere": lambda window: dialogs.ask_for_another_place(window, PATH, ERROR),
    "overwrite": lambda window: dialogs.may_overwrite(window, [PATH]),
    "complaint": lambda window: dialogs.complain(window, NAME, ERROR),
    "recover": lambda window: window.recovering.offer(),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_questions(driver: Driver, question: str) -> None:
    place = Place.new()
    write_record(place.path, Record(named(example("arm")), Filed(Path("/") / NAME / PATH, None)))
    place.release()
    found: list[str] = []
    shown: list[bool] = []

    def look(dialog: QWidget) -> None:
        found.extend(misread(dialog))
        shown.append(shows(dialog))
        dialog.close()

    driver.in_dialog(look)
    QUESTIONS[question](driver.window)
    assert shown == [True]
    assert not found


def test_choosers_of_shapes_and_pairs_and_what_is_waited_for(driver: Driver, tmp_path: Path) -> None:
    path = drawing(tmp_path / f"{NAME}.svg")
    pictured = Picture(png_of(np.full((20, 20, 4), 255, dtype=np.uint8)), (0, 0), (20, 20))
    for dialog in (
        ShapeChooser(path, read_shapes(path), ("source", "target"), driver.window, optional=True),
        PairDialog([NAME, "b"], driver.window),
        Waiting(NAME, driver.window),
        TraceDialog(pictured, "source", driver.window),
    ):
        dialog.show()
        shown, found = shows(dialog), misread(dialog)
        dialog.close()
        assert shown or isinstance(dialog, TraceDialog)
        assert not found


def test_this_walk_finds_what_it_looks_for(window: MainWindow) -> None:
    label = QLabel(NAME, window)
    label.setToolTip(NAME)
    window.setWindowTitle(NAME)
    window.addAction(NAME)
    assert [each.partition(":")[0] for each in misread(window)] == ["label", "tip", "tip", "entry", "title"]
    label.deleteLater()
