import numpy as np
import pytest

from starskel.decomposition.links import links_of
from starskel.decomposition.minimal import least_stuck_cells, minimal_pieces
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import triangulate
from tests.families import related, turned, two_opt
from tests.starskel.decomposition.exhaustive import (
    fewest_pieces,
    least_stuck,
    pairs_of_ring,
    price,
    stuck_cost,
)


def links(source, target):
    whole = Rings.of([range(len(source))])
    return links_of(*(triangulate(points_of(ring), whole) for ring in (source, target)), Task())


def pair(kind, seed):
    if kind == "related":
        return related(9, seed)
    if kind == "one shape":
        return two_opt(9, seed), turned(two_opt(9, seed), 1)
    n, grid = {"random": (8, 0), "grid": (9, 4), "wide grid": (9, 6)}[kind]
    return two_opt(n, seed, grid), two_opt(n, seed + 1000, grid)


@pytest.mark.parametrize("kind", ["random", "grid", "wide grid", "related", "one shape"])
def test_the_fewest_pieces_and_the_shortest_cuts_are_those_of_exhaustive_search(kind):
    for seed in range(80):
        common = links(*pair(kind, seed))
        pieces = minimal_pieces(common, Task())
        expected = fewest_pieces(common)
        if expected is None:
            assert pieces is None, seed
        else:
            cuts = set.union(*map(pairs_of_ring, pieces)) - pairs_of_ring(range(len(common.sees)))
            assert (len(pieces), price(common, cuts)) == pytest.approx(expected, rel=1e-12), seed


def triangulable(links) -> bool:
    """Whether common diagonals triangulate both polygons, by a program of its own."""
    n = len(links.sees)
    cut = links.diagonal | np.eye(n, k=1, dtype=bool)
    cut[0, n - 1] = True
    done = np.eye(n, k=1, dtype=bool)
    for span in range(2, n):
        for i in range(n - span):
            done[i, i + span] = cut[i, i + span] and (done[i] & done[:, i + span]).any()
    return bool(done[0, n - 1])


@pytest.mark.parametrize("n", [10, 16, 24, 40])
def test_there_is_a_decomposition_exactly_where_common_diagonals_triangulate(n):
    answers = set()
    for seed in range(24):
        common = links(*related(n, seed, spread=1.0))
        answers.add(triangulable(common))
        assert (minimal_pieces(common, Task()) is not None) == triangulable(common), seed
    assert answers == {True, False}


@pytest.mark.parametrize("n", [30, 60])
def test_pieces_are_bounded_by_links_and_have_a_common_star_vertex(n):
    for seed in range(4):
        source = two_opt(n, seed)
        common = links(source, source)
        pieces = minimal_pieces(common, Task())
        assert pieces is not None
        for piece in pieces:
            assert common.sees[np.ix_(piece, piece)].all(axis=1).any()
            inner = pairs_of_ring(piece) - pairs_of_ring(range(n))
            assert all(common.diagonal[a, b] for a, b in inner)


@pytest.mark.parametrize("kind", ["random", "grid", "wide grid"])
def test_stuck_cells_are_as_small_as_exhaustive_search_finds_them(kind):
    stuck = 0
    for seed in range(30):
        common = links(*pair(kind, seed))
        cells = least_stuck_cells(common, Task())[0]
        cuts = set.union(*map(pairs_of_ring, cells)) - pairs_of_ring(range(len(common.sees)))
        cost = stuck_cost(common, cells) + price(common, cuts)
        assert cost == pytest.approx(least_stuck(common), rel=1e-12), seed
        stuck += cost >= len(common.sees)
    assert stuck > 3


@pytest.mark.parametrize("seed", range(5))
def test_stuck_cells_and_star_pieces_tile_together(seed):
    source, target = two_opt(20, seed), two_opt(20, seed + 1000)
    common = links(source, target)
    cells = least_stuck_cells(common, Task())[0]
    edges = [edge for cell in cells for edge in zip(cell, (*cell[1:], cell[0]), strict=True)]
    assert len(set(edges)) == len(edges)
    assert {(a, b) for a, b in edges if (b, a) not in edges} == {(i, (i + 1) % 20) for i in range(20)}


def test_rings_that_are_cut_together_are_cut_as_each_is_alone():
    source, target = two_opt(20, 2), two_opt(20, 1002)
    cells = least_stuck_cells(links(source, target), Task())[0]
    assert len(cells) > 2
    sides = points_of(source), points_of(target)

    def cut(*rings):
        grounds = (triangulate(side, Rings.of(rings)) for side in sides)
        return least_stuck_cells(links_of(*grounds, Task()), Task())

    assert cut(*cells, range(20)) == [cut(cell)[0] for cell in (*cells, range(20))]


def test_the_same_input_gives_the_same_pieces():
    source = two_opt(40, 3)
    first, second = (minimal_pieces(links(source, source), Task()) for _ in range(2))
    assert first == second
