"""Convex cells of triangulated rings: the fewer they are, the fewer steps views take through them.

Triangles are joined over diagonals as long as all corners stay convex (Hertel and Mehlhorn 1983, "Fast
Triangulation of Simple Polygons"), which leaves at most four times as many cells as the fewest possible.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Indices
from starskel.points import doubtful_area
from starskel.triangulation import Triangulation


@dataclass(frozen=True, eq=False)
class Cells:
    """The corners of all cells, counter-clockwise, those of each cell listed twice on end.

    So a walk round a cell goes upwards from any of the places in its first round. At a place stands a corner
    and begins the side to the next corner.

    Attributes
    ----------
    corner : (2 h,) array of int
        The corners as indices of the ring.
    size : (2 h,) array of int
        How many corners the cell has.
    behind : (2 h,) array of int
        Where in the cell behind the side a walk along all its other sides begins; -1 on the ring.
    first : (h,) array of int
        The places of first rounds.
    of_triangle : (n - 2,) array of int
        A place in the cell that each triangle is part of.
    """

    corner: Indices
    size: Indices
    behind: Indices
    first: Indices
    of_triangle: Indices


def cells_of(ground: Triangulation) -> Cells:
    """Join the triangles of a ring to convex cells.

    Raises
    ------
    ValueError
        If the triangles have corners inside the ring, for views might go round these without end.
    """
    needed = len(ground.rings.rows) - 2 * len(ground.rings.counts)
    if len(ground.triangles) != needed:
        raise ValueError(
            f"{len(ground.triangles)} triangles cannot tile rings of {len(ground.rings.rows)} vertices "
            f"without corners inside them: give the {needed} triangles of the rings alone"
        )
    sides, sizes = _rounds(_following(ground))
    size = np.repeat(sizes, sizes)
    place = np.repeat(np.cumsum(sizes) - sizes, sizes) + np.arange(len(sides))
    at_side = np.full(len(ground.twins) + 1, -2)  # the last is for sides of the ring, whose twin is -1
    at_side[sides] = place
    twice = np.concatenate([place, place + size])
    corner, sized, behind = (np.empty(2 * len(sides), dtype=np.intp) for _ in range(3))
    corner[twice] = np.tile(ground.triangles.ravel()[sides], 2)
    sized[twice] = np.tile(size, 2)
    behind[twice] = np.tile(at_side[ground.twins[sides]] + 1, 2)
    return Cells(corner, sized, behind, place, _of_triangles(ground, sides, place))


def _following(ground: Triangulation) -> list[int]:
    """Give for each half-edge the next one round its cell; -1 where the half-edge is inside a cell."""
    each = np.arange(len(ground.twins))
    following: list[int] = (each - each % 3 + (each + 1) % 3).tolist()
    before: list[int] = (each - each % 3 + (each + 2) % 3).tolist()
    is_convex = _convexity(ground)
    diagonals = np.flatnonzero(each < ground.twins)
    for h, twin in zip(diagonals.tolist(), ground.twins[diagonals].tolist(), strict=True):
        into, into_twin, onward, onward_twin = before[h], before[twin], following[h], following[twin]
        if is_convex(h, into, following[onward_twin]) and is_convex(twin, into_twin, following[onward]):
            following[into], before[onward_twin] = onward_twin, into
            following[into_twin], before[onward] = onward, into_twin
            following[h] = following[twin] = -1
    return following


def _convexity(ground: Triangulation) -> Callable[[int, int, int], bool]:
    """Give a test for the corners of cells, named by half-edges that begin there, before and behind it."""
    points, ring = ground.points, ground.rings.rows
    before, after = ring[ground.rings.preceding], ring[ground.rings.following]
    in_ring = points.orientation(before, ring, after) >= 0
    convex = in_ring[ground.triangles.ravel()].tolist()
    corners = ground.triangles.ravel().tolist()
    at = ground.vertices.view(np.complex128)[:, 0].tolist()
    doubtful = doubtful_area(ground.vertices)

    def is_convex(here: int, before: int, behind: int) -> bool:
        if convex[here]:  # in the ring, so in all parts of it
            return True
        v, a, b = corners[here], corners[before], corners[behind]
        doubled: float = ((at[v] - at[a]).conjugate() * (at[b] - at[v])).imag
        if abs(doubled) <= doubtful:
            doubled = points.orientation(*ring[[[a], [v], [b]]]).item()
        return doubled >= 0

    return is_convex


def _rounds(following: list[int]) -> tuple[Indices, Indices]:
    """Give the half-edges round all cells, one cell after the other, and how many each cell has."""
    sides: list[int] = []
    ends = [0]
    for start in range(len(following)):
        h = start
        while following[h] >= 0:
            sides.append(h)
            following[h], h = -1, following[h]
        if len(sides) > ends[-1]:
            ends.append(len(sides))
    return np.array(sides), np.diff(ends)


def _of_triangles(ground: Triangulation, sides: Indices, place: Indices) -> Indices:
    """Give a place in the cell of each triangle; those without sides take it from triangles beside them."""
    found = np.full(len(ground.triangles), -1)
    found[sides // 3] = place
    around = ground.twins.reshape(-1, 3) // 3
    while (found < 0).any():
        inner = np.flatnonzero(found < 0)
        found[inner] = found[around[inner]].max(axis=1)
    return found
