"""The points that rings without a partner grow from or shrink to."""

import numpy as np
import shapely

from starskel.arrays import Floats
from starskel.correspondence import Correspondence
from starskel.errors import InvalidMarks, told
from starskel.polar import as_complex
from starskel.shapes.matching.given import Place
from starskel.shapes.similarity import Similarity

TINY = 1e-3
"""The size of the tiny copy that stands for a hole that is a point, as a part of the region's."""

ROOM = 0.2
"""The same as a part of the distance from the point to the region's edge, where that is less."""


def middle_of(ring: Floats) -> complex:
    """Give the centroid of an (n, 2) ring, x and y."""
    return complex(as_complex(shapely.get_coordinates(shapely.centroid(shapely.Polygon(ring)))[0]))


def carried(ring: Floats, similarity: Similarity) -> Place:
    """Give where a similarity takes the centroid of an (n, 2) ring."""
    place = similarity(middle_of(ring))
    return place.real, place.imag


def room_for(place: Place | None, wished: Place, region: shapely.Polygon, name: str) -> Place:
    """Give a point in a region for a hole to close to: the one given, else the one wished, else the roomiest.

    Raises
    ------
    InvalidMarks
        If the point given is not inside.
    """
    if place is not None:
        if not shapely.contains_xy(region, *place):
            raise InvalidMarks(
                told(
                    "{name} would be a point at ({x:g}, {y:g}), which is not inside its part",
                    name=name,
                    x=place[0],
                    y=place[1],
                ),
                told("choose a place inside the part and outside its other holes"),
            )
        return place
    widest = shapely.maximum_inscribed_circle(region)
    if _room(wished, region) > 0.25 * widest.length:
        return wished
    x, y = shapely.get_coordinates(widest)[0].tolist()
    return x, y


def tiny_copy(ring: Floats, place: Place, region: shapely.Polygon, turn: complex) -> Floats:
    """Give an (n, 2) ring scaled down round a point in a region, turned by a complex number."""
    around = as_complex(ring) - middle_of(ring)
    size = min(
        TINY * float(np.ptp(shapely.get_coordinates(region), axis=0).max()), ROOM * _room(place, region)
    )
    around *= size / np.abs(around).max() * turn / abs(turn)
    return np.stack([place[0] + around.real, place[1] + around.imag], axis=1)


def beside(ring: Floats, copy: Floats, grows: bool) -> Correspondence:
    """Give a ring and a copy without vertices of its own, or a point; the ring is the target if it grows."""
    own, none = np.arange(len(ring)), np.full(len(ring), -1)
    rows = np.broadcast_to(copy, ring.shape)
    if grows:
        return Correspondence(rows, ring, (), none, own)
    return Correspondence(ring, rows, (), own, none)


def _room(place: Place, region: shapely.Polygon) -> float:
    if not shapely.contains_xy(region, *place):
        return 0.0
    return float(shapely.distance(region.boundary, shapely.Point(place)))
