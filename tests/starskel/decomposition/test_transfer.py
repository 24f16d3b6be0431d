import numpy as np
import pytest

from starskel.correspondence import Correspondence
from starskel.decomposition import Decomposition, decompose
from starskel.decomposition.board import Board
from starskel.decomposition.pieces import cost
from starskel.decomposition.transfer import transfer
from starskel.decomposition.verify import faults
from starskel.errors import NoDecomposition, StarskelError
from starskel.points import points_of
from starskel.task import UNWATCHED
from tests.families import comb, related, spiral, subdivided, turned, two_opt
from tests.starskel.decomposition.stopping import check_stops


def paired(source, target) -> Correspondence:
    rows = np.arange(len(source))
    return Correspondence(source, target, (), rows, rows)


def mirrored(ring):
    return np.roll((ring * (-1, 1))[::-1], 1, axis=0)


PAIRS = {
    "random 12": (two_opt(12, 1), two_opt(12, 1001)),
    "random 24": (two_opt(24, 3), two_opt(24, 1003)),
    "related": related(20, 4),
    "grid": (two_opt(20, 5, 6), two_opt(20, 1005, 6)),
    "comb against itself shifted": (comb(4), np.roll(comb(4), 5, axis=0)),
    "spirals shifted": (spiral(20, 2), np.roll(spiral(20, 1.5), 3, axis=0)),
    "spirals of two hands": (spiral(24, 1.5), spiral(24, 1.5, -1)),
    "straight runs": (subdivided(two_opt(8, 7), 4), turned(subdivided(two_opt(8, 1006), 4), 0.5)),
    "straight runs on a grid": (subdivided(two_opt(8, 8, 5), 3), turned(subdivided(two_opt(8, 9, 5), 3), 1)),
    "one shape": (two_opt(20, 6), turned(two_opt(20, 6), 1)),
}

MOVES = {
    "as they are": lambda ring: ring,
    "turned": lambda ring: turned(ring, 0.7),
    "scaled up": lambda ring: ring * 1e6,
    "scaled down and turned": lambda ring: turned(ring * 1e-6, 2),
    "mirrored": mirrored,
}


@pytest.fixture(params=list(PAIRS))
def pair(request) -> Correspondence:
    return paired(*PAIRS[request.param])


def check(pair: Correspondence) -> Decomposition:
    decomposition = decompose(pair, algorithm="convex")
    assert faults(decomposition) == []
    return decomposition


@pytest.mark.parametrize("move", list(MOVES))
def test_every_pair_is_decomposed_wherever_it_lies(pair, move):
    check(paired(MOVES[move](pair.source), MOVES[move](pair.target)))


def test_source_and_target_may_be_swapped(pair):
    check(paired(pair.target, pair.source))


@pytest.mark.parametrize("seed", range(10))
def test_random_pairs_are_decomposed(seed):
    check(paired(two_opt(8 + 3 * seed, seed), two_opt(8 + 3 * seed, seed + 500)))


def test_parts_are_convex_in_one_polygon(pair):
    """Before they are cut into star pieces every vertex of a part sees the whole of it."""
    whole = tuple(range(len(pair)))
    board = Board(points_of(pair.source), points_of(pair.target))
    cuts, side = transfer.fewer_cuts(board, whole, UNWATCHED)
    drawn = transfer.drawn_parts(board, whole, cuts, side, UNWATCHED)
    assert len(drawn) == len(cuts) + 1
    for piece in drawn:
        ring = np.array(piece)
        assert (board.sides[side].orientation(np.roll(ring, 1), ring, np.roll(ring, -1)) >= 0).all()


def test_no_steiner_vertices_where_the_diagonals_are_common():
    decomposition = check(paired(*PAIRS["one shape"]))
    assert len(decomposition.source) == 20
    pair = paired(*PAIRS["one shape"])
    assert decompose(pair, algorithm="convex", steiner=False).pieces == decomposition.pieces


def test_without_steiner_vertices_they_are_missed_where_they_are_needed():
    pair = paired(*PAIRS["random 24"])
    assert len(check(pair).source) > 24
    with pytest.raises(NoDecomposition, match='take the algorithm "minimal"'):
        decompose(pair, algorithm="convex", steiner=False)


def test_an_unknown_algorithm_is_refused():
    with pytest.raises(
        StarskelError, match="'smallest' is given for the algorithm; give 'minimal' or 'convex'"
    ):
        decompose(paired(*PAIRS["random 12"]), algorithm="smallest")


def test_the_algorithm_by_default_is_the_minimal_one():
    pair = paired(*PAIRS["random 24"])
    assert decompose(pair).pieces == decompose(pair, algorithm="minimal").pieces


def test_steiner_vertices_stay_below_the_square_of_the_count():
    for n in (20, 40):
        source, target = spiral(n, 2), np.roll(spiral(n, 1.5), n // 7, axis=0)
        whole = tuple(range(n))
        drawn = transfer.transfer(Board(points_of(source), points_of(target)), whole, UNWATCHED)
        assert 0 < cost(drawn)[0] - n < n * n / 4


def test_equal_input_gives_equal_output(pair):
    first, second = check(pair), check(pair)
    assert first.pieces == second.pieces
    for name in ("source", "target", "source_origins", "target_origins"):
        np.testing.assert_array_equal(getattr(first, name), getattr(second, name))


def test_where_no_path_can_be_named_the_part_is_climbed(monkeypatch):
    monkeypatch.setattr(transfer, "bends_between", lambda points, rings, *_: [None] * len(rings.counts))
    check(paired(*PAIRS["random 12"]))
    check(paired(*PAIRS["grid"]))


def test_progress_rises_to_one():
    reached = []
    decompose(paired(*PAIRS["random 24"]), algorithm="convex", progress=reached.append)
    assert reached == sorted(reached)
    assert reached[-1] == 1


@pytest.mark.parametrize("calls", [0, 1, 20, 100])
def test_should_stop_ends_the_work(calls):
    check_stops(
        lambda should_stop: decompose(
            paired(*PAIRS["random 24"]), algorithm="convex", should_stop=should_stop
        ),
        calls,
    )
