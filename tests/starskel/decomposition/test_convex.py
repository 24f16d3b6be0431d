from itertools import combinations

import numpy as np
import pytest

from starskel.decomposition.transfer import convex
from starskel.decomposition.transfer.convex import convex_cuts
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import UNWATCHED
from starskel.triangulation import triangulate
from starskel.visibility import visibility
from tests.families import blob, comb, spiral, subdivided, turned, two_opt
from tests.starskel.decomposition.exhaustive import cut


def ground(ring):
    return triangulate(points_of(ring), Rings.of([range(len(ring))]))


def by_length(ring):
    x, y = ring.T
    length = np.hypot(x[:, None] - x, y[:, None] - y)
    return table(length / (2 * len(ring) * length.max()))


def table(prices):
    return lambda i, j: prices[i, j]


def cuts_of(ring):
    base = ground(ring)
    return convex_cuts(base, visibility(base), by_length(ring), UNWATCHED)


def is_convex(points, piece) -> bool:
    ring = np.array(piece)
    return bool((points.orientation(np.roll(ring, 1), ring, np.roll(ring, -1)) >= 0).all())


def are_convex_pieces(ring, cuts) -> bool:
    pieces = cut(tuple(range(len(ring))), cuts)
    return len(pieces) == len(cuts) + 1 and all(is_convex(points_of(ring), piece) for piece in pieces)


def fewest_by_search(ring) -> int:
    n = len(ring)
    diagonal = visibility(ground(ring)).diagonal
    diagonals = [(i, j) for i, j in combinations(range(n), 2) if diagonal[i, j]]

    def ways(count, rest, chosen=()):
        if count == 0:
            yield chosen
            return
        for at, (i, j) in enumerate(rest):
            if not any(i < k < j < m or k < i < m < j for k, m in chosen):
                yield from ways(count - 1, rest[at + 1 :], (*chosen, (i, j)))

    return next(
        count for count in range(n) if any(are_convex_pieces(ring, way) for way in ways(count, diagonals))
    )


FAMILIES = {
    "random": lambda seed: two_opt(9, seed),
    "grid": lambda seed: two_opt(9, seed, 4),
    "turned grid": lambda seed: turned(two_opt(9, seed, 4), 0.5),
    "straight runs": lambda seed: subdivided(two_opt(5, seed, 4), 2),
    "rounded straight runs": lambda seed: turned(subdivided(two_opt(5, seed, 4), 2), 0.3),
}


@pytest.mark.parametrize("family", list(FAMILIES))
def test_the_count_equals_that_of_exhaustive_search(family):
    for seed in range(16):
        ring = FAMILIES[family](seed)
        cuts = cuts_of(ring)
        assert are_convex_pieces(ring, cuts)
        assert len(cuts) == fewest_by_search(ring), seed


RINGS = {
    "random": two_opt(60, 1),
    "grid": two_opt(40, 2, 9),
    "comb": comb(8),
    "spiral": spiral(80),
    "blob": blob(100),
    "straight runs": turned(subdivided(two_opt(12, 3), 4), 0.4),
}


@pytest.mark.parametrize("name", list(RINGS))
def test_large_polygons_get_convex_pieces_too_at_most_four_times_the_fewest(name, monkeypatch):
    ring = RINGS[name]
    fewest = cuts_of(ring)
    monkeypatch.setattr(convex, "FEWEST", 0)
    few = cuts_of(ring)
    assert are_convex_pieces(ring, fewest)
    assert are_convex_pieces(ring, few)
    assert len(fewest) + 1 <= len(few) + 1 <= 4 * (len(fewest) + 1)
    diagonal = visibility(ground(ring)).diagonal
    assert all(diagonal[a, b] for a, b in [*fewest, *few])


def test_a_cross_is_cut_straight_through():
    """Two cuts do, where the piece between them has four straight angles."""
    ring = np.array(
        [(4, 0), (5, 0), (5, 4), (9, 4), (9, 5), (5, 5), (5, 9), (4, 9), (4, 5), (0, 5), (0, 4), (4, 4)],
        dtype=float,
    )
    assert sorted(cuts_of(ring)) in ([(2, 5), (8, 11)], [(2, 11), (5, 8)])


def test_of_equally_few_cuts_the_cheaper_are_taken():
    arrow = np.array([(0, 0), (4, 3), (8, 0), (4, 9)], dtype=float)
    notched = np.array([(0, 0), (4, 3), (8, 0), (8, 9), (0, 9)], dtype=float)
    assert cuts_of(arrow) == [(1, 3)]
    base = ground(notched)
    for dear, cheap in (((1, 3), (1, 4)), ((1, 4), (1, 3))):
        price = np.zeros((5, 5))
        price[dear] = price[dear[::-1]] = 0.1
        assert convex_cuts(base, visibility(base), table(price), UNWATCHED) == [cheap]
