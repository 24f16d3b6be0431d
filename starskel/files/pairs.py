"""Files of pairs of polygons, format polygon-pairs/1."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import msgspec

from starskel.correspondence.marks import Mark
from starskel.errors import told
from starskel.files.documents import check_format, read_document, write_document
from starskel.files.pair_file import PairFile
from starskel.files.shapes import Row, marked_shapes, polygon_of, rows_of
from starskel.limits import Tally
from starskel.polygon import Polygon

FORMAT = "polygon-pairs/1"


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


def read_pairs(path: Path) -> PairFile[ShapePair]:
    """Read a file of pairs.

    Raises
    ------
    InvalidFile
        If it cannot be read, is no file of pairs, or has no pair or two pairs of one name.
    """
    check_format(path, FORMAT)
    return PairFile(path, read_document(path, _Document).pairs, partial(_checked, path))


def _checked(path: Path, entry: _Entry) -> ShapePair:
    where = told('{path}: pair "{name}"', path=path, name=entry.id)
    tally = Tally(where)
    source = polygon_of(entry.p, told("{where}: {what}", where=where, what=told("source (p)")), tally)
    target = polygon_of(entry.q, told("{where}: {what}", where=where, what=told("target (q)")), tally)
    source, target, marks = marked_shapes(source, target, entry.marks, where)
    return ShapePair(entry.id, source, target, marks, tags=tuple(entry.tags), origin=entry.source)


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
