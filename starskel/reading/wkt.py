"""WKT in (OGC simple features): a geometry, or one on each line."""

import re

import shapely

from starskel.errors import InvalidFile, told
from starskel.limits import DEPTH, RING_VERTICES, check_limit
from starskel.reading.areas import area_of
from starskel.reading.found import Found, Reading
from starskel.reading.wanted import Wanted

_BEGIN = re.compile(
    r"(?:SRID=\d+;)?\s*((?:MULTI)?(?:POLYGON|LINESTRING|POINT)|LINEARRING|GEOMETRYCOLLECTION)\b",
    re.IGNORECASE,
)


def read(content: bytes, wanted: Wanted) -> Reading:
    """Give the shapes of a WKT file, in its coordinates; there are no curves in it.

    Raises
    ------
    InvalidFile
        If it is damaged or no WKT.
    """
    shapes, empty = [], 0
    for number, text in enumerate(_geometries(content), 1):
        try:
            made = area_of(shapely.force_2d(shapely.from_wkt(text)))
        except (shapely.errors.GEOSException, ValueError, ArithmeticError) as error:
            raise InvalidFile(
                told("geometry {number} of the WKT is damaged: {error}", number=number, error=error),
                told("take an undamaged copy"),
            ) from error
        empty += made is None
        if made is not None:
            shapes.append(Found(told("shape {number}", number=number), *made))
    notes = (told("geometries without an area were left out: {count}", count=empty),) if empty else ()
    return Reading(tuple(shapes), notes)


def _geometries(content: bytes) -> list[str]:
    """Cut the text where geometries begin outside of all brackets."""
    check_limit(told("the WKT"), told("vertices"), content.count(b","), RING_VERTICES)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InvalidFile(told("the file is no WKT"), told("give a text file")) from error
    starts, depth, at = [], 0, 0
    while at < len(text):
        found = _BEGIN.match(text, at) if depth == 0 else None
        if found:
            starts.append((at, found.start(1)))
            at = found.end()
            continue
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        check_limit(told("the WKT"), told("nested brackets"), depth, DEPTH)
        at += 1
    if not starts:
        raise InvalidFile(told("the file is no WKT"), told('give text that begins like "POLYGON ((0 0, "'))
    ends = [begin for begin, _ in starts[1:]] + [len(text)]
    return [text[own:end].strip() for (_, own), end in zip(starts, ends, strict=True)]
