"""Threads have a name before they start, so that PySide is not asked for one in the new thread."""

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
