"""The points that rings without a partner grow from or shrink to."""

from collections.abc import Iterable, Sequence

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

SOME_ROOM = 0.02
"""How far from other rings, as a part of their size, a part grows from a point or shrinks to one."""

ROOM = 0.2
"""The same as a part of the distance from the point to the region's edge, where that is less."""


Moved = tuple[Floats, Floats]
"""A ring at one end of its way, and at the other."""


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


def place_among(ring: Floats, wished: Place, parts: Iterable[Sequence[Moved]]) -> Place:
    """Give a point for a part to grow from or shrink to: in the same rings as the part is, and in no others.

    It is the place wished where that is so and has some room, else the nearest that has. A part inside a
    ring that is a point there as well comes from that point. Other parts that meet the part leave it free.

    Parameters
    ----------
    ring : (n, 2) array
        The part's outline.
    wished : (float, float)
    parts : iterable of sequences of ((n, 2) array, (n, 2) array)
        The rings of other parts: where the part is, and where it is a point.
    """
    own = shapely.Polygon(ring)
    around: list[shapely.Polygon] = []
    apart: list[shapely.Polygon] = []
    for rings in parts:
        if any(shapely.intersects(shapely.LinearRing(here), own.exterior) for here, _ in rings):
            continue
        for here, there in rings:
            inside = shapely.contains_properly(shapely.Polygon(here), own)
            if np.ptp(there, axis=0).any():
                (around if inside else apart).append(shapely.Polygon(there))
            elif inside:
                return float(there[0, 0]), float(there[0, 1])
    return _nearest(wished, around, apart)


def _nearest(wished: Place, around: list[shapely.Polygon], apart: list[shapely.Polygon]) -> Place:
    """Give the point nearest to a place that has some room in all of some polygons and beside others."""
    everything = shapely.union_all([*around, *apart, shapely.Point(wished)])
    size = 2 * float(shapely.minimum_bounding_radius(everything))
    region = shapely.intersection_all([shapely.buffer(everything.envelope, size), *around])
    region = shapely.difference(region, shapely.union_all(apart))
    if region.is_empty:  # the rings lie otherwise than where the part is
        return wished
    room = min(SOME_ROOM * size, 0.5 * shapely.maximum_inscribed_circle(region).length)
    roomy = shapely.buffer(region, -room)
    return wished if shapely.contains_xy(roomy, *wished) else _point_of(roomy, wished)


def _point_of(region: shapely.Geometry, place: Place) -> Place:
    """Give the point of a region that is nearest to a place."""
    way = shapely.shortest_line(region, shapely.Point(place))
    x, y = shapely.get_coordinates(way)[0].tolist()
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
