import numpy as np
import pytest

from starskel.decomposition.board import Board
from starskel.decomposition.moves.tiling import Tiling, outline, union
from starskel.errors import Cancelled
from starskel.points import points_of
from starskel.task import UNWATCHED, Task

RING = np.array([(0, 0), (3, 0), (4, 2), (2.5, 4), (0, 2)], dtype=float)


@pytest.fixture
def board():
    return Board(points_of(RING), points_of(RING))


def test_neighbours_are_offered_once_and_again_when_one_of_them_is_new(board):
    tiling = Tiling(board, [(0, 1, 2), (0, 2, 3), (0, 3, 4)])
    (first, _), (second, _) = tiling.unions(UNWATCHED)
    assert [first, second] == [((0, 3, 4), (0, 2, 3)), ((0, 2, 3), (0, 1, 2))]  # the longer edge first
    assert tiling.unions(UNWATCHED) == []
    assert tiling.make([(second, [(0, 1, 2, 3)])])
    assert tiling.unions(UNWATCHED) == [(((0, 3, 4), (0, 1, 2, 3)), (0, 1, 2, 3, 4))]
    assert list(tiling.pieces) == [(0, 3, 4), (0, 1, 2, 3)]


def test_what_is_known_to_be_no_star_is_not_offered(board):
    board.unions[(0, 2, 3), (0, 1, 2)] = None
    offered = Tiling(board, [(0, 1, 2), (0, 2, 3), (0, 3, 4)]).unions(UNWATCHED)
    assert [pair for pair, _ in offered] == [((0, 3, 4), (0, 2, 3))]


def test_moves_of_pieces_that_are_gone_are_left_out(board):
    tiling = Tiling(board, [(0, 1, 2), (0, 2, 3), (0, 3, 4)])
    offered = [(pair, [ring]) for pair, ring in tiling.unions(UNWATCHED)]
    assert tiling.make(offered)
    assert list(tiling.pieces) == [(0, 1, 2), (0, 2, 3, 4)]
    assert not tiling.make(offered)


def test_steiner_vertices_are_offered_with_what_is_round_them_whenever_that_changes(board):
    first, second = board.place(*(np.array([(1.0, 1.0), (2.0, 2.0)]) for _ in range(2)))
    tiling = Tiling(board, [(0, 1, first), (1, 2, second, first), (2, 3, 4, 0, first, second)])
    before = tiling.stars(UNWATCHED)
    assert before == [
        (second, ((1, 2, second, first), (2, 3, 4, 0, first, second))),
        (first, ((0, 1, first), (1, 2, second, first), (2, 3, 4, 0, first, second))),
    ]
    assert tiling.stars(UNWATCHED) == []
    assert tiling.make([(before[0][1], [(1, 2, first), (2, 3, 4, 0, first)])])
    assert tiling.stars(UNWATCHED) == [(first, ((0, 1, first), (1, 2, first), (2, 3, 4, 0, first)))]


def test_looking_at_many_pieces_can_be_stopped(board):
    (centre,) = board.place(*(np.array([(2.0, 1.5)]) for _ in range(2)))
    tiling = Tiling(board, [(a, (a + 1) % 5, centre) for a in range(5)])
    for look in (tiling.unions, tiling.stars):
        with pytest.raises(Cancelled):
            look(Task(should_stop=lambda: True))


def test_pieces_that_touch_at_a_vertex_besides_their_edge_are_not_merged():
    assert union((0, 1, 2, 3), (2, 1, 4, 5)) == (0, 1, 4, 5, 2, 3)
    assert union((0, 1, 2, 3), (2, 1, 4, 0)) is None
    assert union((0, 1, 2, 3, 4, 5), (2, 1, 6, 4, 3, 7)) is None


def test_the_ring_round_pieces_is_given_where_they_enclose_nothing():
    around = [(0, 1, 9), (1, 2, 9), (2, 3, 9), (3, 0, 9)]
    assert outline(around) == (0, 1, 2, 3)
    assert outline(around[:3]) == (0, 1, 2, 3, 9)
    assert outline([(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]) is None
    assert outline([around[0], around[2]]) is None
