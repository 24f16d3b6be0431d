"""Files of pairs of shapes, format polygon-multi-pairs/1: lists of rings, holes among them like parts."""

from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import msgspec

from starskel.correspondence.marks import Mark
from starskel.errors import InvalidFile, InvalidMarks, InvalidPolygon, told
from starskel.files.documents import check_format, read_document
from starskel.files.pair_file import PairFile
from starskel.files.shapes import Row, check_edges
from starskel.limits import DOCUMENT_RINGS, Tally, check_limit
from starskel.shapes.matching.given import Places
from starskel.shapes.matching.pairing import RingLink, checked_pairing, suggest_pairing
from starskel.shapes.shape import Shape

FORMAT = "polygon-multi-pairs/1"


class _Place(msgspec.Struct, frozen=True):
    pair: RingLink
    at: Row


class _Entry(msgspec.Struct, frozen=True, kw_only=True):
    id: str
    source: str = ""
    p: list[list[Row]]
    q: list[list[Row]]
    marks: list[list[Mark]] = []
    pairing: list[RingLink] | None = None
    places: list[_Place] = []


class _Document(msgspec.Struct, frozen=True):
    format: str
    pairs: list[_Entry]


@dataclass(frozen=True)
class MultiPair:
    """Two shapes, what of the one becomes what of the other, and their marks, under a name.

    Attributes
    ----------
    id : str
        The name, unique in its file.
    source, target : Shape
    pairing : tuple of (int or None, int or None)
        The rings that become each other: as the file says, else ring by ring where there are equally many of
        outlines and holes in the same order, else as `suggest_pairing` proposes.
    marks : tuple of tuples of marks
        One list for each ring of the source, or none at all.
    places : mapping from pairs to (x, y)
        For rings without a partner the point in the other shape.
    origin : str
        Where the shapes come from, and their licence.
    roots : mapping from pairs to (x, y)
        For pairs of outlines the place in the source at which the root of the star-skeleton is.
    joined : bool
        Whether a meta-skeleton joins the parts, so that they move together.
    turns : int
        Whole turns of the whole besides, counter-clockwise.
    description : str
        A sentence about the pair.
    """

    id: str
    source: Shape
    target: Shape
    pairing: tuple[RingLink, ...]
    marks: tuple[tuple[Mark, ...], ...]
    places: Places
    origin: str = ""
    roots: Places = field(default_factory=dict)
    joined: bool = True
    turns: int = 0
    description: str = ""


def read_multi_pairs(path: Path) -> PairFile[MultiPair]:
    """Read a file of pairs of shapes.

    Raises
    ------
    InvalidFile
        If it cannot be read, is no such file, or has no pair or two pairs of one name.
    """
    check_format(path, FORMAT)
    return PairFile(path, read_document(path, _Document).pairs, partial(_checked, path))


def _checked(path: Path, entry: _Entry) -> MultiPair:
    where = told('{path}: pair "{name}"', path=path, name=entry.id)
    check_limit(where, told("rings"), len(entry.p) + len(entry.q), DOCUMENT_RINGS)
    check_edges([*entry.p, *entry.q], Tally(where))
    side = told("source (p)")
    try:
        source = Shape(entry.p)
        side = told("target (q)")
        target = Shape(entry.q)
        side = told("pairing")
        pairing = checked_pairing(source, target, _pairing(entry, source, target))
    except (InvalidPolygon, InvalidMarks) as error:
        raise InvalidFile.holding(error.within(side), where) from error
    marks = tuple(map(tuple, entry.marks))
    places = {place.pair: place.at for place in entry.places}
    return MultiPair(entry.id, source, target, pairing, marks, places, entry.source)


def _pairing(entry: _Entry, source: Shape, target: Shape) -> list[RingLink]:
    if entry.pairing is not None:
        return entry.pairing
    if source.outer == target.outer:
        return [(k, k) for k in range(len(source))]
    return suggest_pairing(source, target)
