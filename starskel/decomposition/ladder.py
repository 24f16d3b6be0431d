"""Tiling a pair that has no decomposition without Steiner vertices: climb only as far as needed.

A cell is done where both its rings are star-shaped. Else common diagonals cut it, leaving stuck cells as
small as can be; in a stuck cell one Steiner vertex is placed and the pockets that it leaves are cells again.
Where no place makes the pockets smaller, or the overlay needs no more Steiner vertices, the overlay ends the
climb.
"""

import numpy as np

from starskel.decomposition.fan import fans
from starskel.decomposition.kernel import star_point, star_vertices
from starskel.decomposition.links import links_of
from starskel.decomposition.minimal import least_stuck_cells
from starskel.decomposition.overlay import crossings, overlay
from starskel.decomposition.tiling import Tiling
from starskel.predicates import Floats
from starskel.task import Task
from starskel.triangulation import Triangulation, triangulate

TRIED = 4
"""Places of a Steiner vertex that are tried to the end before one is chosen."""


def climb(source: Floats, target: Floats, task: Task, tried: int = TRIED) -> Tiling:
    """Tile two simple rings of equal count by pieces star-shaped in both, with few Steiner vertices."""
    whole = Tiling(source, target, (tuple(range(len(source))),))
    if is_star_piece(source, target):
        return whole
    grounds = triangulate(source), triangulate(target)
    cells = Tiling(source, target, tuple(least_stuck_cells(links_of(*grounds), task.part(0, 0))))
    solved = []
    for at, cell in enumerate(cells.pieces):
        rings = source[list(cell)], target[list(cell)]
        if not is_star_piece(*rings):
            ground = grounds if len(cell) == len(source) else (triangulate(rings[0]), triangulate(rings[1]))
            solved.append((at, _free(*ground, task.part(at / len(cells.pieces), 1), tried)))
    return cells.refine_all(solved)


def is_star_piece(source: Floats, target: Floats) -> bool:
    """Tell whether two corresponding rings have a common star vertex, or kernels with an inside."""
    common = star_vertices(source) & star_vertices(target)
    return bool(common.any()) or (star_point(source) is not None and star_point(target) is not None)


def _free(source: Triangulation, target: Triangulation, task: Task, tried: int) -> Tiling:
    """Tile a stuck cell."""
    task.reach(0)
    best: Tiling | None = None
    for fan in fans(source, target, tried):
        tiling = _fill_pockets(fan, task)
        if best is None or tiling.cost() < best.cost():
            best = tiling
    needed = len(source.points.coordinates) + crossings(source, target)
    if best is None or needed < len(best.source):
        return overlay(source, target)
    return best


def _fill_pockets(fan: Tiling, task: Task) -> Tiling:
    solved = []
    for at, pocket in enumerate(fan.pieces):
        rows = np.array(pocket)
        if not is_star_piece(fan.source[rows], fan.target[rows]):
            solved.append((at, climb(fan.source[rows], fan.target[rows], task.part(0, 0), tried=1)))
    return fan.refine_all(solved)
