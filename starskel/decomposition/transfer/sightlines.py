"""Which places inside a polygon see each other.

As in `starskel.visibility` views expand through the triangles of a triangulation. Here the viewers look for
one another, and only for free sight: no view narrows to a line, and the expansion ends at the ring.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Indices
from starskel.points import Points
from starskel.rings import ranges
from starskel.task import Task
from starskel.triangulation import Triangulation


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


@dataclass(frozen=True, eq=False)
class _Behind:
    """What views meet behind half-edges: the far corner of the triangle, and the places in it.

    Attributes
    ----------
    first, counts : (3 f,) arrays of int
        What is met behind each half-edge: so many entries of the arrays below, from a first one on. The first
        is the corner.
    row, place : arrays of int
        The rows of what is met among the points; which place it is, -1 for corners.
    through : (2, 3 f) array of int
        Behind which half-edges the views go on to the right and to the left of the corner; -1 at the ring.
    """

    first: Indices
    counts: Indices
    row: Indices
    place: Indices
    through: Indices


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
    behind = _behind(ground, places)
    views = _from_within(ground, places, sees)
    while views.shape[1]:
        task.reach(0)
        views = _onward(places, behind, views, sees)
    return sees | sees.T


def _behind(ground: Triangulation, places: Places) -> _Behind:
    edges = np.arange(len(ground.twins))
    triangle = edges // 3
    begun, end = (np.searchsorted(places.triangle, triangle, side) for side in ("left", "right"))
    edge, home = ranges(begun, end - begun)
    after, last = (edges - edges % 3 + (edges + step) % 3 for step in (1, 2))
    corner = ground.rings.rows[ground.starts[last]]
    counts = end - begun + 1
    first = np.cumsum(counts) - counts
    row, place = np.empty(counts.sum(), dtype=np.intp), np.full(counts.sum(), -1)
    row[first] = corner
    others = np.arange(len(home)) + edge + 1
    row[others], place[others] = places.rows[places.place[home]], places.place[home]
    return _Behind(first, counts, row, place, ground.twins[np.stack([after, last])])


def _from_within(ground: Triangulation, places: Places, sees: Flags) -> Indices:
    """Note which places lie in one triangle; give the views out of it, through the edges that lie ahead.

    Returns
    -------
    (4, v) array of int
        The viewers, the half-edges behind which the views are to be continued, and their right and left
        limits, as rows among the points.
    """
    viewer, edge = np.repeat(places.place, 3), (3 * places.triangle[:, None] + np.arange(3)).ravel()
    corners = ground.rings.rows[ground.triangles]
    right, left = corners.ravel()[edge], np.roll(corners, -1, axis=1).ravel()[edge]
    turns = places.points.orientation(places.rows[viewer], right, left)
    within = np.repeat((turns.reshape(-1, 3) >= 0).all(axis=1), 3)  # others were rounded out of it
    home, other = _in_one_triangle(places)
    both = within[3 * home] & within[3 * other]
    sees[places.place[home[both]], places.place[other[both]]] = True
    behind = ground.twins[edge]
    return np.stack([viewer, behind, right, left])[:, within & (turns > 0) & (behind >= 0)]


def _in_one_triangle(places: Places) -> tuple[Indices, Indices]:
    """Pair the places with those in the same triangle."""
    first, end = (np.searchsorted(places.triangle, places.triangle, side) for side in ("left", "right"))
    return ranges(first, end - first)


def _onward(places: Places, behind: _Behind, views: Indices, sees: Flags) -> Indices:
    """Note which places lie within the limits of views in the triangles behind; give the views onward.

    What lies there and the far corners are told in one go: many calls on a little take longer.
    """
    viewer, edge, right, left = views
    counts = behind.counts[edge]
    view, met = ranges(behind.first[edge], counts)
    row, place = behind.row[met], behind.place[met]
    eyes, limits = places.rows[viewer][view], views[2:, view]
    turns = places.points.orientation(
        np.concatenate([eyes, eyes]), np.concatenate([limits[0], row]), np.concatenate([row, limits[1]])
    )
    left_of_right, right_of_left = turns[: len(row)] > 0, turns[len(row) :] > 0
    seen = left_of_right & right_of_left & (place >= 0)
    sees[viewer[view[seen]], place[seen]] = True
    corners = np.cumsum(counts) - counts
    corner, left_of_right, right_of_left = row[corners], left_of_right[corners], right_of_left[corners]
    after, last = behind.through[:, edge]
    rightward = np.stack([viewer, after, right, np.where(right_of_left, corner, left)])
    leftward = np.stack([viewer, last, np.where(left_of_right, corner, right), left])
    return np.concatenate(
        [rightward[:, left_of_right & (after >= 0)], leftward[:, right_of_left & (last >= 0)]], axis=1
    )
