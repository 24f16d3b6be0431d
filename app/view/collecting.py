"""Garbage is collected in the window's thread only.

A widget that is part of a cycle is destroyed where the cycle is found. Python looks for cycles in whatever
thread happens to allocate, and a widget destroyed in the worker's thread ends the program.
"""

import gc
from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QTimer

INTERVAL = 100
"""Milliseconds between two looks; what a busy worker leaves in that time is collected in less than one."""


@contextmanager
def collecting_here() -> Iterator[None]:
    """Have the event loop of this thread collect garbage, and no other thread.

    What is loaded by now is never looked at again: it stays, and going through it costs two frames.
    """
    gc.disable()
    gc.freeze()
    timer = QTimer(interval=INTERVAL)
    timer.timeout.connect(collect_where_due)
    timer.start()
    try:
        yield
    finally:
        timer.stop()
        gc.unfreeze()
        gc.enable()


def collect_where_due() -> None:
    """Collect the oldest generation that Python would collect by now, were it not switched off."""
    due = [count > threshold for count, threshold in zip(gc.get_count(), gc.get_threshold(), strict=True)]
    if any(due):
        gc.collect(max(generation for generation, is_due in enumerate(due) if is_due))
