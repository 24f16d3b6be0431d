"""A monkey at the window: random clicks, drags, keys, wheels, commands and files.

It answers what it is asked, is seeded, and tells what it does, so that what it finds can be looked for again.
"""

from collections.abc import Callable
from pathlib import Path
from random import Random

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt, QTimer, Slot
from PySide6.QtGui import QGuiApplication, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QDialog,
    QFileDialog,
    QLineEdit,
    QMenu,
    QWidget,
)

from app.model.marks import SIDES
from app.tools.toolbox import TOOLS
from app.view.commands.table import COMMANDS
from app.view.main_window import MainWindow
from starskel.errors import StarskelError
from starskel.files.projects.examples import example, example_names
from starskel.files.projects.project_file import write_project

KEYS = [getattr(Qt.Key, f"Key_{name}") for name in "ACDFMNPSTVXYZ159"] + [
    *(Qt.Key.Key_Return, Qt.Key.Key_Escape, Qt.Key.Key_Delete, Qt.Key.Key_Backspace, Qt.Key.Key_Space),
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Tab, Qt.Key.Key_Home),
]

BUTTONS = [Qt.MouseButton.LeftButton] * 6 + [Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton]

MODIFIERS = [Qt.KeyboardModifier.NoModifier] * 6 + [
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
]

SVG = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H80V60H0Z M20 20V40H40V20Z M90 0h9v9z"/></svg>'

PATIENCE = 12
"""Answers to one dialog, after which it is closed."""

PULSE = 10
"""Milliseconds from one look for something to answer to the next."""


def lay_out(folder: Path) -> list[str]:
    """Put files of all kinds into a folder, and give names for them and for some that are not there."""
    for name in ("arm", "letters-b-8", "letters-i-j", "star", "figure-9-fish"):
        write_project(folder / f"{name}.json", example(name))
    (folder / "drawing.svg").write_text(SVG)
    (folder / "broken.json").write_text('{"format": "starskel-project", "version": 4')
    (folder / "empty.svg").write_bytes(b"")
    (folder / "not.png").write_text("no picture")
    return [
        *(path.name for path in sorted(folder.iterdir())),
        "new",
        "other.json",
        "film.svg",
        "no/such.json",
    ]


