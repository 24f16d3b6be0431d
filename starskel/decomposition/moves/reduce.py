"""Fewer Steiner vertices and fewer pieces: vertices collapse into neighbours, pieces merge, all stays right.

Both moves keep the edges cancelling in pairs, so the pieces go on tiling both polygons as long as each of
them is simple and counter-clockwise in both (see `starskel.decomposition.verify`).
"""

from collections.abc import Sequence

import numpy as np

from starskel.decomposition.board import AT_ONCE, Board
from starskel.decomposition.moves.collapse import collapses
from starskel.decomposition.moves.tiling import Tiling
from starskel.decomposition.pieces import Piece
from starskel.rings import blocks
from starskel.task import Task


def reduce(board: Board, tilings: Sequence[list[Piece]], task: Task) -> list[list[Piece]]:
    """Give tilings of the same polygons or cells with fewer, or as many, Steiner vertices and pieces.

    The tilings are independent of each other. They are worked on together, in rounds of moves that do not
    touch one another, so that all rings of a round can be looked at at once.
    """
    every = [Tiling(board, pieces) for pieces in tilings]
    changing = every
    while changing:
        merged = _merge(board, changing, task)
        collapsed = _collapse(board, changing, task)
        changing = [tiling for tiling, *any_ in zip(changing, merged, collapsed, strict=True) if any(any_)]
    return [list(tiling.pieces) for tiling in every]


def _merge(board: Board, tilings: list[Tiling], task: Task) -> list[bool]:
    """Merge neighbours whose union is a star piece, if only from a vertex, the longest edges first."""
    unions = [tiling.unions(task.quiet) for tiling in tilings]
    rings = [ring for found in unions for _, ring in found]
    stars = dict(zip(rings, board.have_kernels(rings, task), strict=True))
    left = [ring for ring in rings if not stars[ring]]
    stars.update(zip(left, board.have_common_star_vertices(left, task), strict=True))
    board.unions.update((pair, None) for found in unions for pair, ring in found if not stars[ring])
    moves = [[(pair, [ring]) for pair, ring in found if stars[ring]] for found in unions]
    return [tiling.make(found) for tiling, found in zip(tilings, moves, strict=True)]


def _collapse(board: Board, tilings: list[Tiling], task: Task) -> list[bool]:
    """Collapse Steiner vertices into neighbours."""
    stars = [tiling.stars(task.quiet) for tiling in tilings]
    unknown = dict.fromkeys(star for found in stars for star in found if star not in board.collapses)
    waiting = list(unknown)
    for part in blocks(np.array([sum(map(len, pieces)) for _, pieces in waiting]), AT_ONCE):
        board.collapses.update(collapses(board, waiting[part], task.quiet))
    moves = [[(star[1], shrunk) for star in found for shrunk in board.collapses[star]] for found in stars]
    return [tiling.make(found) for tiling, found in zip(tilings, moves, strict=True)]
