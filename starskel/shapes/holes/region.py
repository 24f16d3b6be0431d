"""One of the two regions of a pair, and what has room in it."""

from collections.abc import Sequence

import numpy as np
import shapely

from starskel.arrays import Flags, Floats, Indices
from starskel.predicates import segments_meet

APART = 1e-9
"""Segments stay so far from vertices and edges that they are no end of, as a part of the size: what passes
nearer would do so, or not, by rounding, and leave polygons as narrow as that.
"""


class Region:
    """What lies between an outline and its holes.

    Attributes
    ----------
    rows : (n, 2) array
        The vertices of the outline, and behind them those of the holes.
    following : (n,) array of int
        For each row the one after it on its ring.
    area : shapely Polygon
    size : float
        Its reach in any direction: twice the radius of the smallest circle around it.
    """

    def __init__(self, rows: Floats, starts: Sequence[int], following: Indices) -> None:
        self.rows = rows
        self.following = following
        outline, *holes = np.split(rows, starts[1:])
        self.area = shapely.Polygon(outline, holes)
        self.size = 2 * float(shapely.minimum_bounding_radius(self.area))
        shapely.prepare(self.area)
        self._edges = shapely.STRtree(_segments(rows, rows[following]))
        self._apart = APART * self.size

    def clear(self, starts: Floats, ends: Floats) -> Flags:
        """Tell which segments lie in the open inside, and not all but outside; their ends may be vertices.

        Parameters
        ----------
        starts, ends : (k, 2) arrays
        """
        clear = np.asarray(shapely.contains_xy(self.area, *((starts + ends) / 2).T))
        segment, edge = self._edges.query(_segments(starts, ends), predicate="dwithin", distance=self._apart)
        corners = self.rows[np.stack([edge, self.following[edge]])]
        foreign = np.ones(len(edge), dtype=np.bool_)
        for places in (starts, ends):
            foreign &= (corners != places[segment]).any(axis=-1).all(axis=0)
        clear[segment[foreign]] = False
        return clear


def meeting(first: tuple[Floats, Floats], second: tuple[Floats, Floats]) -> tuple[Indices, Indices]:
    """Give which of some segments, starts and ends as (k, 2) arrays, meet which of others, exactly."""
    i, j = shapely.STRtree(_segments(*second)).query(_segments(*first))
    met = segments_meet(first[0][i], first[1][i], second[0][j], second[1][j])
    return i[met], j[met]


def _segments(starts: Floats, ends: Floats) -> np.ndarray:
    return np.asarray(shapely.linestrings(np.stack([starts, ends], axis=1)))
