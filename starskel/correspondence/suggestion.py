"""Marks suggested from the shapes alone."""

from starskel.arguments import whole_number
from starskel.correspondence.marks import Mark
from starskel.correspondence.match import PolygonLike, as_polygon
from starskel.correspondence.proposal import proposed_marks
from starskel.outline import precedes
from starskel.task import ShouldStop, Task

MOST = 1_000_000
"""No two outlines have so many salient vertices in common."""


def suggest_marks(
    source: PolygonLike,
    target: PolygonLike,
    count: int = 8,
    *,
    should_stop: ShouldStop | None = None,
) -> list[Mark]:
    """Propose vertices that correspond, from the shapes alone.

    The salient vertices of both outlines are aligned once round, in order, at the least work of stretching
    and bending (in the manner of Sederberg and Greenwood 1992), from many starts; the cheapest alignments are
    tried by a quick blend, and the best of them is taken. Of its pairs those are marked that are most salient
    and alike, well spread round the outline. Position and scale of the shapes do not matter; of rotations the
    smaller is preferred, where it fits about as well, but a copy that is only turned is found at any angle.
    Exchanging the shapes gives the same marks mirrored.

    Parameters
    ----------
    source, target : Polygon, shapely Polygon or (n, 2) array-like
    count : int
        How many marks, at most; there are fewer where the shapes have fewer salient vertices in common.
    should_stop : callable, optional
        Asked often whether to give up.

    Returns
    -------
    list of (int, int)
        Indices of the points given, as `match` takes them, in the order of the source's.

    Raises
    ------
    InvalidPolygon
        Where the points form no simple polygon.
    StarskelError
        If `count` is no whole number, or negative.
    Cancelled
        If ``should_stop`` answered True.

    Examples
    --------
    >>> import starskel
    >>> straight = [(0, 0), (4, 0), (8, 0), (8, 1), (4, 1), (0, 1)]
    >>> bent = [(0, 0), (4, 0), (7, 3), (6.3, 3.7), (4, 1.5), (0, 1)]
    >>> starskel.suggest_marks(straight, bent, count=3)
    [(0, 0), (2, 2)]
    """
    count = min(whole_number(count, "the count of marks", 0), MOST)
    task = Task(should_stop=should_stop)
    polygons = as_polygon(source, "source"), as_polygon(target, "target")
    task.reach(0)
    if count == 0:
        return []
    rings = polygons[0].vertices, polygons[1].vertices
    if precedes(rings[1], rings[0]):
        own = [(i, j) for j, i in proposed_marks(rings[::-1], count, task)]
    else:
        own = proposed_marks(rings, count, task)
    return sorted((polygons[0].vertex_of(i), polygons[1].vertex_of(j)) for i, j in own)
