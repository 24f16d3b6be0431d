"""Shape: several polygons, some of them holes of others."""

from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias, Union

import numpy as np
import shapely
from numpy.typing import NDArray

from starskel.arguments import items, whole_number
from starskel.correspondence import PolygonLike
from starskel.crossings import rings_meet
from starskel.errors import InvalidPolygon, told
from starskel.polygon import Polygon

ShapeLike: TypeAlias = Union["Shape", shapely.Geometry, Polygon, Iterable[PolygonLike]]
Part: TypeAlias = tuple[PolygonLike, Sequence[PolygonLike]]


class Shape:
    """A shape of several polygons, with holes.

    A ring that lies inside another one is a hole of it, a ring inside a hole a part again, and so on: the
    even-odd rule. Rings that cross each other are parts that overlap, one drawn over the other. Parts that
    lie on another one and are no holes are given by `Shape.of_parts`.

    Parameters
    ----------
    rings : iterable of Polygon or (n, 2) array-like
        The rings in any order, wound either way; or one ring alone, a shapely Polygon or MultiPolygon, or a
        Shape.

    Attributes
    ----------
    rings : tuple of Polygon
        All rings in the order given, each counter-clockwise.
    outer : tuple of int
        For each ring that is a hole the ring that it is a hole of, -1 for those that are outlines.

    Raises
    ------
    InvalidPolygon
        Naming the ring, and the vertices and the place of the fault.

    Examples
    --------
    >>> import starskel
    >>> frame = starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (6, 2), (6, 6), (2, 6)]])
    >>> frame
    Shape of 1 part with 1 hole
    >>> frame.outer, frame.holes(0), frame.area
    ((-1, 0), (1,), 48.0)
    >>> frame.to_shapely().wkt
    'MULTIPOLYGON (((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2)))'
    """

    rings: tuple[Polygon, ...]
    outer: tuple[int, ...]

    def __init__(self, rings: ShapeLike) -> None:
        if isinstance(rings, Shape):
            self.rings, self.outer = rings.rings, rings.outer
        elif isinstance(rings, shapely.Geometry):
            self.rings, self.outer = _of_parts(_shapely_parts(rings))
        else:
            self.rings = tuple(_ring(ring, number) for number, ring in enumerate(_listed(rings)))
            self.outer = _nested(self.rings)
        _check(self)

    @classmethod
    def of_parts(cls, parts: Iterable[Part]) -> "Shape":
        """Give the shape of parts, each an outline and its holes; parts may lie on each other.

        Raises
        ------
        InvalidPolygon
            As for the class.
        """
        made = cls.__new__(cls)
        made.rings, made.outer = _of_parts(parts)
        _check(made)
        return made

    def __len__(self) -> int:
        return len(self.rings)

    def __repr__(self) -> str:
        parts, holes = len(self.outlines), len(self) - len(self.outlines)
        return f"Shape of {parts} part{'s' * (parts > 1)} with {holes} hole{'s' * (holes != 1)}"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shape) and (self.rings, self.outer) == (other.rings, other.outer)

    def __hash__(self) -> int:
        return hash((self.rings, self.outer))

    @property
    def outlines(self) -> tuple[int, ...]:
        """The rings that are no holes."""
        return tuple(ring for ring, outer in enumerate(self.outer) if outer < 0)

    def holes(self, outline: int) -> tuple[int, ...]:
        """Give the rings that are holes of the ring numbered `outline`.

        Raises
        ------
        StarskelError
            If there is no such ring.
        """
        outline = whole_number(outline, "a ring of the shape", 0, len(self) - 1)
        return tuple(ring for ring, outer in enumerate(self.outer) if outer == outline)

    @property
    def area(self) -> float:
        """The sum of the parts' areas, less their holes, in square units."""
        signs = [1 if outer < 0 else -1 for outer in self.outer]
        return float(sum(sign * ring.area for sign, ring in zip(signs, self.rings, strict=True)))

    def part(self, outline: int) -> shapely.Polygon:
        """Give an outline with its holes as a shapely Polygon."""
        holes = [self.rings[hole].vertices for hole in self.holes(outline)]
        return shapely.Polygon(self.rings[outline].vertices, holes)

    def to_shapely(self) -> shapely.MultiPolygon:
        """Give all parts; the MultiPolygon is not valid where parts overlap."""
        return shapely.MultiPolygon([self.part(outline) for outline in self.outlines])


_PARTS = "give for each part its outline and a list of its holes"


def _listed(rings: Polygon | Iterable[PolygonLike]) -> tuple[PolygonLike, ...]:
    """Give rings as a list; a polygon, or its points, are one ring."""
    if isinstance(rings, Polygon):
        return (rings,)
    given = items(rings, "the rings of a shape", "give a list of rings, or a Shape", InvalidPolygon)
    return (given,) if given and _is_point(given[0]) else given


def _is_point(given: PolygonLike) -> bool:
    try:
        return np.ndim(given) == 1  # type: ignore[arg-type]
    except ValueError:  # a ragged list
        return False


