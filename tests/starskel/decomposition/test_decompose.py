from dataclasses import replace

import numpy as np
import pytest

from starskel.correspondence import Correspondence, match
from starskel.decomposition import Decomposition, decompose
from starskel.decomposition.board import Board
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.overlay import crossings, overlay
from starskel.decomposition.pieces import Piece, cost, from_least
from starskel.decomposition.verify import faults
from starskel.errors import NoDecomposition
from starskel.points import points_of
from starskel.task import Task
from tests.families import blob, comb, related, spiral, subdivided, turned, two_opt
from tests.starskel.decomposition.stopping import check_stops


def paired(source, target) -> Correspondence:
    rows = np.arange(len(source))
    return Correspondence(source, target, (), rows, rows)


def uncut(source, target) -> tuple[Board, Piece]:
    return Board(points_of(source), points_of(target)), tuple(range(len(source)))


def mirrored(ring):
    return np.roll((ring * (-1, 1))[::-1], 1, axis=0)


PAIRS = {
    "random 12": (two_opt(12, 1), two_opt(12, 1001)),
    "random 20": (two_opt(20, 2), two_opt(20, 1002)),
    "random 40": (two_opt(40, 3), two_opt(40, 1003)),
    "related": related(20, 4),
    "grid": (two_opt(20, 5, 6), two_opt(20, 1005, 6)),
    "fine grid": (two_opt(30, 5, 12), two_opt(30, 1005, 12)),
    "comb against itself shifted": (comb(4), np.roll(comb(4), 5, axis=0)),
    "spirals": (spiral(40, 2), spiral(40, 1.2)),
    "spirals of two hands": (spiral(24, 1.5), spiral(24, 1.5, -1)),
    "straight runs": (subdivided(two_opt(8, 6), 4), turned(subdivided(two_opt(8, 1006), 4), 0.5)),
    "blobs": (blob(100, 1), blob(100, 2)),
    "triangles": (np.array([(0, 0), (1, 0), (0, 1.0)]), np.array([(0, 0), (5, 0), (9, 0.1)])),
}


@pytest.fixture(params=list(PAIRS))
def pair(request) -> Correspondence:
    return paired(*PAIRS[request.param])


def check(pair: Correspondence) -> Decomposition:
    decomposition = decompose(pair)
    assert faults(decomposition) == []
    return decomposition


MOVES = {
    "moved": lambda ring: ring + np.array((1e6, -3)),
    "turned": lambda ring: turned(ring, 0.7),
    "scaled up": lambda ring: ring * 1e6,
    "scaled down": lambda ring: ring * 1e-6,
    "mirrored": mirrored,
    "start shifted": lambda ring: np.roll(ring, 3, axis=0),
}


@pytest.mark.parametrize("move", list(MOVES))
def test_every_pair_is_decomposed_wherever_it_lies(pair, move):
    check(paired(MOVES[move](pair.source), MOVES[move](pair.target)))


@pytest.mark.parametrize("move", list(MOVES))
def test_the_fewest_pieces_are_as_few_wherever_the_pair_lies(move):
    source, target = blob(60, 1), blob(60, 2)
    moved = decompose(paired(MOVES[move](source), MOVES[move](target)), steiner=False)
    assert len(moved.pieces) == len(decompose(paired(source, target), steiner=False).pieces)


def test_swapping_the_polygons_and_shifting_the_start_give_the_same_pieces(pair):
    n = len(pair)
    there, back = check(pair), check(paired(np.roll(pair.target, 2, axis=0), np.roll(pair.source, 2, axis=0)))

    assert back.pieces == tuple(tuple((v + 2) % n if v < n else v for v in p) for p in there.pieces)
    np.testing.assert_array_equal(back.target[n:], there.source[n:])
    np.testing.assert_array_equal(back.source_origins, there.target_origins)


def test_pairs_of_files_are_decomposed_without_fault(shape_pair):
    check(match(shape_pair.source, shape_pair.target, shape_pair.marks))


def test_equal_input_gives_equal_output(pair):
    first, second = decompose(pair), decompose(pair)
    assert first.pieces == second.pieces
    for name in ("source", "target", "source_origins", "target_origins"):
        np.testing.assert_array_equal(getattr(first, name), getattr(second, name))


def test_one_star_piece_where_a_vertex_sees_all_of_both():
    square = np.array([(0, 0), (2, 0), (2, 2), (0, 2)], dtype=float)
    decomposition = check(paired(square, square * 3))
    assert [from_least(piece) for piece in decomposition.pieces] == [(0, 1, 2, 3)]
    np.testing.assert_array_equal(decomposition.target_origins, [(3, 3)])


def test_one_piece_where_both_are_stars_that_no_vertex_sees_whole():
    """A five-pointed star: its kernel is the pentagon inside, without a corner of the star."""
    angles = np.pi * (np.arange(10) / 5 + 0.5)
    radii = np.where(np.arange(10) % 2, 0.3, 1.0)
    star = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    decomposition = decompose(paired(star, 2 * star), steiner=False)
    assert faults(decomposition) == []
    assert len(decomposition.pieces) == 1
    np.testing.assert_allclose(decomposition.source_origins, [(0, 0)], atol=1e-12)


EIGHT = (
    np.array([(0, 0), (6, 0), (6, 2), (2, 2), (2, 4), (6, 4), (6, 6), (0, 6)], dtype=float),
    np.array([(0, 6), (0, 4), (4, 4), (4, 2), (0, 2), (0, 0), (6, 0), (6, 6)], dtype=float),
)


def test_without_steiner_vertices_some_pairs_have_no_decomposition():
    """As in the paper's Figure 8: no diagonal of the one is a diagonal of the other."""
    pair = paired(*EIGHT)
    with pytest.raises(NoDecomposition, match="without Steiner vertices"):
        decompose(pair, steiner=False)
    decomposition = check(pair)
    assert len(decomposition.source) - 8 <= 2
    assert len(decomposition.pieces) <= 4


