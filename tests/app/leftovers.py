"""What a test must not leave behind."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager

import shiboken6
from PySide6.QtCore import QCoreApplication, QEvent, QThread, QTimer
from PySide6.QtWidgets import QApplication, QWidget


def left_alive() -> list[str]:
    """Name the windows and running threads that there are."""
    if QApplication.instance() is None:
        return []
    gc.collect()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    running = [
        thread
        for thread in shiboken6.getAllValidWrappers()
        if isinstance(thread, QThread) and thread.isRunning() and thread != QThread.currentThread()
    ]
    return [repr(widget) for widget in QApplication.topLevelWidgets()] + [repr(thread) for thread in running]


@contextmanager
def every_dialog_answered(patience: int) -> Iterator[None]:
    """Close dialogs that have been open for so many milliseconds, and fail: a test would wait for ever."""
    closed: list[str] = []
    before: QWidget | None = None

    def close() -> None:
        nonlocal before
        dialog = QApplication.activeModalWidget()
        if dialog is not None and dialog is before:
            closed.append(f"{type(dialog).__name__} {dialog.windowTitle()!r}")
            dialog.close()
        before = dialog

    timer = QTimer(interval=patience)
    timer.timeout.connect(close)
    timer.start()
    try:
        yield
    finally:
        timer.stop()
        assert not closed, f"nobody answered {closed}"
