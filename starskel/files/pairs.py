"""Files of pairs of polygons, format polygon-pairs/1."""

import difflib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TypeVar

import msgspec

from starskel.correspondence.marks import Mark
from starskel.errors import InvalidFile, told
from starskel.files.documents import check_format, read_document, write_document
from starskel.files.shapes import Row, marked_shapes, polygon_of, rows_of
from starskel.polygon import Polygon

FORMAT = "polygon-pairs/1"


class Named(Protocol):
    """What has a name in a file."""

    @property
    def id(self) -> str:
        """The name."""


Entry = TypeVar("Entry", bound=Named)


class _Entry(msgspec.Struct, frozen=True, kw_only=True):
    id: str
    source: str = ""
    tags: list[str] = []
    p: list[Row]
    q: list[Row]
    marks: list[Mark] = []


class _Document(msgspec.Struct, frozen=True):
    format: str
    pairs: list[_Entry]


@dataclass(frozen=True)
class ShapePair:
    """Two polygons and their marks under a name.

    Attributes
    ----------
    id : str
        The name, unique in its file.
    source, target : Polygon
        The polygons.
    marks : tuple of (int, int)
        A vertex of the source, a vertex of the target.
    root : (float, float) or None
        The star origin of the source nearest to this place is the root of the star-skeleton.
    turns : int
        Whole turns that the star-skeleton makes besides, counter-clockwise.
    tags : tuple of str
        Words to find it by.
    origin : str
        Where the shapes come from, and their licence.
    description : str
        A sentence about the pair, where there is one.
    """

    id: str
    source: Polygon
    target: Polygon
    marks: tuple[Mark, ...] = ()
    root: tuple[float, float] | None = None
    turns: int = 0
    tags: tuple[str, ...] = ()
    origin: str = ""
    description: str = ""


class PairsFile:
    """The pairs of one file; each pair is checked when it is asked for, so that one bad pair spoils no other.

    Attributes
    ----------
    path : Path
        The file.
    ids : tuple of str
        The names of its pairs, in the file's order.
    """

    def __init__(self, path: Path, entries: Iterable[_Entry]) -> None:
        self.path = path
        self._entries = by_id(path, entries)
        self.ids = tuple(self._entries)

    def pair(self, pair_id: str) -> ShapePair:
        """Give the pair of this name.

        Raises
        ------
        InvalidFile
            If there is none, naming the nearest ones, or if its polygons or marks are invalid.
        """
        entry = entry_of(self.path, self._entries, pair_id)
        where = told('{path}: pair "{name}"', path=self.path, name=entry.id)
        source = polygon_of(entry.p, told("{where}: {what}", where=where, what=told("source (p)")))
        target = polygon_of(entry.q, told("{where}: {what}", where=where, what=told("target (q)")))
        source, target, marks = marked_shapes(source, target, entry.marks, where)
        return ShapePair(entry.id, source, target, marks, tags=tuple(entry.tags), origin=entry.source)


def read_pairs(path: Path) -> PairsFile:
    """Read a file of pairs.

    Raises
    ------
    InvalidFile
        If it cannot be read, is no file of pairs, or has no pair or two pairs of one name.
    """
    check_format(path, FORMAT)
    return PairsFile(path, read_document(path, _Document).pairs)


def by_id(path: Path, entries: Iterable[Entry]) -> dict[str, Entry]:
    """Give the entries of a file by their names.

    Raises
    ------
    InvalidFile
        If there is none, or two have one name.
    """
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


def entry_of(path: Path, entries: Mapping[str, Entry], pair_id: str) -> Entry:
    """Give the entry of this name.

    Raises
    ------
    InvalidFile
        If there is none, naming the nearest ones.
    """
    if pair_id in entries:
        return entries[pair_id]
    by_lower_case = {name.lower(): name for name in entries}
    near = difflib.get_close_matches(pair_id.lower(), by_lower_case, n=3, cutoff=0.4)
    names = [by_lower_case[name] for name in near] or list(entries)[:8]
    raise InvalidFile(
        told('{path} has no pair "{name}"', path=path, name=pair_id),
        told("choose one of {names}", names=", ".join(names)),
    )


def write_pairs(path: Path, pairs: Iterable[ShapePair]) -> None:
    """Write a file of pairs.

    Raises
    ------
    InvalidFile
        If it cannot be written.
    """
    write_document(path, _Document(FORMAT, [_entry(pair) for pair in pairs]))


def _entry(pair: ShapePair) -> _Entry:
    return _Entry(
        id=pair.id,
        source=pair.origin,
        tags=list(pair.tags),
        p=rows_of(pair.source),
        q=rows_of(pair.target),
        marks=list(pair.marks),
    )
