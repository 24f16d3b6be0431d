"""Status bar: what the user can do now, what the worker does, and a way to stop it."""

from math import ceil
from pathlib import Path
from time import monotonic

from PySide6.QtCore import QTimer, QUrl, Slot
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QStatusBar, QToolButton

from app.session import Session
from app.view.commands.actions import Actions
from app.view.files.file_reader import FileReader
from app.view.wording import plain, words
from app.view.wording.counts import COUNTS
from app.view.wording.fitting_label import FittingLabel
from app.view.work_indicator import WorkIndicator

NOTICE = 12_000
"""Milliseconds that a notice stays."""

TELLING = 2.0
"""Seconds of work after which its pace tells how long the rest will take."""


def seconds_left(elapsed: float, fraction: float) -> int | None:
    """Give how many seconds of work are left, in steps of five where they are many; None while none can say.

    That supposes that what is left goes on at the same pace, so it is said with an "about".
    """
    if elapsed < TELLING or fraction <= 0:
        return None
    left = elapsed * (1 - fraction) / fraction
    return max(ceil(left), 1) if left <= 10 else 5 * ceil(left / 5)


class _FolderButton(QToolButton):
    """Opens the folder of what was just written; it goes away with the notice."""

    def __init__(self) -> None:
        super().__init__()
        self._folder = Path()
        self.setObjectName("open-folder")
        self.setText(self.tr("Open Folder"))
        self.setAccessibleName(self.tr("Open Folder"))
        self.setVisible(False)
        self.clicked.connect(self._open)
        self._end = QTimer(self)
        self._end.setSingleShot(True)
        self._end.timeout.connect(self.hide)

    def offer(self, folder: Path) -> None:
        """Be there for a while."""
        self._folder = folder
        self.setToolTip(plain.tip(str(folder)))
        self.show()
        self._end.start(NOTICE)

    @Slot()
    def _open(self) -> None:
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._folder)))


class Status(QStatusBar):
    """Shows the tool's hint on the left, what is read and computed on the right."""

    def __init__(self, session: Session, reader: FileReader, actions: Actions) -> None:
        super().__init__()
        self._session = session
        self._begun = monotonic()
        self.hint = FittingLabel()
        self.hint.setObjectName("hint")
        self.work = WorkIndicator(self.tr("What is being computed"), actions["cancel"])
        self.reading = WorkIndicator(self.tr("What is being read"), actions["cancel"])
        self.setSizeGripEnabled(False)
        self.setContentsMargins(8, 2, 8, 2)
        self.addWidget(self.hint, 1)
        self.folder = _FolderButton()
        for widget in (self.folder, self.reading, self.work):
            self.addPermanentWidget(widget)
        session.tool_changed.connect(self._show_hint)
        session.blends.progressed.connect(self._show_progress)
        session.blends.busy_changed.connect(self._show_busy)
        session.blends.restarted.connect(self._tell_restart)
        reader.begun.connect(self._show_reading)
        reader.progressed.connect(self.reading.report)
        reader.ended.connect(self.reading.end)
        self._show_hint()
        self._show_busy(session.blends.busy)

    @Slot(str)
    def tell(self, text: str) -> None:
        """Say something for a while; nothing ends what was said before."""
        self.showMessage(text, NOTICE)

    @Slot(object)
    def tell_written(self, path: Path) -> None:
        """Say that a file was written, and offer to show it in its folder."""
        self.showMessage(self.tr("Exported to {path}").format(path=path), NOTICE)
        self.folder.offer(path.parent)

    @Slot()
    def _tell_restart(self) -> None:
        self.showMessage(self.tr("The computation ended by a fault and was begun anew."), NOTICE)

    @Slot()
    def _show_hint(self) -> None:
        hint = words.hint(self._session.tool.hint)
        sentences = hint.removesuffix(".").split(". ")
        self.hint.say([". ".join(sentences[:count]) + "." for count in range(len(sentences), 0, -1)])
        self.hint.setToolTip(hint)

    @Slot(str, float)
    def _show_progress(self, method: str, fraction: float) -> None:
        text = self.tr("Computing {method}…").format(method=words.method(method))
        left = seconds_left(monotonic() - self._begun, fraction)
        self.work.report(fraction, text if left is None else f"{text} {COUNTS.seconds_left(left)}")

    @Slot(bool)
    def _show_busy(self, busy: bool) -> None:
        if busy:
            self._begun = monotonic()
            self.work.begin(self.tr("Computing…"))
        else:
            self.work.end(self._outcome())

    @Slot(str)
    def _show_reading(self, name: str) -> None:
        self.reading.begin(self.tr("Reading {name}…").format(name=name))

    def _outcome(self) -> str:
        if self._session.tool.busy:  # methods that do not follow a gesture are out of date until it ends
            return ""
        states = self._session.blends.results.values()
        if any(state.stale and state.error is None for state in states) and self._session.document.source:
            return self.tr("Cancelled; F5 computes again") if self._session.document.target else ""
        return ""
