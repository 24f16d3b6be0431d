"""The journal of a batch: a line for each finished job, on the disk before the next one counts."""

import os
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from types import TracebackType

import msgspec

from starskel.command.batches.work import Outcome
from starskel.errors import InvalidFile
from starskel.files.disk import made_folder, write_bytes
from starskel.files.documents import read_document, write_document

FORMAT = "starskel-batch/1"

RESULTS = "results.jsonl"


class Terms(msgspec.Struct, frozen=True):
    """What all results of a batch have in common."""

    format: str
    methods: list[str]
    frames: int


class Journal:
    """The results of a batch in a folder; used as a context, in which no other batch may write there.

    Attributes
    ----------
    outcomes : dict of str to Outcome
        What is finished, by key; a line that was being written when the program was ended is not.
    """

    def __init__(self, folder: Path, terms: Terms) -> None:
        self._folder = made_folder(folder)
        self._path = folder / RESULTS
        self._terms = terms
        self.outcomes: dict[str, Outcome] = {}

    def __enter__(self) -> "Journal":
        with ExitStack() as held:
            held.enter_context(_locked(self._folder))
            self._check()
            self._read()
            self._stream = self._path.open("ab")
            self._held = held.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with self._held:
            self._stream.close()

    def _read(self) -> None:
        content = self._path.read_bytes() if self._path.exists() else b""
        whole = content[: content.rfind(b"\n") + 1]
        outcomes = [_outcome(self._path, number, line) for number, line in enumerate(whole.splitlines(), 1)]
        self.outcomes = {outcome.key: outcome for outcome in outcomes}
        if whole != content or len(self.outcomes) < len(outcomes):
            self._rewrite()

    def add(self, outcome: Outcome) -> None:
        """Keep an outcome; afterwards it outlives a failure of the power."""
        self._stream.write(_line(outcome))
        self._stream.flush()
        os.fsync(self._stream.fileno())
        self.outcomes[outcome.key] = outcome

    def drop(self, keys: Iterable[str]) -> None:
        """Forget outcomes, so that their jobs are done again."""
        gone = [key for key in keys if self.outcomes.pop(key, None) is not None]
        if gone:
            self._stream.close()
            self._rewrite()
            self._stream = self._path.open("ab")

    def _rewrite(self) -> None:
        write_bytes(self._path, b"".join(map(_line, self.outcomes.values())))

    def _check(self) -> None:
        path = self._folder / "batch.json"
        if not path.exists():
            write_document(path, self._terms)
            return
        known = read_document(path, Terms)
        if known.format != self._terms.format:
            raise InvalidFile(
                f'{path} has the format "{known.format}"',
                "give another folder, or open it with a newer starskel",
            )
        if known != self._terms:
            raise InvalidFile(
                f"{self._folder} holds a batch by {', '.join(known.methods)} at {known.frames} frames",
                "give the same methods and frames, or another folder",
            )


def _line(outcome: Outcome) -> bytes:
    return msgspec.json.encode(outcome) + b"\n"


def _outcome(path: Path, number: int, line: bytes) -> Outcome:
    try:
        return msgspec.json.decode(line, type=Outcome)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise InvalidFile(f"{path}: line {number} is damaged: {error}", "delete this line") from error


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """Take the folder for this process, until it is left or the process ends.

    The file that stands for it stays: were it removed, another process might hold it, and a third a new one.
    """
    try:
        import fcntl  # noqa: PLC0415 -- not on every system; elsewhere nothing is locked
    except ImportError:
        yield
        return
    with (folder / ".lock").open("ab") as stream:  # were it a link, nothing would be lost
        try:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise InvalidFile(
                f"another batch is writing to {folder}", "wait for it, or give another folder"
            ) from error
        yield
