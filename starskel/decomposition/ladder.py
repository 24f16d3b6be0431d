"""Tiling a pair that has no decomposition without Steiner vertices: climb only as far as needed.

A cell is done where both its rings are star-shaped. Else common diagonals cut it, leaving stuck cells as
small as can be; in a stuck cell one Steiner vertex is placed and the pockets that it leaves are cells again.
Where no place makes the pockets smaller, or the overlay needs no more Steiner vertices, the overlay ends the
climb.
"""

import numpy as np

from starskel.decomposition.fan import Fan, fans
from starskel.decomposition.links import links_of
from starskel.decomposition.minimal import Piece, least_stuck_cells
from starskel.decomposition.overlay import crossings, overlay
from starskel.decomposition.reduce import reduce
from starskel.decomposition.tiling import Tiling
from starskel.task import Task
from starskel.triangulation import Grounds, triangulate

MOST_TRIED = 6
"""Places of a Steiner vertex that are tried to the end before one is chosen, in small cells."""

TRIED_VERTICES = 80
"""In larger cells as many places are tried as have so many vertices together, but two at least."""


def climb(tiling: Tiling, cell: Piece, task: Task, *, trying: bool = True) -> Tiling:
    """Replace a cell by pieces that are star-shaped in both polygons, with few Steiner vertices.

    Where `trying`, several places of the first Steiner vertex are compared.
    """
    task.reach(0)
    if tiling.is_star(cell):
        return tiling
    task.reach(0)
    grounds = _triangulate(tiling, cell)
    cells = least_stuck_cells(links_of(*grounds, task), task.part(0, 0))
    parts = [tuple(cell[v] for v in part) for part in cells]
    tiling = tiling.replace(cell, parts)
    for at, part in enumerate(parts):
        if not tiling.is_star(part):
            ground = grounds if len(part) == len(cell) else _triangulate(tiling, part)
            inner = _free(tiling.only(part), ground, task.part(at / len(parts), 1), trying)
            tiling = tiling.refined(part, inner)
    return tiling


def _free(tiling: Tiling, grounds: Grounds, task: Task, trying: bool) -> Tiling:
    """Tile a stuck cell, the only piece of a tiling."""
    (cell,) = tiling.pieces
    tried = max(2, min(MOST_TRIED, TRIED_VERTICES // len(cell))) if trying else 1
    filled = [_fill(fan, task) for fan in fans(tiling, cell, grounds, tried, task)]
    if trying:
        filled = [reduce(found, len(tiling.source.coordinates), task) for found in filled]
    best = min(filled, key=Tiling.cost, default=None)
    if best is None or len(cell) + crossings(*grounds) < best.cost()[0]:
        return overlay(tiling, cell, *grounds)
    return best


def _fill(fan: Fan, task: Task) -> Tiling:
    tiling = fan.tiling
    for pocket in fan.pockets:
        tiling = climb(tiling, pocket, task.part(0, 0), trying=False)
    return tiling


def _triangulate(tiling: Tiling, cell: Piece) -> Grounds:
    ring = np.array(cell)
    return triangulate(tiling.source, ring), triangulate(tiling.target, ring)
