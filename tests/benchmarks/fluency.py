"""How late a timer of the interface gets while a large pair is decomposed and stitched in a thread."""

import time

import numpy as np
from PySide6.QtCore import QCoreApplication, Qt, QThread, QTimer

import starskel
from tests.benchmarks.decomposing import paired
from tests.benchmarks.timing import table
from tests.families import blob, spiral, two_opt

STEP = 16
"""Milliseconds between two frames."""


PAIRS = {
    "smooth": lambda n: (blob(n, 1), blob(n, 2)),
    "rolled": lambda n: (blob(n, 5), spiral(n, 2)),
    "random": lambda n: (two_opt(n, 1), two_opt(n, 1001)),
}


class Work(QThread):
    """Set up the stitched blend of a pair."""

    def __init__(self, pair: starskel.Correspondence) -> None:
        super().__init__()
        self.setObjectName("blending")  # else Qt asks the class for a name, in the thread, without the lock
        self.pair = pair

    def run(self) -> None:
        starskel.blend(self.pair, method="stitched")


def lateness() -> None:
    application = QCoreApplication.instance() or QCoreApplication([])
    rows = []
    for kind, shapes in PAIRS.items():
        late = _lateness(application, Work(paired(*shapes(2000))))
        rows.append(
            (kind, len(late), float(np.median(late)), float(np.percentile(late, 99)), float(late.max()))
        )
    title = f"A timer of {STEP} ms while 2,000 vertices are computed"
    table(title, ("shapes", "ticks", "median late", "p99 late", "most"), rows)


def _lateness(application: QCoreApplication, work: Work):
    ticks: list[float] = []
    timer = QTimer()
    timer.setTimerType(Qt.TimerType.PreciseTimer)
    timer.timeout.connect(lambda: ticks.append(time.perf_counter()))
    timer.start(STEP)
    work.finished.connect(application.quit)
    work.start()
    application.exec()
    work.wait()
    return np.diff(ticks) * 1e3 - STEP
