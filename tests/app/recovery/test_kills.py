"""Killed at random moments of editing and saving: every file opens, and only the last seconds are lost."""

import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from random import Random

import pytest
from PySide6.QtCore import QCoreApplication

from app.recovery.places import kept_records
from app.recovery.record import Record
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import read_project
from tests.app.recovery.victim import number_of

LOST = 5.0
"""Seconds of work that may be lost, at most."""

LONGEST = 9.0
"""Seconds after which a program is killed at the latest: long enough for what is older than may be lost."""

ROOT = Path(__file__).parents[3]


@dataclass(frozen=True)
class Said:
    """What a program said it had done: when, "edit" or "save", which."""

    time: float
    kind: str
    number: int


def killed(path: Path, seed: int, seconds: float) -> tuple[list[Said], float]:
    """Kill a program so many seconds after its first edit; give what it said, and when it was killed."""
    said = path.with_suffix(".said")
    command = [sys.executable, "-m", "tests.app.recovery.victim", str(path), str(seed)]
    with said.open("w") as stream, subprocess.Popen(command, cwd=ROOT, stdout=stream) as program:
        while not said.stat().st_size:
            time.sleep(0.01)
            assert program.poll() is None
        time.sleep(seconds)
        moment = time.monotonic()
        program.kill()
    assert program.returncode == -signal.SIGKILL
    whole = said.read_text().rpartition("\n")[0]  # it may have been killed in the middle of the last line
    words = [line.split() for line in whole.splitlines()]
    return [Said(float(when), kind, int(number)) for when, kind, number in words], moment


def last(said: list[Said], kind: str, until: float) -> int:
    """Give the number of the last edit, or save, until some moment; 0 if there was none."""
    return max((each.number for each in said if each.kind == kind and each.time <= until), default=0)


def number_in(project: Project) -> int:
    return number_of(project.shapes[0].rings[0])


@pytest.mark.endurance(usual=5, long=200)
def test_a_program_that_is_killed_loses_no_more_than_the_last_seconds(
    qapp: QCoreApplication, tmp_path: Path, rounds: int
) -> None:
    random = Random(8)
    for seed in range(rounds):
        path = tmp_path / f"{seed}.json"
        said, moment = killed(path, seed, random.uniform(0, LONGEST))
        in_file = number_in(read_project(path)) if path.exists() else 0
        assert in_file >= last(said, "save", moment)
        offered = kept_records()
        assert len(offered) <= 1
        best = in_file
        for each in offered:
            assert isinstance(each.record, Record), each.record
            best = max(best, number_in(each.record.project))
            each.place.clear()
        assert best >= last(said, "edit", moment - LOST)
        assert best <= last(said, "edit", moment) + 1
    print(len(list(tmp_path.glob("*.partial"))), "of", rounds, "were killed while they wrote their file")
