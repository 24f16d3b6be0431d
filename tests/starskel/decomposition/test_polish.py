import pytest

from starskel.decomposition import decompose, polish
from starskel.decomposition.board import Board
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.pieces import cost
from starskel.decomposition.polish import polished
from starskel.decomposition.verify import faults
from starskel.errors import Cancelled
from starskel.points import points_of
from starskel.task import UNWATCHED, Task
from tests.families import two_opt
from tests.starskel.decomposition.test_decompose import paired

SEEDS = [2, 3, 5, 7, 11]


def climbed(seed):
    board = Board(*(points_of(two_opt(20, s)) for s in (seed, seed + 1000)))
    return board, climb(board, [tuple(range(20))], by_fan, UNWATCHED)[0]


def test_parts_tiled_anew_cost_less_and_never_more(monkeypatch):
    anew = [cost(polished(*climbed(seed), UNWATCHED)) for seed in SEEDS]
    monkeypatch.setattr(polish, "FEW", -1)
    once = [cost(polished(*climbed(seed), UNWATCHED)) for seed in SEEDS]
    assert all(a <= b for a, b in zip(anew, once, strict=True))
    assert sum(vertices for vertices, _ in anew) < sum(vertices for vertices, _ in once)


@pytest.mark.parametrize("seed", [1, 3, 5])
def test_what_is_tiled_anew_is_proven(seed):
    assert faults(decompose(paired(two_opt(40, seed), two_opt(40, seed + 1000)))) == []


def test_what_needs_no_steiner_vertex_stays_whole():
    ring = points_of(two_opt(12, 1))
    assert polished(Board(ring, ring), [tuple(range(12))], UNWATCHED) == [tuple(range(12))]


def test_tiling_anew_can_be_stopped():
    board, pieces = climbed(2)
    with pytest.raises(Cancelled):
        polish._tiled_anew(board, pieces, set(), Task(should_stop=lambda: True))
