"""Polygon: the one place where rings are checked and oriented."""

from functools import cached_property

import numpy as np
import shapely
from numpy.typing import ArrayLike

from starskel.arguments import whole_number
from starskel.arrays import Floats, read_only
from starskel.crossings import first_crossing, meeting_places
from starskel.errors import InvalidPolygon, told
from starskel.outline import signed_areas
from starskel.predicates import LARGEST, ROUNDING, orientation

TOUCHING = 4
"""Roundings of the largest coordinate: so far vertices must stay from edges that they are no end of."""


class Polygon:
    """A simple polygon: at least three vertices, no two of them equal, no edges that touch but neighbours.

    Edges that come nearer to each other than `TOUCHING` roundings of the coordinates count as touching.

    A ring given clockwise is turned round, vertex 0 kept first; a last point equal to the first is dropped.

    Parameters
    ----------
    points : (n, 2) array-like, or a shapely Polygon or LinearRing without holes, or a Polygon
        The vertices in order, x right and y up, in the user's units.

    Raises
    ------
    InvalidPolygon
        Naming the vertices and the place of the fault.

    Examples
    --------
    >>> import starskel
    >>> clockwise = starskel.Polygon([(0, 0), (0, 1), (2, 1), (2, 0)])
    >>> clockwise.area, clockwise.vertices.tolist()
    (2.0, [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]])
    >>> clockwise.vertex_of(1)  # the point that was given as the second
    3
    >>> try:
    ...     starskel.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)])
    ... except starskel.InvalidPolygon as error:
    ...     print(error.what)
    edges 0-1 and 2-3 cross or touch at (1, 1)
    """

    def __init__(self, points: "ArrayLike | shapely.Geometry | Polygon") -> None:
        given = _as_rows(points)
        _check_numbers(given)
        if len(given) > 3 and np.array_equal(given[0], given[-1]):
            given = given[:-1]
        _check_repeats(given)
        _check_simple(given)
        _check_clearance(given)
        order = np.arange(len(given))
        if signed_areas(given) < 0:
            order = -order % len(given)
        self._order = order
        self.vertices: Floats = read_only(given[order])

    def __len__(self) -> int:
        return len(self.vertices)

    def __repr__(self) -> str:
        return f"Polygon of {len(self)} vertices"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Polygon) and np.array_equal(self.vertices, other.vertices)

    def __hash__(self) -> int:
        return hash(self.vertices.tobytes())

    @cached_property
    def area(self) -> float:
        """The area, positive, in square units."""
        return float(signed_areas(self.vertices))

    def vertex_of(self, given: int) -> int:
        """Give the index in `vertices` of the point that was given at index `given`.

        Raises
        ------
        StarskelError
            If there is no such point.
        """
        point = whole_number(given, "a point of the polygon", 0, len(self) - 1)
        return int(self._order[point])  # turning round is its own inverse


def _as_rows(points: ArrayLike | shapely.Geometry | Polygon) -> Floats:
    if isinstance(points, Polygon):
        return points.vertices.copy()
    if isinstance(points, shapely.Geometry):
        points = _coordinates(points)
    try:
        given = np.asarray(points)
        if given.dtype.kind in "cSUMm":  # numpy would read strings and drop imaginary parts
            raise TypeError
        rows: Floats = given.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InvalidPolygon(told("the points are not numbers"), told("give rows of x and y")) from None
    if rows.size == 0:
        rows = rows.reshape(0, 2)
    if rows.ndim != 2 or rows.shape[1] != 2:
        raise InvalidPolygon(f"points of shape {rows.shape}", "give rows of x and y: an (n, 2) array")
    if len(rows) < 3:
        raise InvalidPolygon(
            told("a polygon of {count} points", count=len(rows)), told("give at least 3 vertices")
        )
    return rows


def _coordinates(geometry: shapely.Geometry) -> Floats:
    if not isinstance(geometry, shapely.Polygon | shapely.LinearRing):
        raise InvalidPolygon(
            f"a shapely {geometry.geom_type} is no polygon", "give a shapely Polygon or LinearRing"
        )
    if isinstance(geometry, shapely.Polygon) and geometry.interiors:
        raise InvalidPolygon("the shapely Polygon has holes", "give its exterior alone")
    return np.asarray(shapely.get_coordinates(geometry))


def _check_numbers(rows: Floats) -> None:
    wrong = np.flatnonzero(~(np.abs(rows) < LARGEST).all(axis=1))
    if len(wrong):
        i = int(wrong[0])
        raise InvalidPolygon(
            told("vertex {i} is at ({x:g}, {y:g})", i=i, x=rows[i, 0], y=rows[i, 1]),
            told("give finite coordinates below {largest:g}", largest=LARGEST),
            vertices=wrong.tolist(),
        )
    rows[np.abs(rows) < 1 / LARGEST] = 0.0
    if not np.ptp(rows, axis=0).any():
        raise InvalidPolygon(
            told("all points are the same"), told("give at least 3 different vertices"), place=_place(rows[0])
        )


def _check_repeats(rows: Floats) -> None:
    order = np.lexsort(rows.T)
    same = np.flatnonzero((rows[order[1:]] == rows[order[:-1]]).all(axis=1))
    if len(same):
        i, j = sorted((int(order[same[0]]), int(order[same[0] + 1])))
        raise InvalidPolygon(
            told("vertices {i} and {j} are both at ({x:g}, {y:g})", i=i, j=j, x=rows[i, 0], y=rows[i, 1]),
            told("remove or move one of them"),
            vertices=(i, j),
            place=_place(rows[i]),
        )


def _check_simple(rows: Floats) -> None:
    pair = first_crossing(rows)
    if pair is None:
        return
    n, (i, j) = len(rows), pair
    first, last = np.lexsort(rows.T)[[0, -1]]
    if not orientation(rows[first], rows[last], rows).any():
        raise InvalidPolygon(
            told("all vertices lie on one line: the area is zero"), told("move a vertex off the line")
        )
    place = _place(meeting_places(rows, np.array([pair]))[0])
    raise InvalidPolygon(
        told(
            "edges {first} and {second} cross or touch at ({x:g}, {y:g})",
            first=f"{i}-{(i + 1) % n}",
            second=f"{j}-{(j + 1) % n}",
            x=place[0],
            y=place[1],
        ),
        told("move or remove one of these vertices"),
        vertices=(i, (i + 1) % n, j, (j + 1) % n),
        place=place,
    )


def _check_clearance(rows: Floats) -> None:
    """Refuse vertices so near to other edges that rounding decides on which side they are."""
    n = len(rows)
    edges = shapely.linestrings(np.stack([rows, np.roll(rows, -1, axis=0)], axis=1))
    near = TOUCHING * ROUNDING * float(np.abs(rows).max())
    vertex, edge = shapely.STRtree(edges).query(shapely.points(rows), predicate="dwithin", distance=near)
    foreign = np.flatnonzero((vertex != edge) & (vertex != (edge + 1) % n))
    if len(foreign):
        i, j = int(vertex[foreign[0]]), int(edge[foreign[0]])
        raise InvalidPolygon(
            told(
                "vertex {i} all but touches edge {edge} at ({x:g}, {y:g})",
                i=i,
                edge=f"{j}-{(j + 1) % n}",
                x=rows[i, 0],
                y=rows[i, 1],
            ),
            told("move it away from the edge, or move the shape nearer to the coordinates' origin"),
            vertices=(i, j, (j + 1) % n),
            place=_place(rows[i]),
        )


def _place(point: Floats) -> tuple[float, float]:
    return float(point[0]), float(point[1])
