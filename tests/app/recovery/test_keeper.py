"""Keeping unsaved work, with a real session and a real state folder; crashes are real, too."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.model.filing import Filed
from app.recovery import keeper as keeping
from app.recovery.keeper import Keeper
from app.recovery.places import Place, kept_records, state_folder
from app.recovery.record import Record, read_record, write_record
from app.session import Session
from starskel import Polygon, StarskelError
from starskel.files.projects.examples import example
from starskel.files.projects.project_file import read_project
from tests.app.driver import save

SQUARE = Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def keeper(session: Session, monkeypatch: pytest.MonkeyPatch) -> Iterator[Keeper]:
    monkeypatch.setattr(keeping, "DELAY", 50)
    keeper = Keeper(session)
    yield keeper
    keeper.close()


def drawn(session: Session, polygon: Polygon = SQUARE) -> None:
    session.store(session.document.draw("source", polygon), "Draw")


def block_state_folder() -> None:
    state_folder().parent.mkdir(parents=True, exist_ok=True)
    state_folder().write_text("a file where the folder should be")


def files() -> list[Path]:
    return sorted((state_folder() / "recovery").glob("*.json"))


def test_a_change_is_kept_soon_and_done_away_with_when_it_is_saved(
    session: Session, keeper: Keeper, qtbot: QtBot, tmp_path: Path
) -> None:
    assert not files()
    drawn(session)
    qtbot.waitUntil(lambda: len(files()) == 1)
    assert read_record(files()[0]).project.shapes[0].rings == (SQUARE,)
    save(session, tmp_path / "a.json")
    qtbot.waitUntil(lambda: not files())


def test_later_changes_go_to_the_same_file_and_undoing_all_leaves_nothing(
    session: Session, keeper: Keeper, qtbot: QtBot
) -> None:
    drawn(session)
    qtbot.waitUntil(lambda: len(files()) == 1)
    (first,) = files()
    drawn(session, Polygon([(0, 0), (5, 0), (0, 5)]))
    qtbot.waitUntil(lambda: len(read_record(first).project.shapes[0].rings[0]) == 3)
    assert files() == [first]
    session.undo()
    session.undo()
    qtbot.waitUntil(lambda: not files())


def test_another_document_does_away_with_the_record(session: Session, keeper: Keeper, qtbot: QtBot) -> None:
    drawn(session)
    qtbot.waitUntil(lambda: len(files()) == 1)
    session.new()
    qtbot.waitUntil(lambda: not files())


def test_a_record_tells_its_file_and_opens_as_a_project(
    session: Session, keeper: Keeper, tmp_path: Path
) -> None:
    path = tmp_path / "a.json"
    session.show_project(example("arm"))
    save(session, path)
    drawn(session)
    assert keeper.keep_now()
    record = read_record(files()[0])
    assert record.file == session.file == Filed.now(path)
    assert read_project(files()[0]) == record.project


def test_closing_leaves_nothing(session: Session) -> None:
    keeper = Keeper(session)
    drawn(session)
    assert keeper.keep_now()
    assert len(files()) == 1
    keeper.close()
    assert list((state_folder() / "recovery").iterdir()) == []


def test_what_a_window_holds_is_not_offered_to_others(session: Session, keeper: Keeper) -> None:
    drawn(session)
    keeper.keep_now()
    assert kept_records() == ()


def test_where_nothing_can_be_kept_it_is_said_once_and_taken_back(
    session: Session, keeper: Keeper, qtbot: QtBot
) -> None:
    block_state_folder()
    said: list[StarskelError | None] = []
    keeper.failed.connect(said.append)
    for side in (5, 6, 7):
        drawn(session, Polygon([(0, 0), (side, 0), (0, side)]))
        assert not keeper.keep_now()
    state_folder().unlink()
    drawn(session)
    assert keeper.keep_now()
    qtbot.waitUntil(lambda: len(said) == 2)
    assert "cannot be made a folder" in str(said[0])
    assert said[1] is None


def test_what_could_not_be_kept_is_kept_as_soon_as_it_can_be(
    session: Session, keeper: Keeper, qtbot: QtBot
) -> None:
    block_state_folder()
    drawn(session)
    with qtbot.waitSignal(keeper.failed):
        pass
    state_folder().unlink()
    qtbot.waitUntil(lambda: len(files()) == 1)
    assert read_record(files()[0]).project.shapes[0].rings == (SQUARE,)


def test_nothing_more_is_tried_when_the_document_is_given_up(
    session: Session, keeper: Keeper, qtbot: QtBot
) -> None:
    block_state_folder()
    drawn(session)
    with qtbot.waitSignal(keeper.failed):
        pass
    session.new()
    state_folder().unlink()
    qtbot.wait(200)  # four times as long as until the next try
    assert not files()


def test_what_a_killed_program_had_begun_to_write_is_cleared(session: Session, tmp_path: Path) -> None:
    old, young = (f".{letter * 16}.partial" for letter in "ab")
    recovery = state_folder() / "recovery"
    recovery.mkdir(parents=True)
    for folder in (recovery, tmp_path):
        for name in (old, young, ".mine.partial"):
            (folder / name).write_text("{")
        for name in (old, ".mine.partial"):
            os.utime(folder / name, (0, 0))
    kept_records()
    save(session, tmp_path / "a.json")
    left = {young, ".mine.partial"}
    assert {path.name for path in recovery.iterdir()} == left
    assert {path.name for path in tmp_path.iterdir() if path.is_file()} == left | {"a.json"}


def crashed(code: str = "") -> subprocess.CompletedProcess[str]:
    """Run a program that draws, keeps, and is killed."""
    program = f"""
