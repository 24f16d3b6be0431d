"""Threads of the program's own."""

from PySide6.QtCore import QObject, QThread


def thread_named(name: str, parent: QObject) -> QThread:
    """Give a thread that has a name before it starts.

    One without is named by Qt after its class, in the new thread. There PySide would put the class's
    description together without Python's lock, while the window is built: now and then that ends the program.
    """
    thread = QThread(parent)
    thread.setObjectName(name)
    return thread
