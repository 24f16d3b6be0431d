"""Match two shapes: ring for ring, with points for those without a partner."""

from collections.abc import Iterable
from typing import Any, overload

import shapely

from starskel.correspondence import Correspondence, PolygonLike
from starskel.correspondence import match as match_polygons
from starskel.errors import InvalidMarks, InvalidPolygon, told
from starskel.shapes.correspondence import ShapeCorrespondence
from starskel.shapes.matching.given import Given, Marks, Places
from starskel.shapes.matching.pairing import RingLink, checked_pairing, suggest_pairing
from starskel.shapes.matching.parts import matched_shapes
from starskel.shapes.shape import Shape, ShapeLike
from starskel.task import ShouldStop, Task


@overload
def match(
    source: PolygonLike,
    target: PolygonLike,
    marks: Iterable[tuple[int, int]] = (),
    *,
    should_stop: ShouldStop | None = None,
) -> Correspondence: ...


@overload
def match(
    source: Shape | shapely.MultiPolygon,
    target: ShapeLike,
    marks: Marks = (),
    *,
    pairing: Iterable[RingLink] | None = None,
    places: Places | None = None,
    should_stop: ShouldStop | None = None,
) -> ShapeCorrespondence: ...


@overload
def match(
    source: ShapeLike,
    target: Shape | shapely.MultiPolygon,
    marks: Marks = (),
    *,
    pairing: Iterable[RingLink] | None = None,
    places: Places | None = None,
    should_stop: ShouldStop | None = None,
) -> ShapeCorrespondence: ...


def match(  # noqa: PLR0913 -- all but the first three are seldom given
    source: Any,
    target: Any,
    marks: Any = (),
    *,
    pairing: Iterable[RingLink] | None = None,
    places: Places | None = None,
    should_stop: ShouldStop | None = None,
) -> Correspondence | ShapeCorrespondence:
    """Complete a partial correspondence between two polygons, or between two shapes.

    Two polygons are matched as by `starskel.correspondence.match`. Where one of them is a `Shape`, a shapely
    MultiPolygon or a shapely Polygon with holes, both are shapes. Then the pairing says which rings become
    which, and the rings of each pair are matched as polygons. Every ring must be in some pair:

    - (i, j) pairs ring i of the source with ring j of the target, outlines with outlines and holes with holes
      of these;
    - (i, None) lets ring i shrink to a point, and (None, j) lets ring j grow from one. A part takes its holes
      along. The point is the place given, else where the ring would be if it moved with its part, or with
      the part nearest to it, or the nearest to that in the same rings as it is;
    - an outline in several pairs is cut into as many parts, along straight cuts.

    Parameters
    ----------
    source, target : Polygon, Shape, shapely Polygon or MultiPolygon, (n, 2) array-like
    marks : iterable of (int, int); for shapes a sequence of these
        Vertices that correspond, as indices of the points given, from 0. For shapes one list for each ring
        of the source, with its partner; or none at all.
    pairing : iterable of (int or None, int or None), optional
        Which rings become which; else as `suggest_pairing` proposes.
    places : mapping from pairs to (x, y), optional
        For rings without a partner the point in the other shape.
    should_stop : callable, optional
        Asked often whether to give up.

    Returns
    -------
    Correspondence for polygons, ShapeCorrespondence for shapes

    Raises
    ------
    InvalidPolygon
        Where the points form no simple polygon, or the rings no shape.
    InvalidMarks
        Where marks, pairs or places contradict the shapes or each other.
    Cancelled
        If ``should_stop`` answered True.

    Examples
    --------
    A triangle has a vertex less than a square. It gets one, on the edge where it is needed:

    >>> import starskel
    >>> square, triangle = [(0, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), (2, 0), (1, 2)]
    >>> pair = starskel.match(square, triangle, marks=[(0, 0)])
    >>> pair.target.tolist()
    [[0.0, 0.0], [2.0, 0.0], [1.5, 1.0], [1.0, 2.0]]
    >>> pair.target_vertices.tolist()
    [0, 1, -1, 2]

    A hole without a partner closes to a point:

    >>> frame = starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (6, 2), (6, 6), (2, 6)]])
    >>> starskel.match(frame, starskel.Shape([square]), pairing=[(0, 0), (1, None)]).outer
    (-1, 0)
    """
    if is_shape(source) or is_shape(target):
        task = Task(should_stop=should_stop)
        task.reach(0)
        sides = _side(source, "source"), _side(target, "target")
        links = checked_pairing(*sides, suggest_pairing(*sides) if pairing is None else pairing)
        return matched_shapes(Given.checked(sides, links, marks, {} if places is None else places), task)
    if pairing is not None or places is not None:
        raise InvalidMarks("two polygons need no pairing and no places", "give a Shape of each")
    return match_polygons(source, target, marks, should_stop=should_stop)


def is_shape(given: object) -> bool:
    """Tell whether this must be taken for a shape, since it is not for certain one polygon."""
    if isinstance(given, shapely.Polygon):
        return bool(given.interiors)
    return isinstance(given, Shape | shapely.MultiPolygon)


def _side(given: PolygonLike | ShapeLike, name: str) -> Shape:
    try:
        return Shape(given)
    except InvalidPolygon as error:
        raise error.within(told(name)) from None
