"""Triangulating rings, quickly or well.

Libraries find triangles, and are believed only where every triangle and every edge proves right. Elsewhere,
among vertices that are all but collinear, ears are cut exactly.
"""

from collections.abc import Callable

import numpy as np

from starskel.arrays import Indices
from starskel.points import Points
from starskel.rings import Rings
from starskel.triangulation.ears import cut_ears
from starskel.triangulation.libraries import by_earcut, by_geos, in_order
from starskel.triangulation.runs import runs_of, split
from starskel.triangulation.triangulation import Triangulation


def triangulate(points: Points, rings: Rings) -> Triangulation:
    """Triangulate simple rings over some points in any way: fast, for views, to which all ways are alike.

    Vertices may lie on straight runs.

    Raises
    ------
    InvalidPolygon
        If a ring touches itself.
    """
    return _with_runs(points, rings, lambda corners: _proven(points, corners, by_earcut))


def delaunay(points: Points, rings: Rings) -> Triangulation:
    """Triangulate simple rings by triangles as fat as can be, the same ones wherever a ring starts.

    They are the constrained Delaunay triangles of the rings' corners, split where vertices lie on straight
    runs. It takes some 20 times as long as just any triangles.

    Raises
    ------
    InvalidPolygon
        If a ring touches itself.
    """
    return _with_runs(points, rings, lambda corners: _proven(points, corners, by_geos))


def _with_runs(points: Points, rings: Rings, cut: Callable[[Rings], Triangulation]) -> Triangulation:
    """Triangulate the corners of rings, and split what has straight vertices on its edges."""
    corner = points.orientation(rings.rows[rings.preceding], rings.rows, rings.rows[rings.following]) != 0
    if corner.all():
        return cut(rings)
    counts = np.bincount(rings.owner[corner], minlength=len(rings.counts))
    triangles = np.flatnonzero(corner)[cut(Rings(rings.rows[corner], counts)).triangles]
    return Triangulation.of(points, rings, in_order(split(triangles, runs_of(corner, rings))))


def _proven(points: Points, corners: Rings, find: Callable[[Points, Rings], Indices | None]) -> Triangulation:
    """Give what is found, if it proves right; if not, ring by ring, and exactly where it is still wrong."""
    triangles = find(points, corners)
    if triangles is not None:
        found = Triangulation.of(points, corners, triangles)
        if found.tiles:
            return found
    if len(corners.counts) == 1:
        return Triangulation.of(points, corners, in_order(cut_ears(points, corners.rows)))
    parts = [_proven(points, Rings.of([r]), find).triangles + first for r, first in corners.parts()]
    return Triangulation.of(points, corners, np.concatenate(parts))