@pytest.mark.parametrize("seed", range(5))
def test_the_overlay_alone_is_a_decomposition(seed):
    source, target = two_opt(16, seed), two_opt(16, seed + 1000)
    board, whole = uncut(source, target)
    both = board.triangulated([whole], Task())
    pieces = overlay(board, whole, *both)
    sides = [side.coordinates for side in board.sides]
    assert len(sides[0]) - 16 == crossings(*both)[0] > 0
    origins = [np.array([side[list(p)].mean(axis=0) for p in pieces]) for side in sides]
    assert faults(Decomposition(paired(source, target), *sides, tuple(pieces), *origins)) == []


def test_crossings_are_counted_for_each_ring():
    board, whole = uncut(two_opt(20, 2), two_opt(20, 1002))
    cells = [whole, *(piece for piece in climb(board, [whole], by_fan, Task())[0] if max(piece) < 20)]
    assert len(cells) > 2
    alone = [crossings(*board.triangulated([cell], Task()))[0] for cell in cells]
    assert crossings(*board.triangulated(cells, Task())) == alone


def test_the_ladder_needs_fewer_steiner_vertices_than_the_overlay():
    climbed, laid = 0, 0
    for seed in range(8):
        source, target = two_opt(20, seed), two_opt(20, seed + 1000)
        board, whole = uncut(source, target)
        (needed,) = crossings(*board.triangulated([whole], Task()))
        placed = cost(climb(board, [whole], by_fan, Task())[0])[0] - 20
        assert placed <= needed
        climbed, laid = climbed + placed, laid + needed
    assert climbed * 5 < laid


def test_progress_rises_to_one():
    reached = []
    decompose(paired(*PAIRS["random 20"]), progress=reached.append)
    assert reached == sorted(reached)
    assert reached[-1] == 1


@pytest.mark.parametrize("calls", [0, 1, 20])
def test_should_stop_ends_the_work(calls):
    check_stops(lambda should_stop: decompose(paired(*PAIRS["random 40"]), should_stop=should_stop), calls)


class TestProof:
    """verify.py finds what is wrong with deliberately broken decompositions."""

    @pytest.fixture
    def right(self) -> Decomposition:
        return check(paired(*PAIRS["random 20"]))

    def test_a_missing_piece(self, right):
        broken = replace(
            right,
            pieces=right.pieces[1:],
            source_origins=right.source_origins[1:],
            target_origins=right.target_origins[1:],
        )
        assert any("is in no piece" in fault or "has no partner" in fault for fault in faults(broken))

    def test_a_piece_that_stands_twice(self, right):
        broken = replace(
            right,
            pieces=(*right.pieces, right.pieces[0]),
            source_origins=np.concatenate([right.source_origins, right.source_origins[:1]]),
            target_origins=np.concatenate([right.target_origins, right.target_origins[:1]]),
        )
        assert any("stands 2 times" in fault for fault in faults(broken))

    def test_a_clockwise_piece(self, right):
        broken = replace(right, pieces=(right.pieces[0][::-1], *right.pieces[1:]))
        assert any("not counter-clockwise" in fault for fault in faults(broken))

    def test_a_piece_without_area(self):
        square = np.array([(0, 0), (1, 0), (2, 0), (3, 0), (3, 3), (0, 3)], dtype=float)
        right = check(paired(square, square))
        flat = replace(
            right,
            pieces=((0, 1, 2, 3), (0, 3, 4, 5)),
            source_origins=np.repeat(right.source_origins, 2, axis=0),
            target_origins=np.repeat(right.target_origins, 2, axis=0),
        )
        assert any("has no area" in fault for fault in faults(flat))

    def test_an_origin_outside_the_kernel(self, right):
        origins = right.target_origins.copy()
        origins[0] += 1000
        assert any("not seen whole" in fault for fault in faults(replace(right, target_origins=origins)))

    def test_a_missing_origin(self, right):
        assert any(
            "origins for" in fault
            for fault in faults(replace(right, source_origins=right.source_origins[1:]))
        )

    def test_vertices_that_are_not_the_polygons(self, right):
        source = right.source.copy()
        source[0] += 1e-9
        assert any("first vertices" in fault for fault in faults(replace(right, source=source)))

    def test_a_piece_that_crosses_itself(self, right):
        piece = max(right.pieces, key=len)
        crossed = (*piece[::2], *piece[1::2])
        pieces = tuple(crossed if p == piece else p for p in right.pieces)
        assert any(
            "not simple" in fault or "not counter" in fault for fault in faults(replace(right, pieces=pieces))
        )

    def test_pieces_merged_beyond_what_a_star_can_be(self, right):
        whole = replace(
            right,
            pieces=(tuple(range(20)),),
            source_origins=right.source_origins[:1],
            target_origins=right.target_origins[:1],
        )
        assert any("not seen whole" in fault for fault in faults(whole))


def test_a_piece_seen_from_one_vertex_alone_is_not_reshaped():
    source, target = two_opt(36, 1974161621, 10), two_opt(36, 582411916, 10)
    assert faults(decompose(paired(source, target))) == []


def test_pieces_of_many_straight_vertices_have_origins_as_they_have_alone():
    source, target = (subdivided(two_opt(18, seed), 5) for seed in (668752726, 2142439354))
    assert faults(decompose(paired(source, target))) == []


def test_no_piece_is_kept_whose_kernel_is_a_matter_of_rounding():
    source, target = two_opt(101, 1832938933, 17), two_opt(101, 1125356237, 17)
    assert faults(decompose(paired(source, target))) == []