import os, signal
from PySide6.QtCore import QCoreApplication
application = QCoreApplication([])
from app.recovery.keeper import Keeper
from app.session import Session
from starskel import Polygon
session = Session()
keeper = Keeper(session)
session.store(session.document.draw("source", Polygon({SQUARE.vertices.tolist()})), "Draw")
assert keeper.keep_now()
{code}
os.kill(os.getpid(), signal.SIGKILL)
"""
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)


def test_after_a_crash_the_record_is_offered_and_adopted(session: Session, keeper: Keeper) -> None:
    assert crashed().returncode == -signal.SIGKILL
    (kept,) = kept_records()
    assert isinstance(kept.record, Record)
    assert kept.record.project.shapes[0].rings == (SQUARE,)
    assert kept_records() == (), "claimed, so nobody else is offered it"
    session.show_project(kept.record.project, saved=False)
    keeper.adopt(kept.place)
    assert session.unsaved
    drawn(session, Polygon([(0, 0), (5, 0), (0, 5)]))
    keeper.keep_now()
    assert files() == [kept.place.path]
    assert len(read_record(kept.place.path).project.shapes[0].rings[0]) == 3


def test_what_is_left_for_later_is_offered_again(session: Session) -> None:
    crashed()
    for _ in range(2):
        (kept,) = kept_records()
        kept.place.release()
    (kept,) = kept_records()
    kept.place.clear()
    assert kept_records() == ()
    assert not files()


def test_a_damaged_record_is_named_and_left_where_it_is(session: Session) -> None:
    place = Place.new()
    place.path.write_text("{")
    place.release()
    (kept,) = kept_records()
    assert isinstance(kept.record, StarskelError)
    assert "damaged" in str(kept.record)
    kept.place.release()
    assert files() == [place.path]


@pytest.mark.parametrize("digest", [None, "0" * 64])
@pytest.mark.parametrize("origin", [None, Path("/somewhere/ä b.json")])
def test_records_are_the_same_after_writing_and_reading(
    tmp_path: Path, origin: Path | None, digest: str | None
) -> None:
    record = Record(example("arm"), origin and Filed(origin, digest))
    write_record(tmp_path / "record.json", record)
    assert read_record(tmp_path / "record.json") == record
