"""How late a timer of the interface gets while a large pair is decomposed and stitched in a thread."""

import time

import numpy as np
from PySide6.QtCore import QCoreApplication, Qt, QThread, QTimer

import starskel
from tests.benchmarks.decomposing import paired
from tests.benchmarks.timing import table
from tests.families import blob, spiral

STEP = 16
"""Milliseconds between two frames."""


class Work(QThread):
    """Set up stitched blends of two thousand vertices."""

    def run(self) -> None:
        for source, target in ((blob(2000, 1), blob(2000, 2)), (blob(2000, 5), spiral(2000, 2))):
            starskel.blend(paired(source, target), method="stitched")


def lateness() -> None:
    application = QCoreApplication.instance() or QCoreApplication([])
    ticks: list[float] = []
    timer = QTimer()
    timer.setTimerType(Qt.TimerType.PreciseTimer)
    timer.timeout.connect(lambda: ticks.append(time.perf_counter()))
    timer.start(STEP)
    work = Work()
    work.finished.connect(application.quit)
    work.start()
    application.exec()
    work.wait()
    late = np.diff(ticks) * 1e3 - STEP
    row = (len(late), float(np.median(late)), float(np.percentile(late, 99)), float(late.max()))
    table(
        f"A timer of {STEP} ms while 2,000 vertices are computed",
        ("ticks", "median late", "p99 late", "most"),
        [row],
    )
