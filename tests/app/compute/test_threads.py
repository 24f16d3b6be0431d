"""Threads have a name before they start, so that PySide is not asked for one in the new thread."""

import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QObject, QThread

import app
from app.compute.computer import Computer
from app.compute.errands import Errands
from app.compute.morphs import Morphs


@pytest.mark.parametrize("kind", [Computer, Errands, Morphs])
def test_every_thread_has_a_name(qapp, kind: type[Computer | Errands | Morphs]) -> None:  # type: ignore[no-untyped-def]
    parent = QObject()
    owner = kind(parent)
    names = [thread.objectName() for thread in owner.findChildren(QThread)]
    owner.close()
    assert len(names) == 1
    assert all(names)


def test_threads_are_made_in_one_place() -> None:
    root = Path(app.__file__).parent
    making = [path.name for path in root.rglob("*.py") if "QThread(" in path.read_text("utf-8")]
    assert making == ["threads.py"]


THREADS = """
from PySide6.QtCore import QRunnable, QThreadPool
import starskel
from tests.families import articulated

class Work(QRunnable):
    def run(self):
        blend = starskel.blend(starskel.match(*articulated(1), marks=[(0, 0)]), method="{method}")
        starskel.measure(blend)

for _ in range(2):
    QThreadPool.globalInstance().start(Work())
    QThreadPool.globalInstance().waitForDone()
print("done")
"""


@pytest.mark.parametrize("method", ["stitched", "rigid", "certified"])
def test_blends_may_be_made_in_threads_of_qt(method: str) -> None:
    """Python knows nothing of such a thread before, and forgets it when a call ends."""
    code = [sys.executable, "-c", THREADS.format(method=method)]
    ended = subprocess.run(code, capture_output=True, text=True, check=False, timeout=60)
    assert (ended.returncode, ended.stdout, ended.stderr) == (0, "done\n", "")
