"""Areas of geometries as maps have them: polygons as they are, lines as the rings that they stand for."""

import numpy as np
import shapely

from starskel.errors import InvalidFile, told
from starskel.limits import Tally
from starskel.predicates import LARGEST
from starskel.reading.mending import shape_of_geometry, shape_of_rings
from starskel.shapes.shape import Shape


def area_of(geometry: shapely.Geometry, tally: Tally) -> tuple[Shape, tuple[str, ...]] | None:
    """Give what a geometry encloses, and what was mended; None where that is nothing."""
    if not (np.abs(shapely.get_coordinates(geometry)) < LARGEST).all():
        raise InvalidFile(
            told("a geometry has coordinates beyond all numbers"),
            told("give finite coordinates below {largest:g}", largest=LARGEST),
        )
    parts = shapely.get_parts(shapely.get_parts(geometry))
    polygons = [part for part in parts if part.geom_type == "Polygon" and not part.is_empty]
    if polygons:
        return shape_of_geometry(shapely.MultiPolygon(polygons) if len(polygons) > 1 else polygons[0], tally)
    lines = [
        shapely.get_coordinates(part) for part in parts if part.geom_type in ("LineString", "LinearRing")
    ]
    made = shape_of_rings([line for line in lines if len(line) > 2], "evenodd", tally)
    if made is None or all((line[0] == line[-1]).all() for line in lines):
        return made
    return made[0], (told("an open path was closed"), *made[1])