def _of_parts(parts: Iterable[Part]) -> tuple[tuple[Polygon, ...], tuple[int, ...]]:
    rings: list[Polygon] = []
    outer: list[int] = []
    for part in items(parts, "the parts", _PARTS, InvalidPolygon):
        both: tuple[Any, ...] = items(part, "a part", _PARTS, InvalidPolygon, count=2)
        outline, holes = both
        own = len(rings)
        for ring in (outline, *items(holes, "the holes of a part", _PARTS, InvalidPolygon)):
            outer.append(own if len(rings) > own else -1)
            rings.append(_ring(ring, len(rings)))
    return tuple(rings), tuple(outer)


def _shapely_parts(geometry: shapely.Geometry) -> Iterable[Part]:
    for part in shapely.get_parts(geometry):
        if not isinstance(part, shapely.Polygon) or part.is_empty:
            raise InvalidPolygon(
                f"a {part.geom_type} bounds no area", "give a shapely Polygon or MultiPolygon"
            )
        yield part.exterior, list(part.interiors)


def _ring(given: PolygonLike, number: int) -> Polygon:
    if isinstance(given, Polygon):
        return given
    try:
        return Polygon(given)
    except InvalidPolygon as error:
        raise error.within(told("ring {number}", number=number)) from None


def _nested(rings: Sequence[Polygon]) -> tuple[int, ...]:
    """Give for each ring inside an odd number of others the smallest of these, -1 for the others."""
    areas = _areas(rings)
    around: list[list[int]] = [[] for _ in rings]
    for own, k in shapely.STRtree(areas).query(_first(rings), predicate="within").T.tolist():
        if k != own and _inside(rings[own], rings[k]):
            around[own].append(k)
    return tuple(min(others, key=lambda k: rings[k].area) if len(others) % 2 else -1 for others in around)


def _areas(rings: Sequence[Polygon]) -> NDArray[np.object_]:
    return np.array([shapely.Polygon(ring.vertices) for ring in rings], dtype=object)


def _first(rings: Sequence[Polygon]) -> NDArray[np.object_]:
    return np.asarray(shapely.points(np.array([ring.vertices[0] for ring in rings]).reshape(-1, 2)))


def _inside(ring: Polygon, other: Polygon) -> bool:
    """Tell whether a ring lies wholly inside another one, without touching it."""
    if not shapely.contains_xy(shapely.Polygon(other.vertices), *ring.vertices[0]):
        return False
    return ring.area < other.area and not rings_meet([ring.vertices, other.vertices])


def _check(shape: Shape) -> None:
    if not shape.rings:
        raise InvalidPolygon("a shape without rings", "give at least one")
    holes: dict[int, list[int]] = {}
    for ring, outline in enumerate(shape.outer):
        if outline >= 0:
            holes.setdefault(outline, []).append(ring)
    for outline, inner in holes.items():
        if not _is_part(shape.rings[outline], [shape.rings[hole] for hole in inner]):
            _blame(shape, outline, inner)


def _is_part(outline: Polygon, holes: Sequence[Polygon]) -> bool:
    """Tell whether all holes lie in the outline, apart from it and from each other."""
    if rings_meet([outline.vertices, *(hole.vertices for hole in holes)]):
        return False
    first, areas = _first(holes), _areas(holes)
    inside = shapely.contains(shapely.Polygon(outline.vertices), first)
    nested = shapely.STRtree(areas).query(first, predicate="intersects").shape[1] - len(holes)
    return bool(inside.all()) and not nested and all(hole.area < outline.area for hole in holes)


def _blame(shape: Shape, outline: int, holes: Sequence[int]) -> None:
    """Say which of the holes is at fault.

    Raises
    ------
    InvalidPolygon
        Naming the ring and its outline, or the two holes.
    """
    for number, hole in enumerate(holes):
        if not _inside(shape.rings[hole], shape.rings[outline]):
            raise InvalidPolygon(
                told("ring {hole}, a hole, does not lie inside ring {outline}", hole=hole, outline=outline),
                told("move it, or give it as a part"),
            )
        for other in holes[:number]:
            _check_apart(shape, other, hole)


def _check_apart(shape: Shape, first: int, second: int) -> None:
    one, two = shape.rings[first], shape.rings[second]
    if rings_meet([one.vertices, two.vertices]) or _inside(one, two) or _inside(two, one):
        raise InvalidPolygon(
            told("rings {first} and {second}, holes of one part, meet", first=first, second=second),
            told("join them to one hole, or move them apart"),
            place=_meeting(one, two),
        )


def _meeting(first: Polygon, second: Polygon) -> tuple[float, float] | None:
    """Give a place where two rings meet, if their edges do."""
    common = shapely.intersection(*(shapely.linearrings(ring.vertices) for ring in (first, second)))
    places = shapely.get_coordinates(common).tolist()
    return (places[0][0], places[0][1]) if places else None
