"""Polygons and marks as files hold them: rows of numbers, checked on the way in."""

from collections.abc import Sequence

import numpy as np

from starskel.arrays import Floats
from starskel.correspondence.marks import Mark, checked_marks
from starskel.crossings import overlapping_edges
from starskel.errors import InvalidFile, InvalidMarks, InvalidPolygon, told
from starskel.limits import EDGES, RING_VERTICES, Tally, check_limit
from starskel.polygon import Polygon

Row = tuple[float, float]


def rows_of(polygon: Polygon) -> list[Row]:
    """Give the vertices as rows for a file."""
    return list(map(tuple, polygon.vertices.tolist()))


def polygon_of(rows: Sequence[Row], where: str, tally: Tally) -> Polygon:
    """Give the polygon of a file's rows.

    Parameters
    ----------
    rows : sequence of (float, float)
    where : str
        What errors call it.
    tally : Tally
        Of the file.

    Raises
    ------
    InvalidFile
        If it has too many vertices, or all rings of the file have too much; or from the polygon's own
        error, with `where` put in front.
    """
    check_limit(where, told("vertices"), len(rows), RING_VERTICES)
    check_edges([rows], tally)
    try:
        return Polygon(rows)
    except InvalidPolygon as error:
        raise InvalidFile.holding(error, where) from error


def check_edges(rings: Sequence[Floats | Sequence[Row]], tally: Tally) -> None:
    """Refuse edges that lie so close to each other that looking for crossings would take time without end.

    Raises
    ------
    InvalidFile
        Naming the limit and the value.
    """
    drawn = [np.asarray(ring, dtype=np.float64) for ring in rings if len(ring)]
    if drawn:
        tally.add(told("edges beside each other"), overlapping_edges(drawn, EDGES), EDGES)


def marked_shapes(
    source: Polygon, target: Polygon, marks: Sequence[Mark], where: str
) -> tuple[Polygon, Polygon, tuple[Mark, ...]]:
    """Give the polygons of a file, and its marks, which count rows of the file, as indices of `vertices`.

    The polygons come back as if they had been given counter-clockwise, so that the marks fit them either way.

    Raises
    ------
    InvalidFile
        From the marks' own error, with `where` put in front.
    """
    try:
        checked_marks(source, target, tuple(marks))
    except InvalidMarks as error:
        raise InvalidFile.holding(error, where) from error
    own = tuple((source.vertex_of(i), target.vertex_of(j)) for i, j in marks)
    return as_given(source), as_given(target), own


def as_given(polygon: Polygon) -> Polygon:
    """Give the polygon as if its vertices had been given as they are, counter-clockwise."""
    return polygon if polygon.vertex_of(1) == 1 else Polygon(polygon.vertices)
