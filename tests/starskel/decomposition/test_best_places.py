import numpy as np
import pytest

from starskel.decomposition.board import Board
from starskel.decomposition.kernels.kernel import star_points
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.moves.best_places import best_places, kernels_of_chains
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import UNWATCHED, Task
from tests.families import two_opt

SQUARE = np.array([(0, 0), (2, 0), (2, 2), (0, 2)], dtype=float)


def test_chains_end_at_the_boxes_of_their_owners():
    ends = np.array([[0, 2 + 0j, 2 + 2j, 0 + 1j, 0j]])
    chains = Rings(np.arange(5), np.array([3, 2]))
    cells = kernels_of_chains(ends, chains, np.array([0, 0]), UNWATCHED)
    np.testing.assert_allclose(cells.measured()[1], (4, 4))
    alone = kernels_of_chains(np.tile(ends, (2, 1)), chains, np.array([0, 1]), UNWATCHED)
    np.testing.assert_allclose(alone.measured()[1], (4, 0, 4, 0))


def test_the_middles_and_gains_are_those_of_the_pieces_with_the_vertex_there():
    board = Board(points_of(SQUARE), points_of(SQUARE))
    (centre,) = board.place(np.array([(0.3, 0.4)]), np.array([(1.2, 0.9)]))
    near = [(0, 1, centre), (1, 2, 3, centre), (3, 0, centre)]
    best = best_places(board, {centre: near}, 0.4, UNWATCHED)
    for side in (0, 1):
        stayed, worth = kernels(board, side, near)
        np.testing.assert_allclose(best.stayed[side], stayed)
        moved = Board(board.sides[0], board.sides[1])
        (placed,) = moved.place(*(best.places[[side]][:, 0] for _ in range(2)))
        middles, better = kernels(moved, side, [(0, 1, placed), (1, 2, 3, placed), (3, 0, placed)])
        np.testing.assert_allclose(best.moved[side], middles)
        assert best.gains[side, 0] == pytest.approx(min(better) / min(worth))
    assert best.gains.max() > 1.5


def test_vertices_tried_a_few_at_a_time_fare_as_all_at_once(monkeypatch):
    ring = two_opt(80, 1)
    board = Board(points_of(ring), points_of(two_opt(80, 1001)))
    (pieces,) = climb(board, [tuple(range(80))], by_fan, UNWATCHED)
    around = {v: [p for p in pieces if v in p] for v in range(80, len(board)) if any(v in p for p in pieces)}
    together = best_places(board, around, 0.25, UNWATCHED)
    monkeypatch.setattr("starskel.decomposition.moves.best_places.AT_ONCE", 40)
    polls: list[None] = []
    apart = best_places(board, around, 0.25, Task(should_stop=lambda: bool(polls.append(None))))
    assert len(around) > 5
    assert len(polls) > sum(map(len, around.values())) * 3 // 40
    for name in ("places", "gains", "stayed", "moved"):
        np.testing.assert_array_equal(getattr(together, name), getattr(apart, name))


def kernels(board, side, pieces):
    """The middles of kernels, and their areas over the squared perimeters of the pieces."""
    ((places, areas),) = star_points([board.sides[side]], Rings.of(pieces))
    rings = [board.sides[side].coordinates[list(piece)] for piece in pieces]
    perimeters = [np.hypot(*(ring - np.roll(ring, 1, axis=0)).T).sum() for ring in rings]
    return places.view(np.complex128)[:, 0], areas / np.square(perimeters)
