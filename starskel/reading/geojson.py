"""GeoJSON in (RFC 7946): the areas of its features; lines are closed, points are left out."""

from collections.abc import Iterator
from typing import Any

import msgspec
import shapely

from starskel.errors import InvalidFile, told
from starskel.limits import DRAWING_BYTES, DRAWING_SHAPES, DRAWING_VALUES, Tally, check_limit
from starskel.reading.areas import area_of
from starskel.reading.named_shape import NamedShape, Reading, uniquely_named
from starskel.reading.wanted import Wanted

_GEOMETRIES = {
    "Point",
    "MultiPoint",
    "LineString",
    "MultiLineString",
    "Polygon",
    "MultiPolygon",
    "GeometryCollection",
}

_NAMES = ("name", "NAME", "title", "id")


def read(content: bytes, wanted: Wanted) -> Reading:
    """Give the shapes of a GeoJSON file, in its coordinates; there are no curves in it.

    Raises
    ------
    InvalidFile
        If it is damaged, no GeoJSON, or exceeds a limit.
    """
    values = content.count(b",") + content.count(b"[")
    check_limit(told("the GeoJSON"), told("bytes"), len(content), DRAWING_BYTES)
    check_limit(told("the GeoJSON"), told("values"), values, DRAWING_VALUES)
    tally, shapes, empty = Tally(told("the file")), [], 0
    for number, (name, geometry) in enumerate(_geometries(content), 1):
        made = area_of(geometry, tally)
        empty += made is None
        if made is not None:
            shapes.append(NamedShape(name or told("shape {number}", number=number), *made))
    notes = (told("features without an area were left out: {count}", count=empty),) if empty else ()
    return Reading(uniquely_named(shapes), notes)


def _geometries(content: bytes) -> list[tuple[str, shapely.Geometry]]:
    """Give name and geometry of each feature, all of them decoded before any is looked at."""
    try:
        features = list(_features(msgspec.json.decode(content)))
        check_limit(told("the GeoJSON"), told("shapes"), len(features), DRAWING_SHAPES)
        return [(name, shapely.from_geojson(msgspec.json.encode(geometry))) for name, geometry in features]
    except InvalidFile:
        raise
    except (
        msgspec.DecodeError,
        shapely.errors.GEOSException,
        ArithmeticError,
        AttributeError,
        RecursionError,
        TypeError,
        UnicodeDecodeError,
    ) as error:
        raise InvalidFile(
            told("the GeoJSON is damaged: {error}", error=error), told("take an undamaged copy")
        ) from error


def _features(document: Any) -> Iterator[tuple[str, Any]]:
    """Give name and geometry of each feature, as JSON has it."""
    kind = document.get("type") if isinstance(document, dict) else None
    if kind == "FeatureCollection":
        for feature in document.get("features") or ():
            yield from _features(feature)
    elif kind == "Feature":
        if document.get("geometry") is not None:
            properties = document.get("properties") or {}
            names = [properties.get(key) for key in _NAMES] + [document.get("id")]
            yield str(next((name for name in names if name not in (None, "")), "")), document["geometry"]
    elif kind in _GEOMETRIES:
        yield "", document
    else:
        raise InvalidFile(told("the file is no GeoJSON"), told("give a file whose type is FeatureCollection"))
