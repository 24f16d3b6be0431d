"""A file of pairs that have names: each pair is checked when it is asked for."""

import difflib
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Generic, Protocol, TypeVar

from starskel.errors import InvalidFile, told

IMAGE_PAIRS = "image-pairs/1"
"""The format of files of pairs of pictures: named here, as what reads them takes long to load."""


class Named(Protocol):
    """What stands in a file under a name."""

    @property
    def id(self) -> str:
        """The name, unique in its file."""


Entry = TypeVar("Entry", bound=Named)
Pair = TypeVar("Pair")


class PairFile(Generic[Pair]):
    """The pairs of one file; each pair is checked when it is asked for, so that one bad pair spoils no other.

    Parameters
    ----------
    path : Path
        The file.
    entries : iterable of Entry
        What stands in it.
    check : callable
        Makes a pair of an entry, or raises InvalidFile.

    Attributes
    ----------
    path : Path
    ids : tuple of str
        The names of its pairs, in the file's order.

    Raises
    ------
    InvalidFile
        If there is no pair, or two have one name.
    """

    def __init__(self, path: Path, entries: Iterable[Entry], check: Callable[[Entry], Pair]) -> None:
        found = _by_name(path, entries)
        self.path = path
        self.ids = tuple(found)
        self._checks = {name: partial(check, entry) for name, entry in found.items()}

    def pair(self, pair_id: str) -> Pair:
        """Give the pair of this name.

        Raises
        ------
        InvalidFile
            If there is none, naming the nearest ones, or if what stands there is invalid.
        """
        if pair_id not in self.ids:
            raise InvalidFile(
                told('{path} has no pair "{name}"', path=self.path, name=pair_id),
                told("choose one of {names}", names=", ".join(self._near(pair_id))),
            )
        return self._checks[pair_id]()

    def _near(self, name: str) -> list[str]:
        by_lower_case = {known.lower(): known for known in self.ids}
        near = difflib.get_close_matches(name.lower(), by_lower_case, n=3, cutoff=0.4)
        return [by_lower_case[known] for known in near] or list(self.ids[:8])


def _by_name(path: Path, entries: Iterable[Entry]) -> dict[str, Entry]:
    found: dict[str, Entry] = {}
    for entry in entries:
        if entry.id in found:
            raise InvalidFile(
                told('{path} has two pairs "{name}"', path=path, name=entry.id), told("rename one of them")
            )
        found[entry.id] = entry
    if not found:
        raise InvalidFile(told("{path} holds no pair", path=path), told("give a file with at least one pair"))
    return found
