"""One of the two regions of a pair, and what has room in it."""

from collections.abc import Sequence

import numpy as np
import shapely

from starskel.outline import Flags
from starskel.predicates import Floats, Indices, segments_meet


class Region:
    """What lies between an outline and its holes.

    Attributes
    ----------
    rows : (n, 2) array
        The vertices of the outline, and behind them those of the holes.
    following : (n,) array of int
        For each row the one after it on its ring.
    area : shapely Polygon
    """

    def __init__(self, rows: Floats, starts: Sequence[int], following: Indices) -> None:
        self.rows = rows
        self.following = following
        outline, *holes = np.split(rows, starts[1:])
        self.area = shapely.Polygon(outline, holes)
        shapely.prepare(self.area)
        self._edges = shapely.STRtree(_segments(rows, rows[following]))

    def clear(self, starts: Floats, ends: Floats) -> Flags:
        """Tell which segments lie in the open inside, but for ends that are vertices.

        Parameters
        ----------
        starts, ends : (k, 2) arrays
        """
        clear = np.asarray(shapely.contains_xy(self.area, *((starts + ends) / 2).T))
        segment, edge = self._edges.query(_segments(starts, ends))
        corners = self.rows[np.stack([edge, self.following[edge]])]
        foreign = np.ones(len(edge), dtype=np.bool_)
        for places in (starts, ends):
            foreign &= (corners != places[segment]).any(axis=-1).all(axis=0)
        segment, edge = segment[foreign], edge[foreign]
        last = self.rows[self.following[edge]]
        clear[segment[segments_meet(starts[segment], ends[segment], self.rows[edge], last)]] = False
        return clear


def meeting(first: tuple[Floats, Floats], second: tuple[Floats, Floats]) -> tuple[Indices, Indices]:
    """Give which of some segments, starts and ends as (k, 2) arrays, meet which of others, exactly."""
    i, j = shapely.STRtree(_segments(*second)).query(_segments(*first))
    met = segments_meet(first[0][i], first[1][i], second[0][j], second[1][j])
    return i[met], j[met]


def _segments(starts: Floats, ends: Floats) -> np.ndarray:
    return np.asarray(shapely.linestrings(np.stack([starts, ends], axis=1)))
