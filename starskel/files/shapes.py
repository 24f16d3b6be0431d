"""Polygons and marks as files hold them: rows of numbers, checked on the way in."""

from collections.abc import Sequence

from starskel.errors import InvalidFile, InvalidPolygon
from starskel.polygon import Polygon

Row = tuple[float, float]
Mark = tuple[int, int]


def rows_of(polygon: Polygon) -> list[Row]:
    """Give the vertices as rows for a file."""
    return [(x, y) for x, y in polygon.vertices.tolist()]


def polygon_of(rows: Sequence[Row], where: str) -> Polygon:
    """Give the polygon of a file's rows.

    Raises
    ------
    InvalidFile
        From the polygon's own error, with `where` put in front.
    """
    try:
        return Polygon(rows)
    except InvalidPolygon as error:
        raise InvalidFile(f"{where}: {error.what}", error.mend) from error


def marks_of(marks: Sequence[Mark], source: Polygon, target: Polygon, where: str) -> tuple[Mark, ...]:
    """Give marks, whose numbers count a file's rows, as numbers of the polygons' vertices.

    Raises
    ------
    InvalidFile
        If a mark names a vertex that is not there.
    """
    for number, (i, j) in enumerate(marks):
        for name, vertex, polygon in (("source", i, source), ("target", j, target)):
            if not 0 <= vertex < len(polygon):
                raise InvalidFile(
                    f"{where}: mark {number} names vertex {vertex} of the {name}, which has {len(polygon)}",
                    f"name one of 0 to {len(polygon) - 1}",
                )
    return tuple((source.vertex_of(i), target.vertex_of(j)) for i, j in marks)
