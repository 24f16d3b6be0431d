import numpy as np
import pytest

from starskel.decomposition.board import Board
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.links import links_of
from starskel.decomposition.minimal import least_stuck_cells
from starskel.decomposition.moves.reduce import reduce
from starskel.decomposition.pieces import cost, edges_of
from starskel.decomposition.rivals import LARGE, by_rivals
from starskel.decomposition.steiner import survey
from starskel.decomposition.transfer.transfer import transfer
from starskel.errors import Cancelled
from starskel.points import points_of
from starskel.task import UNWATCHED, Task
from tests.families import two_opt


def stuck_cells(n, seed):
    """The cells of a pair that common diagonals leave stuck, on a board."""
    board = Board(points_of(two_opt(n, seed)), points_of(two_opt(n, seed + 1000)))
    links = links_of(*board.triangulated([tuple(range(n))], UNWATCHED), UNWATCHED)
    (cells,) = least_stuck_cells(links, UNWATCHED)
    return board, [
        cell for cell, star in zip(cells, board.are_stars(cells, UNWATCHED), strict=True) if not star
    ]


def outline(pieces):
    edges = {edge for piece in pieces for edge in edges_of(piece)}
    return {(a, b) for a, b in edges if (b, a) not in edges}


SEEDS = [(20, 0), (20, 7), (40, 3), (60, 2)]


@pytest.mark.parametrize(("n", "seed"), SEEDS)
def test_every_stuck_cell_is_tiled_by_star_pieces_of_its_own(n, seed):
    board, cells = stuck_cells(n, seed)
    freed = by_rivals(board, cells, UNWATCHED)
    assert len(freed) == len(cells) > 0
    for cell, pieces in zip(cells, freed, strict=True):
        assert all(board.are_stars(pieces, UNWATCHED))
        assert outline(pieces) == set(edges_of(cell))


@pytest.mark.parametrize(("n", "seed"), SEEDS)
def test_the_best_rival_is_no_worse_than_either_way_alone(n, seed):
    board, cells = stuck_cells(n, seed)
    best = [cost(pieces) for pieces in by_rivals(board, cells, UNWATCHED)]
    for cell, found in zip(cells, best, strict=True):
        ways = [climb(board, [cell], by_fan, UNWATCHED)[0]] if len(cell) <= LARGE else []
        if len(cell) > LARGE:
            ways.append(transfer(board, cell, UNWATCHED))
        assert all(found <= cost(pieces) for pieces in reduce(board, ways, UNWATCHED))


@pytest.mark.parametrize(("n", "seed"), SEEDS)
def test_no_more_steiner_vertices_are_needed_than_by_the_overlay(n, seed):
    board, cells = stuck_cells(n, seed)
    most = [len(cell.ring) + cell.crossings for cell in survey(board, cells, [0] * len(cells), UNWATCHED)]
    assert all(cost(p)[0] <= limit for p, limit in zip(by_rivals(board, cells, UNWATCHED), most, strict=True))


def test_rivals_are_tried_in_the_same_order_each_time():
    (first, cells), (second, same) = stuck_cells(40, 3), stuck_cells(40, 3)
    assert by_rivals(first, cells, UNWATCHED) == by_rivals(second, same, UNWATCHED)
    np.testing.assert_array_equal(first.at, second.at)


def test_a_contest_can_be_cancelled():
    board, cells = stuck_cells(60, 2)
    asked = iter(range(10))
    with pytest.raises(Cancelled):
        by_rivals(board, cells, Task(None, lambda: next(asked) == 9))
