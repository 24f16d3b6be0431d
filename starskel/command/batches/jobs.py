"""Jobs: what is to be done, found in a folder or a file, or named by a manifest."""

import hashlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import msgspec

from starskel.command.holdings import holdings, pair_of
from starskel.command.opening import opened
from starskel.errors import InvalidFile, StarskelError
from starskel.files import multi_pairs, pairs
from starskel.files.disk import read_bytes
from starskel.files.documents import format_of
from starskel.files.pair_file import IMAGE_PAIRS
from starskel.files.projects import project_document
from starskel.files.projects.project import AnyPair
from starskel.reading.readers import ENDINGS

_KNOWN = (pairs.FORMAT, multi_pairs.FORMAT, IMAGE_PAIRS, project_document.FORMAT)


@dataclass(frozen=True)
class Job:
    """A pair to be blended and measured.

    Attributes
    ----------
    key : str
        The pair's name in the batch: its file and its name there.
    digest : str
        Of the files' content: results of other content are out of date.
    load : callable
        Gives the pair, or raises StarskelError.
    """

    key: str
    digest: str
    load: Callable[[], AnyPair]


class _Line(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A line of a manifest: a file, or one pair of it, or two drawings."""

    file: str = ""
    id: str = ""
    source: str = ""
    target: str = ""


def jobs_of(place: Path) -> Iterator[Job]:
    """Give the jobs of a folder, a file of pairs or a project, or a manifest.

    Of a folder these are all files of pairs and projects in it; a manifest has a line of JSON for each job.

    Raises
    ------
    InvalidFile
        If there is no such place, or a line of the manifest is wrong, naming it.
    """
    if place.is_dir():
        for path in sorted(place.rglob("*.json")):
            if _is_known(path):
                yield from _file_jobs(path, path.relative_to(place).as_posix())
    elif _is_known(place):
        yield from _file_jobs(place, place.name)
    else:
        yield from _listed_jobs(place)


def _listed_jobs(place: Path) -> Iterator[Job]:
    """Give the jobs of a manifest."""
    for number, line in enumerate(read_bytes(place).splitlines(), 1):
        if not line.strip():
            continue
        try:
            entry = msgspec.json.decode(line, type=_Line)
            if bool(entry.file) == bool(entry.source and entry.target):
                raise msgspec.ValidationError('neither "file" nor "source" and "target"')
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            raise InvalidFile(
                f"{place}: line {number}: {error}",
                'write lines like {"file": "a.json", "id": "x"} or {"source": "a.svg", "target": "b.svg"}',
            ) from error
        if entry.file:
            yield from _file_jobs(place.parent / entry.file, entry.file, entry.id)
        else:
            yield _drawn_job(place.parent, entry)


def _is_known(path: Path) -> bool:
    try:
        return format_of(path) in _KNOWN
    except InvalidFile:
        return False


def _file_jobs(path: Path, name: str, pair_id: str = "") -> Iterator[Job]:
    """Give the jobs of a file; one that cannot be opened is a job that fails."""
    digest = ""
    try:
        digest = _digest(path)
        file = opened(path)
    except StarskelError as error:
        yield Job(f"{name}#{pair_id}" if pair_id else name, digest, _failing(error))
        return
    for own in [pair_id] if pair_id else file.ids:
        yield Job(f"{name}#{own}", digest, partial(file.pair, own))


def _drawn_job(folder: Path, entry: _Line) -> Job:
    paths = [folder / entry.source, folder / entry.target]
    key = f"{entry.source} > {entry.target}"
    try:
        digest = _digest(*paths)
    except StarskelError as error:
        return Job(key, "", _failing(error))
    return Job(key, digest, partial(_drawn_pair, key, paths))


def _drawn_pair(key: str, paths: Sequence[Path]) -> AnyPair:
    """Give the first shapes of two drawings as a pair."""
    for path in paths:
        if path.suffix.lower() not in ENDINGS:
            raise InvalidFile(f"{path} is no drawing", f"give a file that ends in {', '.join(ENDINGS)}")
    source, target = (holdings(path).shapes[0].shape for path in paths)
    return pair_of(key, source, target)


def _failing(error: StarskelError) -> Callable[[], AnyPair]:
    def fail() -> AnyPair:
        raise error

    return fail


def _digest(*paths: Path) -> str:
    content = hashlib.sha256()
    for path in paths:
        content.update(read_bytes(path))
    return content.hexdigest()[:16]