class Monkey(QObject):
    """Acts at random.

    Attributes
    ----------
    told : list of str
        What it did, the last at the end.
    faults : list of Exception
        For what, other than errors that tell their reason, there was no blend.
    """

    def __init__(self, window: MainWindow, folder: Path, seed: int) -> None:
        super().__init__(window)
        self.told: list[str] = []
        self.faults: list[Exception] = []
        self._window = window
        self._session = window.session
        self._names = lay_out(folder)
        self._folder = folder
        self._random = Random(seed)
        self._answers = Random(seed)  # asked at times of their own, which must not change what is done next
        self._asked: QWidget | None = None
        self._patience = PATIENCE
        self._acting = 0
        self._seen = 0
        self._commands = [command.name for command in COMMANDS if command.name != "quit"]
        self._deeds: list[tuple[int, Callable[[], str]]] = [
            (14, self._click),
            (10, self._drag),
            (4, self._wheel),
            (10, self._key),
            (4, self._type_at_widget),
            (12, self._command),
            (6, self._undo_or_redo),
            (8, self._take_tool),
            (6, self._use_widget),
            (3, self._open),
            (2, self._example),
            (2, self._save),
            (2, self._paste),
            (2, self._wait),
            (1, self._resize),
        ]
        self._watch()
        self._session.blends.changed.connect(self._follow)

    @Slot()
    def _follow(self) -> None:
        errors = [state.error for state in self._session.blends.results.values() if state.error is not None]
        self.faults += [error for error in errors if not isinstance(error, StarskelError)]

    def act(self) -> None:
        """Do one thing, and sometimes wait until all that comes of it has happened."""
        weights, deeds = zip(*self._deeds, strict=True)
        deed = self._random.choices(deeds, weights)[0]
        self._acting += 1
        self.told.append(deed.__name__.strip("_"))
        self.told[-1] += f" {deed()}"
        if self._random.random() < 0.2:
            QApplication.processEvents()
            QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    def rest(self) -> None:
        """Do nothing until everything has been answered."""
        self._acting += 1
        while QApplication.activeModalWidget() or QApplication.activePopupWidget():
            QTest.qWait(PULSE)

    # what it does

    def _place(self, widget: QWidget) -> QPoint:
        return QPoint(
            self._random.randrange(widget.width() or 1), self._random.randrange(widget.height() or 1)
        )

    def _canvas_place(self) -> tuple[QWidget, QPoint]:
        """Give a place on a canvas, often one near a vertex."""
        side = self._random.choice(SIDES)
        canvas, vertices = self._window.canvases[side], self._session.document.vertices(side)
        place = self._place(canvas)
        if len(vertices) and self._random.random() < 0.6:
            x, y = canvas.camera.to_screen(np.asarray(self._random.choice(vertices.tolist())))
            if canvas.rect().contains(QPoint(round(x), round(y))):
                place = QPoint(round(x), round(y))
        return canvas, place

    def _click(self) -> str:
        canvas, place = self._canvas_place()
        button, modifier = self._random.choice(BUTTONS), self._random.choice(MODIFIERS)
        QTest.mouseMove(canvas, place)
        click = self._random.choice([QTest.mouseClick, QTest.mouseClick, QTest.mouseDClick])
        click(canvas, button, modifier, place)
        return f"{click.__name__} {button.name} {modifier.name} {place.toTuple()}"

    def _drag(self) -> str:
        canvas, place = self._canvas_place()
        button, modifier = self._random.choice(BUTTONS), self._random.choice(MODIFIERS)
        QTest.mousePress(canvas, button, modifier, place)
        for _ in range(self._random.randrange(5)):
            place = self._place(canvas)
            QTest.mouseMove(canvas, place)
            QApplication.processEvents()
            if self._random.random() < 0.1:
                QTest.keyClick(canvas, self._random.choice(KEYS))
        if self._random.random() < 0.95:
            QTest.mouseRelease(canvas, button, modifier, place)
        return f"{button.name} {modifier.name} to {place.toTuple()}"

    def _wheel(self) -> str:
        widget = self._random.choice(self._widgets())
        place = QPointF(self._place(widget))
        turn = QPoint(0, self._random.choice([-480, -120, -15, 15, 120, 480]))
        QApplication.sendEvent(
            widget,
            QWheelEvent(
                place,
                QPointF(widget.mapToGlobal(place.toPoint())),
                QPoint(),
                turn,
                Qt.MouseButton.NoButton,
                self._random.choice(MODIFIERS),
                Qt.ScrollPhase.NoScrollPhase,
                False,
            ),
        )
        return f"{named(widget)} {turn.y()}"

    def _key(self) -> str:
        key, modifier = self._random.choice(KEYS), self._random.choice(MODIFIERS)
        if self._random.random() < 0.5:
            self._window.canvases[self._random.choice(SIDES)].setFocus()
        if (handle := self._window.windowHandle()) is not None:
            QTest.keyClick(handle, key, modifier)
        return f"{modifier.name} {key.name}"

    def _type_at_widget(self) -> str:
        widget = self._random.choice(self._widgets())
        key = self._random.choice(KEYS)
        QTest.keyClick(widget, key)
        return f"{named(widget)} {key.name}"

    def _command(self) -> str:
        name = self._random.choice(self._commands)
        self.told[-1] += f" {name}"
        self._window.actions_table[name].trigger()
        return ""

    def _undo_or_redo(self) -> str:
        name, count = self._random.choice(["undo", "redo"]), self._random.randrange(1, 6)
        for _ in range(count):
            self._window.actions_table[name].trigger()
        return f"{name} {count}"

    def _take_tool(self) -> str:
        name = self._random.choice(list(TOOLS))
        self._window.actions_table[name].trigger()
        return name

    def _use_widget(self) -> str:
        widget = self._random.choice(self._widgets())
        place, button = self._place(widget), self._random.choice(BUTTONS)
        self.told[-1] += f" {named(widget)} {button.name} {place.toTuple()}"
        QTest.mouseClick(widget, button, Qt.KeyboardModifier.NoModifier, place)
        return ""

    def _open(self) -> str:
        name = self._random.choice(self._names)
        self.told[-1] += f" {name}"
        self._window.files.open(self._folder / name)
        return ""

    def _example(self) -> str:
        name = self._random.choice(example_names())
        self._window.files.open_example(name)
        return name

    def _save(self) -> str:
        if self._random.random() < 0.2 and self._session.path is not None:
            self._session.path.write_text("another program")
        self._window.files.save()
        return str(self._session.path)

    def _paste(self) -> str:
        QGuiApplication.clipboard().setText(
            self._random.choice([SVG, "0 0\n9 0\n0 9", "[[0,0],[1,0]]", "", "x"])
        )
        self._window.actions_table["paste"].trigger()
        return ""

    def _wait(self) -> str:
        duration = self._random.choice([1, 20, 150])
        QTest.qWait(duration)
        return str(duration)

    def _resize(self) -> str:
        self._window.resize(self._random.randrange(500, 1100), self._random.randrange(400, 800))
        return str(self._window.size().toTuple())

    def _widgets(self) -> list[QWidget]:
        return shown(self._window)

    # what it answers

    def _watch(self) -> None:
        QTimer.singleShot(PULSE, self, self._look)

    def _look(self) -> None:
        """Answer what is open; the next look may come while this answer has opened something else."""
        self._watch()
        stuck, self._seen = self._seen == self._acting, self._acting
        popup, dialog = QApplication.activePopupWidget(), QApplication.activeModalWidget()
        if popup is not None:
            self._answer_popup(popup)
        elif dialog is not None:
            self._answer(dialog)
        elif stuck and QApplication.mouseButtons() != Qt.MouseButton.NoButton:
            QTest.mouseRelease(self._window, QApplication.mouseButtons())

    def _answer_popup(self, popup: QWidget) -> None:
        """Choose an entry, or leave it."""
        actions = [action for action in popup.actions() if action.isEnabled() and not action.isSeparator()]
        if isinstance(popup, QMenu) and actions and self._answers.random() < 0.5:
            action = self._answers.choice(actions)
            self.told.append(f"  in a menu {action.text()!r}")
            if action.objectName() != "quit":
                popup.close()
                action.trigger()
                return
        if self._answers.random() < 0.5:
            QTest.keyClick(popup, self._answers.choice([Qt.Key.Key_Down, Qt.Key.Key_Return]))
        else:
            popup.close()

    def _answer(self, dialog: QWidget) -> None:
        if dialog is not self._asked:
            self._asked, self._patience = dialog, PATIENCE
            self.told.append(f"  asked by {named(dialog)}")
        self._patience -= 1
        if self._patience < 0 or self._answers.random() < 0.1:
            self.told.append("  closes it")
            dialog.close()
        elif isinstance(dialog, QFileDialog):
            self._name_file(dialog)
        else:
            self._use_dialog(dialog)

    def _name_file(self, dialog: QFileDialog) -> None:
        """Type a name in the folder: anything else could leave it."""
        field = dialog.findChild(QLineEdit, "fileNameEdit")
        assert field is not None
        name = self._answers.choice(self._names)
        self.told.append(f"  names {name}")
        field.setText(str(self._folder / name))
        QTest.keyClick(field, Qt.Key.Key_Return)

    def _use_dialog(self, dialog: QWidget) -> None:
        widgets = shown(dialog)
        buttons = [each for each in widgets if isinstance(each, QAbstractButton)]
        if buttons and self._answers.random() < 0.5:
            button = self._answers.choice(buttons)
            self.told.append(f"  clicks {button.text()!r}")
            button.click()
        elif widgets:
            widget, key = self._answers.choice(widgets), self._answers.choice(KEYS)
            if isinstance(widget, QComboBox):
                widget.setCurrentIndex(self._answers.randrange(max(widget.count(), 1)))
            self.told.append(f"  {named(widget)} {key.name}")
            QTest.keyClick(widget, key)


def shown(root: QWidget) -> list[QWidget]:
    """Give what can be used in a window or a dialog."""
    return [each for each in root.findChildren(QWidget) if each.isVisible() and each.isEnabled()]


def named(widget: QWidget) -> str:
    """Name a widget so that it is found again."""
    title = widget.windowTitle() if isinstance(widget, QDialog) else widget.objectName()
    return f"{type(widget).__name__} {title or widget.accessibleName()!r}"
