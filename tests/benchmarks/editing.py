"""How soon the editor answers: a vertex dragged, the slider moved, the window opened."""

import os
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QCoreApplication, QEvent, QEventLoop
from PySide6.QtWidgets import QApplication

import starskel
from app.session import Session
from app.tools.tool import Pointer
from app.view.collecting import collecting_here
from app.view.main_window import MainWindow
from app.view.painting.theme import LIGHT, apply_theme
from starskel.files.pairs import ShapePair
from starskel.files.projects.project import Project
from starskel.polygon import Polygon
from tests.benchmarks.timing import table
from tests.families import blob

METHODS = ("stitched", "rigid", "star-skeleton", "edge-angle")
LATENCY = 120
"""Milliseconds from moving a vertex to a fresh stitched blend, at 100 vertices."""

FRAME = {200: 16, 1000: 33}
"""Milliseconds from moving the slider to all panels painted, by the number of vertices."""

START = 1200
"""Milliseconds from starting the program to a window that answers."""

BARE = """
import time
from PySide6.QtWidgets import QApplication
QApplication([])
print(time.time())
"""
OPENED = """
import time
from PySide6.QtCore import QTimer
from app.view import start

def answer(window):
    print(time.time())
    window.close()

start.MainWindow.showEvent = lambda window, event: QTimer.singleShot(0, lambda: answer(window))
start.run(None)
"""


class Editor:
    """A window with a pair of blobs, offscreen."""

    def __init__(self, vertices: int) -> None:
        self.window = MainWindow(Session())
        self.window.show()
        source, target = (Polygon(blob(vertices, seed)) for seed in (1, 2))
        marks = starskel.suggest_marks(source, target, 6)
        project = Project.of(ShapePair("", source, target, tuple(marks)))
        self.window.session.show_project(replace(project, methods=METHODS))
        self.settle()

    def settle(self) -> None:
        while self.window.session.blends.busy:
            wait()

    def close(self) -> None:
        self.window.session.new()
        self.window.close()
        self.window.deleteLater()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def now() -> tuple[float, float]:
    return time.perf_counter(), time.process_time()


def since(begun: tuple[float, float]) -> tuple[float, float]:
    wall, own = now()
    return wall - begun[0], own - begun[1]


def wait() -> None:
    """Let the window do what there is to do, and sleep until there is more: the worker needs the time."""
    QCoreApplication.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)


def editing(most: int) -> None:
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    application = QApplication.instance() or QApplication([])
    assert isinstance(application, QApplication)
    apply_theme(application, LIGHT)
    with collecting_here():
        dragging(100)
        for vertices, least in FRAME.items():
            if vertices <= most:
                sliding(vertices, least)
    starting()


def dragging(vertices: int, moves: int = 25) -> None:
    """Move a vertex, and wait each time until the stitched blend follows."""
    editor = Editor(vertices)
    session = editor.window.session
    x, y = session.document.vertices("source")[0].tolist()
    session.press(Pointer("source", (x, y), 0.3))
    took = []
    for k in range(1, moves + 1):
        begun = now()
        session.move(Pointer("source", (x + 0.02 * k, y + 0.01 * k), 0.3))
        while session.blends.results["stitched"].stale:
            wait()
        took.append(since(begun))
        editor.settle()
    session.cancel()
    editor.close()
    _report(f"From moving one of {vertices} vertices to a fresh stitched blend", took, LATENCY)


def sliding(vertices: int, least: float) -> None:
    """Move the slider, and wait each time until all panels are painted."""
    editor = Editor(vertices)
    slider = editor.window.timeline.slider
    took = []
    for value in np.random.default_rng(1).integers(0, 1001, 80).tolist():
        begun = now()
        slider.setValue(value)
        QCoreApplication.processEvents()
        took.append(since(begun))
    editor.close()
    _report(f"From moving the slider to {len(METHODS)} panels painted, {vertices} vertices", took, least)


def starting(runs: int = 3) -> None:
    """Start the program; beside it a program that only starts Qt."""
    bare, opened = (min(_started(code) for _ in range(runs)) for code in (BARE, OPENED))
    heads = ("bare Qt ms", "window ms", "times bare", "of target")
    table("Cold start to a window that answers", heads, [(bare, opened, opened / bare, opened / START)])


def _started(code: str) -> float:
    """Give the milliseconds until a program says that it is ready."""
    begun = time.time()
    surroundings = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    ready = subprocess.run(
        [sys.executable, "-c", code],
        check=True,
        env=surroundings,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    return 1e3 * (float(ready.stdout) - begun)


def _report(title: str, took: list[tuple[float, float]], target: float) -> None:
    """Print wall time, and the processor's time, which is steadier where others use the machine, too."""
    wall, own = np.array(took).T * 1e3
    row = (len(took), *(float(f) for f in (np.median(wall), np.percentile(wall, 95), np.percentile(own, 95))))
    heads = ("times", "median ms", "p95 ms", "own p95 ms", "p95 of target", "own of target")
    table(title, heads, [(*row, row[2] / target, row[3] / target)])
