import numpy as np

from starskel.decomposition.board import Board
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.moves.collapse import collapses
from starskel.decomposition.pieces import edges_of, from_least
from starskel.points import points_of
from starskel.task import UNWATCHED
from tests.families import two_opt

SQUARE = np.array([(0, 0), (2, 0), (2, 2), (0, 2)], dtype=float)
CORNER = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], dtype=float)


def fan(ring, centre, rows):
    """A board of twice the same ring, a vertex placed in it, and the triangles between it and an outline."""
    board = Board(points_of(ring), points_of(ring))
    (placed,) = board.place(np.array([centre]), np.array([centre]))
    return board, (placed, tuple((placed, a, b) for a, b in edges_of(tuple(rows))))


def outcomes(board, star):
    return {frozenset(pieces) for pieces in collapses(board, [star], UNWATCHED)[star]}


def test_in_a_square_the_centre_may_go_to_every_corner():
    board, star = fan(SQUARE, (0.9, 1.1), range(4))
    halves = [
        {(0, 1, 2), (0, 2, 3)},
        {(0, 1, 3), (1, 2, 3)},
    ]
    assert outcomes(board, star) == {frozenset(half) for half in halves}
    assert len(collapses(board, [star], UNWATCHED)[star]) == 4


def test_round_a_corner_the_centre_may_go_only_to_what_sees_the_whole():
    """The reflex vertex and the one opposite to it; from elsewhere a triangle would turn over."""
    board, star = fan(CORNER, (0.6, 0.5), range(6))
    found = collapses(board, [star], UNWATCHED)[star]
    assert {frozenset.intersection(*map(frozenset, pieces)) for pieces in found} == {
        frozenset({0}),
        frozenset({3}),
    }


def test_what_is_left_is_star_shaped_and_has_the_same_outline():
    board = Board(points_of(two_opt(30, 4)), points_of(two_opt(30, 1004)))
    (pieces,) = climb(board, [tuple(range(30))], by_fan, UNWATCHED)
    stars = [
        (vertex, tuple(piece for piece in pieces if vertex in piece))
        for vertex in range(board.n, len(board))
        if any(vertex in piece for piece in pieces)
    ]
    found = collapses(board, stars, UNWATCHED)
    assert sum(map(len, found.values())) > 0
    for (vertex, around), outcomes in found.items():
        for after in outcomes:
            assert vertex not in set().union(*after)
            assert all(board.have_kernels(after, UNWATCHED))
            assert tuple(map(from_least, after)) == after
            assert all(len(set(piece)) == len(piece) for piece in after)
            assert outline(after) == outline(around)


def outline(pieces):
    edges = {edge for piece in pieces for edge in edges_of(piece)}
    return {(a, b) for a, b in edges if (b, a) not in edges}


def test_stars_that_are_looked_at_together_are_as_they_are_alone():
    first = fan(SQUARE, (0.9, 1.1), range(4))
    board, star = first
    (other,) = board.place(np.array([(1.5, 0.4)]), np.array([(1.5, 0.4)]))
    second = (other, tuple((other, a, b) for a, b in edges_of((0, 1, 2))))
    together = collapses(board, [star, second], UNWATCHED)
    assert together == {**collapses(board, [star], UNWATCHED), **collapses(board, [second], UNWATCHED)}
    assert collapses(board, [], UNWATCHED) == {}
