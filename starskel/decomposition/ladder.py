"""Tiling a pair that has no decomposition without Steiner vertices: climb only as far as needed.

A cell is done where both its rings are star-shaped. Else common diagonals cut it, leaving stuck cells as
small as can be, which have to be freed by Steiner vertices. One way to free a stuck cell is to place one of
them and a fan round it; the pockets that it leaves are cells again. Where no place makes the pockets smaller,
or the overlay needs no more Steiner vertices, the overlay ends the climb.
"""

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from starskel.decomposition.links import links_of
from starskel.decomposition.minimal import least_stuck_cells
from starskel.decomposition.overlay import crossings, overlay
from starskel.decomposition.pieces import Piece
from starskel.decomposition.steiner import fans
from starskel.decomposition.tiling import Tiling
from starskel.task import Task
from starskel.triangulation import Grounds, triangulate

Free = Callable[[Tiling, Grounds, Task], Tiling]
"""A way to tile a stuck cell, the only piece of a tiling, given triangulated."""


def climb(tiling: Tiling, cell: Piece, free: Free, task: Task) -> Tiling:
    """Replace a cell by pieces that are star-shaped in both polygons, with few Steiner vertices."""
    task.reach(0)
    if tiling.is_star(cell, task.quiet):
        return tiling
    task.reach(0)
    grounds = triangulated(tiling, cell, task.quiet)
    parts = least_stuck_cells(links_of(*grounds, task), task.quiet)[0]
    tiling = tiling.replace(cell, parts)
    for at, part in enumerate(parts):
        if not tiling.is_star(part, task.quiet):
            ground = grounds if len(part) == len(cell) else triangulated(tiling, part, task.quiet)
            inner = free(tiling.only(part), ground, task.part(at / len(parts), 1))
            tiling = tiling.refined(part, inner)
    return tiling


def triangulated(tiling: Tiling, cell: Piece, task: Task) -> Grounds:
    """Triangulate a cell in both polygons; that takes long where it is large."""
    ring = np.array(cell)
    source = triangulate(tiling.source, ring)
    task.reach(0)
    return source, triangulate(tiling.target, ring)


def by_fans(tiling: Tiling, grounds: Grounds, most: int, free: Free, task: Task) -> Iterator[Tiling]:
    """Free a stuck cell in the most promising ways that begin with one Steiner vertex, the best first.

    The cells that are stuck after that are freed in the way given.
    """
    (cell,) = tiling.pieces
    for fan in fans(tiling, cell, grounds, most, task):
        tiled = fan.tiling
        for pocket in fan.pockets:
            tiled = climb(tiled, pocket, free, task.quiet)
        yield tiled


def by_fan(tiling: Tiling, grounds: Grounds, task: Task) -> Tiling:
    """Free a stuck cell by that Steiner vertex which promises most."""
    return cheapest(tiling, grounds, list(by_fans(tiling, grounds, 1, by_fan, task)))


def cheapest(tiling: Tiling, grounds: Grounds, found: Sequence[Tiling]) -> Tiling:
    """Give the cheapest way to free a stuck cell among those found, or the overlay if none is cheaper."""
    (cell,) = tiling.pieces
    best = min(found, key=Tiling.cost, default=None)
    if best is None or len(cell) + crossings(*grounds) < best.cost()[0]:
        return overlay(tiling, cell, *grounds)
    return best
