"""The state folder on real disks: full, read-only, gone. What was kept stays, the rest is tried again."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.recovery import keeper as keeping
from app.recovery.keeper import Keeper
from app.recovery.places import kept_records, state_folder
from app.recovery.record import read_record
from app.session import Session
from starskel import Polygon, StarskelError
from tests.app.program import program
from tests.disks import filled, read_only, small_disk


@pytest.fixture
def said(session: Session, monkeypatch: pytest.MonkeyPatch) -> Iterator[list[StarskelError | None]]:
    """What is said of keeping the session's document."""
    monkeypatch.setattr(keeping, "DELAY", 50)
    keeper = Keeper(session)
    said: list[StarskelError | None] = []
    keeper.failed.connect(said.append)
    yield said
    keeper.close()


def drawn(session: Session, side: float) -> None:
    session.store(session.document.draw("source", Polygon([(0, 0), (side, 0), (0, side)])), "Draw")


def kept() -> list[float]:
    """Give what of the documents is in the state folder: how long their sides are."""
    paths = (state_folder() / "recovery").glob("*.json")
    return [float(read_record(path).project.shapes[0].rings[0].vertices.max()) for path in paths]


def test_on_a_full_disk_what_was_kept_stays_until_there_is_room(
    session: Session, said: list[StarskelError | None], qtbot: QtBot
) -> None:
    with small_disk(state_folder().parent) as disk:
        drawn(session, 1)
        qtbot.waitUntil(lambda: kept() == [1])
        with filled(disk):
            drawn(session, 2)
            qtbot.waitUntil(lambda: len(said) == 1)
            assert "No space left on device" in str(said[0])
            assert kept() == [1]
        qtbot.waitUntil(lambda: kept() == [2])
        assert said[1:] == [None]
        assert kept_records() == (), "still held"


def test_where_a_disk_was_full_from_the_start_the_document_is_held_when_there_is_room(
    session: Session, said: list[StarskelError | None], qtbot: QtBot
) -> None:
    with small_disk(state_folder().parent) as disk:
        (state_folder() / "recovery").mkdir(parents=True)
        with filled(disk):
            drawn(session, 1)
            qtbot.waitUntil(lambda: len(said) == 1)
        qtbot.waitUntil(lambda: kept() == [1])
        assert kept_records() == (), "no other window is offered it"


def test_on_a_read_only_disk_it_is_said_why(
    session: Session, said: list[StarskelError | None], qtbot: QtBot
) -> None:
    with small_disk(state_folder().parent) as disk:
        read_only(disk)
        drawn(session, 1)
        qtbot.waitUntil(lambda: len(said) == 1)
        assert "Read-only file system" in str(said[0])


def test_a_state_folder_that_has_gone_is_made_again(
    session: Session, said: list[StarskelError | None], qtbot: QtBot
) -> None:
    drawn(session, 1)
    qtbot.waitUntil(lambda: kept() == [1])
    shutil.rmtree(state_folder())
    drawn(session, 2)
    qtbot.waitUntil(lambda: kept() == [2])
    assert kept_records() == (), "still held"


def test_the_program_starts_and_ends_well_where_nothing_can_be_kept(tmp_path: Path) -> None:
    with small_disk(tmp_path / "state") as disk, filled(disk):
        done = program(disk, "QTimer.singleShot(0, window.close)")
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
