"""WKT in (OGC simple features): a geometry, or one on each line."""

import re
from itertools import pairwise

import numpy as np
import shapely

from starskel.errors import InvalidFile, told
from starskel.limits import (
    DEPTH,
    DRAWING_BYTES,
    DRAWING_SHAPES,
    DRAWING_VALUES,
    DRAWING_VERTICES,
    Tally,
    check_limit,
)
from starskel.reading.areas import area_of
from starskel.reading.named_shape import NamedShape, Reading
from starskel.reading.wanted import Wanted

_OUTSIDE = re.compile(rb"[A-Za-z]+|[()]")
_INSIDE = re.compile(rb"[()]")

_GEOMETRIES = {
    b"POINT",
    b"LINESTRING",
    b"LINEARRING",
    b"POLYGON",
    b"MULTIPOINT",
    b"MULTILINESTRING",
    b"MULTIPOLYGON",
    b"GEOMETRYCOLLECTION",
}
_DIMENSIONS = (b"ZM", b"Z", b"M")
_SYSTEM = b"SRID"


def read(content: bytes, wanted: Wanted) -> Reading:
    """Give the shapes of a WKT file, in its coordinates; there are no curves in it.

    Raises
    ------
    InvalidFile
        If it is damaged, no WKT, or exceeds a limit.
    """
    tally, shapes, empty = Tally(told("the file")), [], 0
    for number, text in enumerate(_geometries(content), 1):
        try:
            with np.errstate(over="ignore", invalid="ignore"):  # what lies beyond all numbers is refused
                geometry = shapely.force_2d(shapely.from_wkt(text))
        except (shapely.errors.GEOSException, ValueError, ArithmeticError, NotImplementedError) as error:
            raise InvalidFile(
                told("geometry {number} of the WKT is damaged: {error}", number=number, error=error),
                told("take an undamaged copy"),
            ) from error
        made = area_of(geometry, tally)
        empty += made is None
        if made is not None:
            shapes.append(NamedShape(told("shape {number}", number=number), *made))
    notes = (told("geometries without an area were left out: {count}", count=empty),) if empty else ()
    return Reading(tuple(shapes), notes)


def _geometries(content: bytes) -> list[str]:
    """Cut the text where geometries begin outside of all brackets."""
    check_limit(told("the WKT"), told("bytes"), len(content), DRAWING_BYTES)
    check_limit(told("the WKT"), told("vertices"), content.count(b","), DRAWING_VERTICES)
    check_limit(told("the WKT"), told("brackets"), content.count(b"("), DRAWING_VERTICES)
    begins = _begins(content)
    texts = [content[begin:end] for begin, end in pairwise([*begins, len(content)])]
    geometries = [text for text in texts if not text.upper().startswith(_SYSTEM)]
    if not geometries:
        raise _no_wkt()
    return [text.decode("utf-8", "replace").strip() for text in geometries]


def _begins(content: bytes) -> list[int]:
    """Give where geometries, and names of their coordinate systems, begin."""
    begins: list[int] = []
    depth, words, place = 0, 0, _OUTSIDE.search(content)
    while place and 0 <= depth <= DEPTH and words <= DRAWING_VALUES and len(begins) <= DRAWING_SHAPES:
        word = place.group().upper()
        depth += {b"(": 1, b")": -1}.get(word, 0)
        words += word.isalpha()
        if word.isalpha() and _is_begin(word):
            begins.append(place.start())
        place = (_INSIDE if depth else _OUTSIDE).search(content, place.end())
    check_limit(told("the WKT"), told("nested brackets"), depth, DEPTH)
    check_limit(told("the WKT"), told("words"), words, DRAWING_VALUES)
    check_limit(told("the WKT"), told("shapes"), len(begins), DRAWING_SHAPES)
    return begins


def _is_begin(word: bytes) -> bool:
    """Tell geometries from what stands beside them.

    Raises
    ------
    InvalidFile
        If it is no word of WKT.
    """
    kind = next((word.removesuffix(end) for end in _DIMENSIONS if word.endswith(end)), word)
    if kind in _GEOMETRIES or word == _SYSTEM:
        return True
    if word == b"EMPTY" or not kind:
        return False
    raise _no_wkt()


def _no_wkt() -> InvalidFile:
    return InvalidFile(told("the file is no WKT"), told('give text that begins like "POLYGON ((0 0, "'))
