"""Exceptions that nothing caught: written down, the document kept, and one dialog with a report to copy."""

import sys
import threading
import traceback
from types import TracebackType

from PySide6.QtCore import QObject, Qt, Signal, Slot
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QPlainTextEdit, QVBoxLayout, QWidget

from app.recovery.journal import log_fault
from app.recovery.keeper import Keeper
from app.view.about import versions
from app.view.asking import answers, asked
from app.view.wording.plain import Label


class Faults(QObject):
    """Takes in exceptions that nothing caught, from any thread; else Qt would print and forget them."""

    _came = Signal(str, bool)

    def __init__(self, window: QWidget, keeper: Keeper) -> None:
        super().__init__(window)
        self._window = window
        self._keeper = keeper
        self._shown = False
        self._came.connect(self._show, Qt.ConnectionType.QueuedConnection)

    def watch(self) -> None:
        """Take in all that come from now on."""
        sys.excepthook = self.take
        threading.excepthook = self._take_of_thread

    def take(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        """Print an exception, write it down, keep the document and show it."""
        text = "".join(traceback.format_exception(kind, error, trace))
        sys.stderr.write(text)
        if issubclass(kind, Exception):
            log_fault(f"{versions()}\n{text}")
            self._came.emit(text, self._keeper.keep_now())

    def _take_of_thread(self, given: threading.ExceptHookArgs) -> None:
        if given.exc_value is not None:
            self.take(given.exc_type, given.exc_value, given.exc_traceback)

    @Slot(str, bool)
    def _show(self, text: str, kept: bool) -> None:
        if self._shown:
            return  # one message is enough where the same fault comes with every frame
        self._shown = True
        asked(FaultDialog(f"{versions()}\n\n{text}", self._window, kept=kept))
        self._shown = False


class FaultDialog(QDialog):
    """Says that there was a fault, what became of the document, and gives a report to copy."""

    def __init__(self, report: str, parent: QWidget | None = None, *, kept: bool) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("A fault in the program"))
        self.resize(620, 400)
        safe = self.tr("Your document is still here, and what was not saved has been kept in case it ends.")
        unsafe = self.tr("Your document is still here, but it could not be kept: save it under another name.")
        heading = Label(self.tr("Something went wrong inside the program."))
        heading.setObjectName("heading")
        self.state = Label(safe if kept else unsafe, wrapped=True)
        use = Label(self.tr("With this report the fault can be found and mended:"))
        self.report = QPlainTextEdit(report)
        self.report.setReadOnly(True)
        self.report.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        self.report.setAccessibleName(self.tr("Report"))
        buttons = answers(self, QDialogButtonBox.StandardButton.Close)
        copy = buttons.addButton(self.tr("&Copy Report"), QDialogButtonBox.ButtonRole.ActionRole)
        copy.setObjectName("copy-report")
        copy.clicked.connect(self._copy)
        layout = QVBoxLayout(self)
        for widget in (heading, self.state, use, self.report, buttons):
            layout.addWidget(widget)

    @Slot()
    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.report.toPlainText())
