"""Who sees whom in rings: vertices each other, and places the vertices.

Two relations are kept apart: `sees`, where the closed segment lies in the closed polygon, and `diagonal`,
where the open segment lies in the open interior. They differ where views graze vertices or run along straight
edges. Coordinates are rounded, so a segment that passes a vertex by less than `ROUNDING` is no diagonal.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Floats, Indices
from starskel.task import UNWATCHED, Task
from starskel.triangulation import Triangulation
from starskel.visibility.cells import cells_of
from starskel.visibility.viewers import Viewers
from starskel.visibility.views import Walks, look


@dataclass(frozen=True, eq=False)
class Visibility:
    """Which viewers see which vertices.

    Attributes
    ----------
    sees : (k, n) array of bool
        The closed segment lies in the closed polygon.
    diagonal : (k, n) array of bool
        The open segment lies in the open interior, clear of all vertices.
    """

    sees: Flags
    diagonal: Flags


def visibility(ground: Triangulation, task: Task = UNWATCHED) -> Visibility:
    """Tell for all pairs of vertices whether they see each other in their ring.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    ValueError
        If the triangles have corners inside the ring.
    """
    cells = cells_of(ground)
    viewers = Viewers.of(ground, cells, ground.points, ground.rings.rows)
    own = cells.first
    sees, diagonal = look(viewers, Walks(cells.corner[own], own + 1, cells.others[own]), task)
    ring = np.arange(len(ground.rings.rows))
    sees[ring, ring] = True
    for beside in (ground.rings.preceding, ground.rings.following):  # edges of the ring are no diagonals
        diagonal[ring, beside] = False
    return Visibility(sees, diagonal & diagonal.T)


def visibility_from(
    ground: Triangulation, places: Floats, triangles: Indices, task: Task = UNWATCHED
) -> Visibility:
    """Tell which vertices of a ring are seen from (k, 2) places, each given with the triangle it lies in.

    From a place that is not strictly inside its triangle nothing is seen.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    ValueError
        If the triangles have corners inside the ring.
    """
    rows = len(ground.points.coordinates) + np.arange(len(places))
    points = ground.points.with_free(places)
    corners = ground.rings.rows[ground.triangles[triangles]]
    turns = points.orientation(rows[:, None], corners, np.roll(corners, -1, axis=1))
    viewer = np.flatnonzero((turns > 0).all(axis=1))
    cells = cells_of(ground)
    start = cells.of_triangle[triangles[viewer]]
    walks = Walks(viewer, start, cells.others[start] + 1)
    sees, diagonal = look(Viewers.of(ground, cells, points, rows), walks, task)
    return Visibility(sees, diagonal)
