"""Where records lie: in the state folder, each with a lock that ends with the program that holds it."""

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from uuid import uuid4

from PySide6.QtCore import QLockFile, QStandardPaths

from app.recovery.record import Record, read_record
from starskel.errors import InvalidFile, StarskelError, told
from starskel.files.disk import clear_leftovers, made_folder

ENDING = ".json"


def state_folder() -> Path:
    """Give the folder for what the program keeps for itself; it may not exist yet."""
    return Path(
        QStandardPaths.writableLocation(QStandardPaths.StandardLocation.GenericStateLocation), "starskel"
    )


class Place:
    """A file for one document's record, which one window at a time holds."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._lock_path = path.with_suffix(".lock")
        self._lock = QLockFile(str(self._lock_path))
        self._lock.setStaleLockTime(
            0
        )  # however old: a lock ends with its program, of which Qt keeps the number

    @classmethod
    def new(cls) -> "Place":
        """Give a place that nobody else has.

        Raises
        ------
        InvalidFile
            If the state folder cannot be made, or nothing be written there.
        """
        place = cls(made_folder(_folder()) / f"{uuid4().hex}{ENDING}")
        if not place.claim():
            raise InvalidFile(
                told("nothing can be written in {path}", path=place.path.parent),
                told("make room on its disk, and let files be written there"),
            )
        return place

    @property
    def held(self) -> bool:
        """Whether the place is still there and held; it is not where its folder was removed."""
        return self._lock_path.exists()

    def claim(self) -> bool:
        """Hold the place; False where another window does."""
        return self._lock.tryLock(0)

    def release(self) -> None:
        """Leave the record to whoever comes next."""
        self._lock.unlock()

    def clear(self) -> None:
        """Do away with the record."""
        self.path.unlink(missing_ok=True)
        self._lock.unlock()


@dataclass(frozen=True)
class Kept:
    """A record that no window holds any more.

    Attributes
    ----------
    place : Place
        Held by whoever asked.
    time : datetime
        When it was written.
    record : Record or StarskelError
        What is in it, or why it cannot be read.
    """

    place: Place
    time: datetime
    record: Record | StarskelError

    @property
    def readable(self) -> bool:
        """Whether there is a document in it."""
        return isinstance(self.record, Record)


def any_records() -> bool:
    """Tell at once whether there are any records, held or not."""
    return any(_folder().glob(f"*{ENDING}"))


def kept_records() -> tuple[Kept, ...]:
    """Claim all records that no window holds, and give them, the newest first, the unreadable last."""
    clear_leftovers(_folder())
    places = [Place(path) for path in _folder().glob(f"*{ENDING}")]
    found = [_kept(place) for place in places if place.claim()]
    return tuple(sorted(filter(None, found), key=lambda kept: (kept.readable, kept.time), reverse=True))


def _kept(place: Place) -> Kept | None:
    if not place.path.exists():  # cleared by the window that held it
        place.release()
        return None
    time = datetime.fromtimestamp(place.path.stat().st_mtime).astimezone()
    try:
        return Kept(place, time, read_record(place.path))
    except StarskelError as error:
        return Kept(place, time, error)


def _folder() -> Path:
    return state_folder() / "recovery"
