"""Opening, computing and quitting, in mid-computation too: it always ends well, and leaves nothing."""

import shutil
from pathlib import Path
from random import Random

import pytest

from starskel.files.projects.examples import example_names
from tests.app.program import program

LONGEST = 1500
"""Milliseconds after which the window is closed at the latest; by then most examples are computed."""

LOADING = ("", "import app.compute.job")
"""What computes is loaded while the program may end, or before, so that it hides no fall of references."""

CODE = """
import gc
from PySide6.QtWidgets import QApplication
{loading}
def references():
    gc.collect()
    return sys.getrefcount(None)
before = references()
QApplication.instance().aboutToQuit.connect(lambda: print(before, references()))
window.files.open_example({name!r})
QTimer.singleShot({wait}, window.close)
"""


@pytest.mark.endurance(usual=4, long=500)
def test_quitting_at_any_moment_ends_with_status_0_and_leaves_nothing(tmp_path: Path, rounds: int) -> None:
    random = Random(8)
    gains: list[int] = []
    for number in range(rounds):
        name, wait = random.choice(example_names()), random.choice([0, random.randrange(LONGEST)])
        state = tmp_path / str(number)
        done = program(state, CODE.format(loading=LOADING[number % 2], name=name, wait=wait))
        assert done.returncode == 0, (name, wait, done.stderr)
        assert not complaints(done.stderr), (name, wait)
        assert "ends" in (state / "starskel" / "crashes.log").read_text()
        assert not list((state / "starskel").glob("recovery/*"))
        before, after = map(int, done.stdout.split())
        assert after >= before, (name, wait, "references to None are lost")
        gains.append(after - before)
        shutil.rmtree(state)
    print("references to None grew by", min(gains[1::2]), "to", max(gains[1::2]))


def complaints(errors: str) -> list[str]:
    """Give what was said, but for what means nothing without a screen."""
    return [line for line in errors.splitlines() if not line.startswith("This plugin does not support")]
