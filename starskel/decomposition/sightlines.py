"""Which places inside a polygon see each other.

As in `starskel.visibility` views expand through the triangles of a triangulation. Here the viewers look for
one another, and only for free sight: no view narrows to a line, and the expansion ends at the ring.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Indices, Signs
from starskel.points import Points
from starskel.rings import ranges
from starskel.task import Task
from starskel.triangulation import Triangulation


@dataclass(frozen=True, eq=False)
class _Views:
    """Views through half-edges between a right and a left limit (all arrays of int)."""

    viewer: Indices
    edge: Indices
    right: Indices
    left: Indices

    def keep(self, chosen: Flags) -> "_Views":
        """Give some of the views."""
        return _Views(self.viewer[chosen], self.edge[chosen], self.right[chosen], self.left[chosen])

    def join(self, other: "_Views") -> "_Views":
        """Give these views and others."""
        return _Views(
            np.concatenate([self.viewer, other.viewer]),
            np.concatenate([self.edge, other.edge]),
            np.concatenate([self.right, other.right]),
            np.concatenate([self.left, other.left]),
        )


@dataclass(frozen=True, eq=False)
class Places:
    """Places in a triangulated polygon: inside triangles, on the edges between them, or at vertices.

    Attributes
    ----------
    points : Points
        Those of the triangulation, and others.
    rows : (k,) array of int
        The rows of the places among the points.
    place, triangle : (h,) arrays of int
        Which place lies in which triangle, on its edges and corners included; sorted by triangles.
    """

    points: Points
    rows: Indices
    place: Indices
    triangle: Indices

    def turn(self, place: Indices, first: Indices, second: Indices) -> Signs:
        """Tell whether places turn left (1) or right (-1) to look from the first to the second point."""
        return self.points.orientation(self.rows[place], first, second)


def sightlines(ground: Triangulation, places: Places, task: Task) -> Flags:
    """Tell which places have a free view of each other, by a segment that meets the ring at its ends at most.

    Two vertices are not told. In a ground of several rings places in different ones do not see each other.

    Returns
    -------
    (k, k) array of bool

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    sees = np.zeros((len(places.rows), len(places.rows)), dtype=bool)
    views = _from_within(ground, places, sees)
    while len(views.viewer):
        task.reach(0)
        views = views.keep(ground.twins[views.edge] >= 0)
        _note(ground, places, views, sees)
        views = _onward(ground, places, views)
    return sees | sees.T


def _from_within(ground: Triangulation, places: Places, sees: Flags) -> _Views:
    """Note which places lie in one triangle; give the views out of it, through the edges that lie ahead."""
    viewer, edge = np.repeat(places.place, 3), (3 * places.triangle[:, None] + np.arange(3)).ravel()
    right, left = _ends(ground, edge)
    turns = places.turn(viewer, right, left)
    within = np.repeat(
        (turns.reshape(-1, 3) >= 0).all(axis=1), 3
    )  # others were rounded out of their triangle
    views = _Views(viewer, edge, right, left).keep(within & (turns > 0))
    home, other = _in_triangles(places, places.triangle)
    both = within[3 * home] & within[3 * other]
    sees[places.place[home[both]], places.place[other[both]]] = True
    return views


def _note(ground: Triangulation, places: Places, views: _Views, sees: Flags) -> None:
    """Note which places in the triangles behind the views lie within the limits."""
    view, home = _in_triangles(places, ground.twins[views.edge] // 3)
    viewer, place = views.viewer[view], places.place[home]
    row = places.rows[place]
    within = (places.turn(viewer, views.right[view], row) > 0) & (
        places.turn(viewer, row, views.left[view]) > 0
    )
    sees[viewer[within], place[within]] = True


def _in_triangles(places: Places, triangles: Indices) -> tuple[Indices, Indices]:
    """Pair the index of each given triangle with the places that lie in it."""
    first, end = (np.searchsorted(places.triangle, triangles, side) for side in ("left", "right"))
    return ranges(first, end - first)


def _onward(ground: Triangulation, places: Places, views: _Views) -> _Views:
    """Give the views through the two far edges of the triangles behind."""
    behind = ground.twins[views.edge]
    triangle = behind - behind % 3
    after, last = triangle + (behind + 1) % 3, triangle + (behind + 2) % 3
    apex, _ = _ends(ground, last)
    left_of_right = places.turn(views.viewer, views.right, apex) > 0
    right_of_left = places.turn(views.viewer, apex, views.left) > 0
    left = np.where(right_of_left, apex, views.left)
    right = np.where(left_of_right, apex, views.right)
    rightward = _Views(views.viewer, after, views.right, left).keep(left_of_right)
    return rightward.join(_Views(views.viewer, last, right, views.left).keep(right_of_left))


def _ends(ground: Triangulation, edges: Indices) -> tuple[Indices, Indices]:
    """Give the rows of the points from which and to which half-edges run."""
    corners = ground.rings.rows[ground.triangles].ravel()
    return corners[edges], corners[edges - edges % 3 + (edges + 1) % 3]
