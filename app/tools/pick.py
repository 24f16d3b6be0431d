"""What lies under the pointer."""

import numpy as np
import shapely

from app.model.document import Document
from app.model.point import Point, as_point
from app.tools.tool import Pointer
from starskel.arrays import Floats


def vertex_at(document: Document, pointer: Pointer) -> int | None:
    """Give the nearest vertex within the pick radius."""
    vertices = document.vertices(pointer.side)
    if not len(vertices):
        return None
    distances = np.linalg.norm(vertices - pointer.at, axis=1)
    nearest = int(distances.argmin())
    return nearest if distances[nearest] <= pointer.radius else None


def edge_at(document: Document, pointer: Pointer) -> tuple[int, Point] | None:
    """Give the nearest edge within the pick radius, and the place on it."""
    starts = document.vertices(pointer.side)
    if not len(starts):
        return None
    places = nearest_on(starts, np.roll(starts, -1, axis=0), np.array(pointer.at))
    distances = np.linalg.norm(places - pointer.at, axis=1)
    nearest = int(distances.argmin())
    return (nearest, as_point(places[nearest])) if distances[nearest] <= pointer.radius else None


def vertices_in(document: Document, pointer: Pointer, corner: Point) -> frozenset[int]:
    """Give the vertices in the box between the pointer and a corner."""
    low, high = np.minimum(corner, pointer.at), np.maximum(corner, pointer.at)
    vertices = document.vertices(pointer.side)
    inside = ((vertices >= low) & (vertices <= high)).all(axis=1)
    return frozenset(np.flatnonzero(inside).tolist())


def nearest_vertex(document: Document, pointer: Pointer, among: frozenset[int]) -> int:
    """Give the nearest of some vertices, however far."""
    vertices = sorted(among)
    away = document.vertices(pointer.side)[vertices] - pointer.at
    return vertices[int(np.hypot(*away.T).argmin())]


def inside(document: Document, pointer: Pointer) -> bool:
    """Tell whether the pointer is inside the shape."""
    polygon = document.polygon(pointer.side)
    return polygon is not None and bool(shapely.contains_xy(shapely.Polygon(polygon.vertices), *pointer.at))


def part_of_vertex_at(document: Document, pointer: Pointer) -> int | None:
    """Give the part that has the nearest vertex within the pick radius; those not shown have none."""
    ways = {
        number: float(np.hypot(*(part.ring.vertices - pointer.at).T).min())
        for number, part in enumerate(document.shape(pointer.side).parts)
        if part.visible
    }
    nearest = min(ways, key=lambda number: ways[number], default=None)
    return nearest if nearest is not None and ways[nearest] <= pointer.radius else None


def part_under(document: Document, pointer: Pointer) -> int | None:
    """Give the part whose edge is under the pointer, or else the innermost that the pointer is in.

    Parts that are not shown are not met; where several are, the smallest is meant.
    """
    found = []
    for number, part in enumerate(document.shape(pointer.side).parts):
        ring, place = shapely.Polygon(part.ring.vertices), shapely.Point(pointer.at)
        near = shapely.dwithin(shapely.boundary(ring), place, pointer.radius)
        if part.visible and (near or shapely.contains_xy(ring, *pointer.at)):
            found.append((not near, part.ring.area, number))
    return min(found)[2] if found else None


def distance(a: Point, b: Point) -> float:
    """Give the distance between two points."""
    return float(np.hypot(a[0] - b[0], a[1] - b[1]))


def nearest_on(starts: Floats, ends: Floats, at: Floats) -> Floats:
    """Give the nearest place on each segment, (k, 2)."""
    along = ends - starts
    share = ((at - starts) * along).sum(axis=1) / (along**2).sum(axis=1)
    places: Floats = starts + np.clip(share, 0, 1)[:, None] * along
    return places
