"""What a test must not leave behind."""

import gc

import shiboken6
from PySide6.QtCore import QCoreApplication, QEvent, QThread
from PySide6.QtWidgets import QApplication


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
