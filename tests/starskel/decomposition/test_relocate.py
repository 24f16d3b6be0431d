import numpy as np
import pytest

from starskel.decomposition.board import Board
from starskel.decomposition.kernels.kernel import star_points
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.moves.relocate import relocated
from starskel.errors import Cancelled
from starskel.outline import edge_lengths, signed_areas
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import UNWATCHED, Task
from tests.families import two_opt

SEEDS = [2, 3, 4, 5]


def climbed(seed):
    source, target = two_opt(20, seed), two_opt(20, seed + 1000)
    board = Board(points_of(source), points_of(target))
    return board, climb(board, [tuple(range(20))], by_fan, UNWATCHED)[0]


def reshaped(seed):
    board, pieces = climbed(seed)
    return board, relocated(board, pieces, UNWATCHED)


def roundness(board, pieces):
    """The area of each kernel, in the source and in the target, over the square of its piece's perimeter."""
    rings = [np.array(piece) for piece in pieces]
    sides = []
    for points, (_, areas) in zip(board.sides, star_points(board.sides, Rings.of(rings)), strict=True):
        sides.append(areas / [edge_lengths(points.coordinates[ring]).sum() ** 2 for ring in rings])
    return np.array(sides)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_smallest_kernels_grow(seed):
    board, before = climbed(seed)
    after = relocated(board, before, UNWATCHED)
    assert len(after) == len(before)
    assert (roundness(board, after).min(axis=1) >= roundness(board, before).min(axis=1)).all()
    assert (roundness(board, after) > 0).all()


def test_some_grow_by_much():
    gains = [roundness(*reshaped(s)).min() / roundness(*climbed(s)).min() for s in SEEDS]
    assert max(gains) > 3


@pytest.mark.parametrize("seed", SEEDS)
def test_the_pieces_still_tile_both_polygons(seed):
    board, pieces = reshaped(seed)
    for points in board.sides:
        whole = signed_areas(points.coordinates[:20])
        parts = [signed_areas(points.coordinates[list(piece)]) for piece in pieces]
        assert min(parts) > 0
        assert sum(parts) == pytest.approx(float(whole), rel=1e-9)


def test_what_has_no_steiner_vertex_stays_as_it_is():
    ring = points_of(two_opt(12, 1))
    pieces = [tuple(range(12))]
    assert relocated(Board(ring, ring), pieces, UNWATCHED) is pieces


def test_it_can_be_stopped():
    with pytest.raises(Cancelled):
        relocated(*climbed(2), Task(should_stop=lambda: True))
