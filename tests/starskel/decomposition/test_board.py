import numpy as np
import pytest

from starskel.decomposition.board import Board, handfuls
from starskel.errors import Cancelled
from starskel.points import points_of
from starskel.task import UNWATCHED, Task
from tests.families import comb, two_opt

CORNER = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], dtype=float)
TEETH = np.array([(0, 0), (6, 0), (6, 2), (5, 2), (5, 1), (1, 1), (1, 2), (0, 2)], dtype=float)


def board_of(source, target):
    return Board(points_of(source), points_of(target))


def test_placed_vertices_follow_those_of_the_polygons():
    board = board_of(CORNER, 2 * CORNER)
    assert (board.n, len(board)) == (6, 6)
    assert list(board.place(np.array([(0.5, 0.5), (0.2, 0.1)]), np.array([(1, 1), (3, 0.5)]))) == [6, 7]
    assert (board.n, len(board)) == (6, 8)
    np.testing.assert_array_equal(board.at[:, 6:], [(0.5 + 0.5j, 0.2 + 0.1j), (1 + 1j, 3 + 0.5j)])


def test_rings_that_a_vertex_sees_whole_in_both_polygons():
    whole = tuple(range(8))
    assert board_of(TEETH, TEETH).have_common_star_vertices([whole, (0, 1, 4, 5)], UNWATCHED) == [False, True]
    l_shapes = board_of(CORNER, np.roll(CORNER, 1, axis=0))
    assert l_shapes.have_common_star_vertices([(0, 1, 2, 3, 4, 5), (0, 1, 2, 3)], UNWATCHED) == [False, True]


def test_rings_with_kernels_are_simple_and_run_counter_clockwise():
    board = board_of(CORNER, CORNER)
    rings = [(0, 1, 2, 3, 4, 5), (5, 4, 3, 2, 1, 0), (0, 1, 2, 3), (1, 2, 3), (0, 2, 1, 3), (1, 2, 3, 4)]
    assert board.have_kernels(rings, UNWATCHED) == [True, False, True, True, False, False]


def test_a_star_piece_has_a_common_vertex_or_kernels_with_an_inside():
    angles = np.pi * (np.arange(10) / 5 + 0.5)
    radii = np.where(np.arange(10) % 2, 0.3, 1.0)
    star = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    whole = tuple(range(10))
    board = board_of(star, star)
    assert board.have_common_star_vertices([whole], UNWATCHED) == [False]
    assert board.are_stars([whole, whole[1:4]], UNWATCHED) == [True, True]
    assert board_of(TEETH, TEETH).are_stars([tuple(range(8))], UNWATCHED) == [False]


def test_what_is_known_of_a_ring_stays_true_when_points_are_added():
    board = board_of(two_opt(20, 1), two_opt(20, 1001))
    rings = [tuple(range(k, k + 4)) for k in range(16)]
    before = board.are_stars(rings, UNWATCHED)
    board.place(np.array([(50, 50)]), np.array([(40, 40)]))
    assert board.are_stars(rings[::-1], UNWATCHED) == before[::-1]
    assert board_of(two_opt(20, 1), two_opt(20, 1001)).are_stars(rings, UNWATCHED) == before


def test_long_work_asks_whether_to_stop():
    board = board_of(comb(8), comb(8))
    for look in (board.have_kernels, board.have_common_star_vertices, board.triangulated):
        with pytest.raises(Cancelled):
            look([tuple(range(len(comb(8))))], Task(None, lambda: True))


def test_handfuls_take_every_ring_once_and_no_more_work_than_wanted():
    rings = [tuple(range(k)) for k in (9, 3, 30, 4, 3, 5)]
    found = list(handfuls(rings, 10, len))
    assert sorted(ring for handful in found for ring in handful) == sorted(rings)
    assert [len(handful) for handful in found] == [2, 2, 1, 1]
    assert all(sum(map(len, handful)) <= 10 or len(handful) == 1 for handful in found)
    assert list(handfuls([], 10, len)) == []
