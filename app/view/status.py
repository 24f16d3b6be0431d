"""Status bar: what the user can do now, what the worker does, and a way to stop it."""

from math import ceil
from pathlib import Path
from time import monotonic

from PySide6.QtCore import QTimer, QUrl, Slot
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar, QToolButton

from app.session import Session
from app.view import words
from app.view.actions import Actions

NOTICE = 12_000
"""Milliseconds that a notice stays."""

BLINK = 300
"""Milliseconds of work that are not worth a word."""


def time_left(elapsed: float, fraction: float) -> int | None:
    """Give the seconds that work will take on, None where that is soon, or too early to say.

    Many seconds are rounded up to fives: an estimate that changes with every glance is not believed.
    """
    if elapsed < 1 or fraction < 0.03:
        return None
    left = elapsed * (1 - fraction) / fraction
    if left < 2:
        return None
    return ceil(left) if left < 10 else 5 * ceil(left / 5)


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
        self.setToolTip(str(folder))
        self.show()
        self._end.start(NOTICE)

    @Slot()
    def _open(self) -> None:
        QDesktopServices.openUrl(QUrl.fromLocalFile(str(self._folder)))


class Status(QStatusBar):
    """Shows the tool's hint on the left, the worker's progress on the right."""

    def __init__(self, session: Session, actions: Actions) -> None:
        super().__init__()
        self._session = session
        self.hint = QLabel()
        self.hint.setObjectName("hint")
        self.work = QLabel()
        self.work.setObjectName("work")
        self.work.setAccessibleName(self.tr("What is being computed"))
        self.progress = QProgressBar()
        self.progress.setAccessibleName(self.tr("Progress"))
        self.progress.setRange(0, 100)
        self.progress.setFixedWidth(140)
        self.progress.setMaximumHeight(14)
        self.progress.setTextVisible(False)
        self.stop = QToolButton()
        self.stop.setDefaultAction(actions["cancel"])
        self.stop.setAccessibleName(self.tr("Cancel"))
        self.setSizeGripEnabled(False)
        self.setContentsMargins(8, 2, 8, 2)
        self.addWidget(self.hint, 1)
        self.folder = _FolderButton()
        self.left = QLabel()
        self.left.setObjectName("time-left")
        for widget in (self.folder, self.work, self.progress, self.left, self.stop):
            self.addPermanentWidget(widget)
        self._delay = QTimer(self)
        self._delay.setSingleShot(True)
        self._delay.setInterval(BLINK)
        self._delay.timeout.connect(self._show_work)
        session.tool_changed.connect(self._show_hint)
        session.progressed.connect(self._show_progress)
        session.busy_changed.connect(self._show_busy)
        self._begun = monotonic()
        self._show_hint()
        self._show_busy(session.busy)

    @Slot(object)
    def tell_written(self, path: Path) -> None:
        """Say that a file was written, and offer to show it in its folder."""
        self.showMessage(self.tr("Exported to {path}").format(path=path), NOTICE)
        self.folder.offer(path.parent)

    @Slot()
    def _show_hint(self) -> None:
        self.hint.setText(words.hint(self._session.tool.hint))

    @Slot(str, float)
    def _show_progress(self, method: str, fraction: float) -> None:
        self.work.setText(self.tr("Computing {method}…").format(method=words.method(method)))
        left = time_left(monotonic() - self._begun, fraction)
        self.left.setText("" if left is None else self.tr("about {seconds} s left").format(seconds=left))
        self.progress.setValue(round(100 * fraction))

    @Slot(bool)
    def _show_busy(self, busy: bool) -> None:
        """Show what is done and a way to stop it, where it takes longer than a blink."""
        if busy:
            self._begun = monotonic()
            self.work.clear()
            self.left.clear()
            self._delay.start()
        else:
            self._delay.stop()
            self._set_busy(False)
            self.work.setText(self._outcome())

    @Slot()
    def _show_work(self) -> None:
        self.work.setText(self.work.text() or self.tr("Computing…"))
        self._set_busy(True)

    def _set_busy(self, busy: bool) -> None:
        self.progress.setVisible(busy)
        self.left.setVisible(busy)
        self.stop.setVisible(busy)

    def _outcome(self) -> str:
        states = self._session.results.values()
        if any(state.stale and state.error is None for state in states) and self._session.document.source:
            return self.tr("Cancelled; F5 computes again") if self._session.document.target else ""
        return ""
