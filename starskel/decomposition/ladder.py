"""Tiling a pair that has no decomposition without Steiner vertices: climb only as far as needed.

A cell is done where both its rings are star-shaped. Else common diagonals cut it, leaving stuck cells as
small as can be, which have to be freed by Steiner vertices. One way to free a stuck cell is to place one of
them and a fan round it; the pockets that it leaves are cells again. Where no place makes the pockets smaller,
or the overlay needs no more Steiner vertices, the overlay ends the climb.

Cells are independent of each other. All that are at the same height are looked at together, since one large
array operation takes hardly longer than a small one.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import chain

import numpy as np

from starskel.decomposition.board import TABLED_AT_ONCE, Board, handfuls
from starskel.decomposition.minimal import least_stuck_cells
from starskel.decomposition.overlay import overlay
from starskel.decomposition.pieces import Piece, cost
from starskel.decomposition.steiner import Fan, Stuck, cut_round, survey
from starskel.task import Task

Free = Callable[[Board, list[Piece], Task], list[list[Piece]]]
"""A way to tile stuck cells, each by pieces of its own."""


@dataclass(frozen=True)
class _Cut:
    """What common diagonals make of a cell."""

    stars: list[Piece] = field(default_factory=list)
    stuck: list[Piece] = field(default_factory=list)


def climb(board: Board, cells: Sequence[Piece], free: Free, task: Task) -> list[list[Piece]]:
    """Tile cells by pieces that are star-shaped in both polygons, with few Steiner vertices."""
    cuts = _cut(board, cells, task.quiet)
    stuck = [cell for cut in cuts for cell in cut.stuck]
    freed = iter(free(board, stuck, task) if stuck else [])
    return [[*cut.stars, *chain.from_iterable(next(freed) for _ in cut.stuck)] for cut in cuts]


def _cut(board: Board, cells: Sequence[Piece], task: Task) -> list[_Cut]:
    """Cut cells that are no star pieces along common diagonals."""
    stars = board.are_stars(cells, task)
    parts = {cell: [cell] for cell in cells}
    waiting = {cell for cell, star in zip(cells, stars, strict=True) if not star}
    for handful in handfuls(waiting, TABLED_AT_ONCE, len):
        parts.update(zip(handful, least_stuck_cells(board.links(handful, task), task), strict=True))
    every = list(chain.from_iterable(parts.values()))
    is_star = dict(zip(every, board.are_stars(every, task), strict=True))
    return [
        _Cut([p for p in parts[cell] if is_star[p]], [p for p in parts[cell] if not is_star[p]])
        for cell in cells
    ]


def by_fan(board: Board, cells: list[Piece], task: Task) -> list[list[Piece]]:
    """Free stuck cells, each by that Steiner vertex which promises most."""
    stuck = survey(board, cells, [1] * len(cells), task)
    fanned = iter(spread(board, [(cell.ring, cell.fans[0]) for cell in stuck if cell.fans], by_fan, task))
    return [cheapest(board, cell, [next(fanned)] if cell.fans else [], task) for cell in stuck]


def spread(board: Board, fans: Sequence[tuple[Piece, Fan]], free: Free, task: Task) -> list[list[Piece]]:
    """Tile cells round one new Steiner vertex each; what is stuck after that is freed in the way given."""
    centres = board.place(
        np.array([fan.source for _, fan in fans]).reshape(-1, 2),
        np.array([fan.target for _, fan in fans]).reshape(-1, 2),
    )
    cuts = [cut_round(ring, fan, centre) for (ring, fan), centre in zip(fans, centres, strict=True)]
    pockets = [pocket for _, pockets in cuts for pocket in pockets]
    tiled = iter(climb(board, pockets, free, task) if pockets else [])
    return [[*stars, *chain.from_iterable(next(tiled) for _ in pockets)] for stars, pockets in cuts]


def cheapest(board: Board, stuck: Stuck, found: Sequence[list[Piece]], task: Task) -> list[Piece]:
    """Give the cheapest way to free a stuck cell among those found, or the overlay if none is cheaper."""
    best = min(found, key=cost, default=None)
    if best is None or len(stuck.ring) + stuck.crossings < cost(best)[0]:
        return overlay(board, stuck.ring, *board.triangulated([stuck.ring], task))
    return best
