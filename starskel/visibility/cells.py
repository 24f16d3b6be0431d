"""Convex cells of triangulated rings: the fewer they are, the fewer steps views take through them.

Triangles are joined over all diagonals but those that split reflex corners: one at each, or two where none
splits it into two convex angles. So there are at most four times as many cells as the fewest possible, as
after joining one by one (Hertel and Mehlhorn 1983, "Fast Triangulation of Simple Polygons").
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Indices
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
    others : (2 h,) array of int
        How many other corners the cell has.
    behind : (2 h,) array of int
        Where in the cell behind the side a walk along all its other sides begins; -1 on the ring.
    first : (h,) array of int
        The places of first rounds.
    of_triangle : (n - 2,) array of int
        A place in the cell that each triangle is part of.
    """

    corner: Indices
    others: Indices
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
    stays = _stays(ground)
    cell = _joined(ground, stays)
    sides, around = _rounds(ground, stays, cell)
    size = np.bincount(around, minlength=len(cell))
    begun = size.cumsum() - size
    place = begun.take(around) + np.arange(len(sides))
    at_side = np.empty(len(ground.twins) + 1, dtype=np.intp)
    at_side[sides] = place + 1
    at_side[-1] = -1  # sides of the ring, whose twin is -1
    twice = [place, place + size.take(around)]
    corner, others, behind = (np.empty(2 * len(sides), dtype=np.intp) for _ in range(3))
    corner[twice] = ground.starts.take(sides)
    others[twice] = size.take(around) - 1
    behind[twice] = at_side.take(ground.twins.take(sides))
    return Cells(corner, others, behind, place, 2 * begun.take(cell))


def _stays(ground: Triangulation) -> Flags:
    """Tell which half-edges stay: the ring, and the diagonals that split reflex corners."""
    twins, corners = ground.twins, ground.starts
    opens, splits = _spokes(ground)
    stays = _in_twos(ground, opens, splits)
    stays |= splits & splits.take(twins)  # they split the corners at both their ends
    stays[twins[stays]] = True
    left = (splits & _without(stays & splits, corners)).nonzero()[0]
    one = np.empty(len(ground.rings.rows), dtype=np.intp)
    one[corners.take(left)] = left
    chosen = one.take(corners.take(left))
    stays[chosen] = stays[twins.take(chosen)] = True
    return stays | (twins < 0)


def _spokes(ground: Triangulation) -> tuple[Flags, Flags]:
    """Tell which diagonals at reflex corners leave a convex angle before them, and which also one behind."""
    rings, twins, corners = ground.rings, ground.twins, ground.starts
    before, after = rings.rows.take(rings.preceding), rings.rows.take(rings.following)
    reflex = ground.points.orientation(before, rings.rows, after) < 0
    spokes = ((twins >= 0) & reflex.take(corners)).nonzero()[0]
    vertex, end = corners.take(spokes), rings.rows.take(corners.take(twins.take(spokes)))
    here = rings.rows.take(vertex)
    opens, closes = np.zeros((2, len(twins)), dtype=bool)
    opens[spokes] = ground.points.orientation(here, after.take(vertex), end) >= 0
    closes[spokes] = ground.points.orientation(here, end, before.take(vertex)) >= 0
    return opens, opens & closes


def _in_twos(ground: Triangulation, opens: Flags, splits: Flags) -> Flags:
    """Choose, where none alone splits a corner, the last with a convex angle before it and the next one."""
    corners = ground.starts
    last = (opens & _without(splits, corners)).nonzero()[0]
    following = ground.twins.take(last - last % 3 + (last + 2) % 3)
    two = ~opens.take(following)
    chosen = np.zeros(len(corners), dtype=bool)
    chosen[last[two]] = chosen[following[two]] = True
    return chosen


def _without(flags: Flags, corners: Indices) -> Flags:
    """Tell which half-edges begin where no half-edge begins that has a flag."""
    free = np.ones(corners.max() + 1, dtype=bool)
    free[corners[flags]] = False
    return free.take(corners)


def _joined(ground: Triangulation, stays: Flags) -> Indices:
    """Give for each triangle the one that stands for its cell.

    In each triangle one half-edge goes down, from the last corner to the first, and behind it lies the way to
    the ring's closing edge. So cells are trees.
    """
    down = (ground.starts > ground.ends).nonzero()[0]
    cell = np.where(stays.take(down), np.arange(len(down)), ground.twins.take(down) // 3)
    while True:
        farther = cell.take(cell)
        if np.array_equal(farther, cell):
            return cell
        cell = farther


def _rounds(ground: Triangulation, stays: Flags, cell: Indices) -> tuple[Indices, Indices]:
    """Give the half-edges round all cells, one cell after the other, and which cell each goes round.

    Counter-clockwise the corners of a cell are in the order of the ring.
    """
    sides = stays.nonzero()[0]
    around = cell.take(sides // 3)
    order = (around * len(ground.rings.rows) + ground.starts.take(sides)).argsort()
    return sides.take(order), around.take(order)
