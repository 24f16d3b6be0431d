from itertools import combinations

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

import starskel
from starskel.correspondence import match
from starskel.correspondence.alignment import (
    ALONE_PRICE,
    TURN_PRICE,
    Chain,
    ChainPrices,
    align,
    alignment_prices,
)
from starskel.correspondence.insertion import inserted, merged
from starskel.crossings import crossing_edges
from starskel.errors import Cancelled, InvalidMarks, InvalidPolygon
from starskel.outline import edge_lengths
from starskel.polygon import Polygon
from starskel.task import Task
from tests.families import blob, related, spiral, subdivided, turned, two_opt

TRIANGLE = np.array([(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)])
SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])


def own_rows(vertices):
    return vertices[vertices >= 0]


def check(pair, source, target, marks=()):
    """What holds for every complete correspondence."""
    for rows, vertices, ring in (
        (pair.source, pair.source_vertices, Polygon(source).vertices),
        (pair.target, pair.target_vertices, Polygon(target).vertices),
    ):
        assert rows.shape == (len(pair), 2)
        np.testing.assert_array_equal(rows[vertices >= 0], ring[own_rows(vertices)])
        first = int(own_rows(vertices)[0])
        np.testing.assert_array_equal(own_rows(vertices), (first + np.arange(len(ring))) % len(ring))
        assert not len(crossing_edges(rows))
        assert len(np.unique(rows, axis=0)) == len(rows)
        assert abs(edge_lengths(rows).sum() / edge_lengths(ring).sum() - 1) < 1e-12
    assert pair.source_vertices[0] == 0
    assert not ((pair.source_vertices < 0) & (pair.target_vertices < 0)).any()
    together = set(zip(pair.source_vertices.tolist(), pair.target_vertices.tolist(), strict=True))
    at = Polygon(source).vertex_of, Polygon(target).vertex_of
    assert {(at[0](i), at[1](j)) for i, j in marks} <= together


def pairs_of(pair):
    """The pairs of points, without their order."""
    return {(tuple(a), tuple(b)) for a, b in zip(pair.source.tolist(), pair.target.tolist(), strict=True)}


@pytest.mark.parametrize("ring", [TRIANGLE, SQUARE, spiral(40), blob(60), subdivided(SQUARE, 7)])
def test_a_shape_matched_with_itself_gives_the_identity(ring):
    for marks in ([], [(0, 0)], [(0, 0), (2, 2)]):
        pair = match(ring, ring, marks)
        np.testing.assert_array_equal(pair.source, ring)
        np.testing.assert_array_equal(pair.target, ring)
        np.testing.assert_array_equal(pair.source_vertices, np.arange(len(ring)))
        np.testing.assert_array_equal(pair.target_vertices, np.arange(len(ring)))


@given(
    st.integers(4, 12),
    st.integers(4, 12),
    st.integers(0, 50),
    st.lists(st.integers(0, 11)),
    st.integers(0, 11),
)
def test_whatever_the_marks_all_vertices_are_kept_and_new_ones_lie_on_edges(n, m, seed, chosen, shift):
    source, target = two_opt(n, seed), two_opt(m, seed + 100)
    marked = sorted({i % min(n, m) for i in chosen})
    marks = [(i, (j + shift) % m) for i, j in zip(marked, marked, strict=True)]
    check(match(source, target, marks), source, target, marks)


def test_real_pairs_are_completed(shape_pair):
    pair = match(shape_pair.source, shape_pair.target, shape_pair.marks)
    check(pair, shape_pair.source.vertices, shape_pair.target.vertices, shape_pair.marks)
    assert pair.marks == shape_pair.marks


@given(st.integers(3, 12), st.integers(3, 12), st.integers(0, 30), st.booleans())
def test_exchanging_the_shapes_gives_the_same_pairs_of_points(n, m, seed, marked):
    source, target = two_opt(n, seed), two_opt(m, seed + 100)
    marks = [(0, 1), (2, 2)] if marked else []
    back = match(target, source, [(j, i) for i, j in marks])
    assert pairs_of(match(source, target, marks)) == {(a, b) for b, a in pairs_of(back)}


def test_a_vertex_without_a_partner_gets_one_by_edge_lengths():
    wedge = np.array([(0.0, 0.0), (3.0, 0.0), (4.0, 1.0), (0.0, 3.0)])
    pair = match(TRIANGLE, wedge, [(0, 0), (1, 2), (2, 3)])
    np.testing.assert_array_equal(pair.source_vertices, [0, -1, 1, 2])
    np.testing.assert_array_equal(pair.target_vertices, [0, 1, 2, 3])
    np.testing.assert_allclose(pair.source[1], [4 * 3 / (3 + np.sqrt(2)), 0], rtol=1e-15)


def test_vertices_left_alone_on_both_sides_are_ordered_by_their_share():
    """Shares that differ by more than any turn are not matched: here .1 on one side and .9 on the other."""
    source = np.array([(0.0, 0.0), (1.0, -0.05), (10.0, 0.0), (5.0, 8.0)])
    target = np.array([(0.0, 0.0), (9.0, -0.05), (10.0, 0.0), (5.0, 8.0)])
    pair = match(source, target, [(0, 0), (2, 2), (3, 3)])
    np.testing.assert_array_equal(pair.source_vertices, [0, 1, -1, 2, 3])
    np.testing.assert_array_equal(pair.target_vertices, [0, -1, 1, 2, 3])
    check(pair, source, target)


def test_vertices_left_alone_at_the_same_share_become_partners():
    """They must not coincide with each other's new partners."""
    source = np.array([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 5.0)])
    target = np.array([(0.0, 0.0), (3.0, 0.0), (6.0, 0.0), (0.0, 4.0)])
    rows = merged((source, target), np.array([(0, 0), (2, 2), (3, 3)], dtype=np.intp))
    np.testing.assert_array_equal(rows.vertices, [[0, 1, 2, 3], [0, 1, 2, 3]])
    target[1] = 3.5, 0.0
    rows = merged((source, target), np.array([(0, 0), (2, 2), (3, 3)], dtype=np.intp))
    np.testing.assert_array_equal(rows.vertices, [[0, 1, -1, 2, 3], [0, -1, 1, 2, 3]])
    np.testing.assert_array_equal(inserted(target, rows, 1)[1], [3, 0])


def zigzag(teeth):
    """A ring with many vertices between vertex 0 and the last but one."""
    xs = np.arange(1, teeth) / teeth
    lower = np.stack([xs, -0.001 * (np.arange(1, teeth) % 2 + 1)], axis=1)
    return np.concatenate([[(0.0, 0.0)], lower, [(1.0, 0.0), (0.5, 1.0)]])


def test_many_new_vertices_fit_on_a_tiny_edge_or_are_refused():
    step = 2.0**-52  # of the numbers from 1 to 2
    for width in (256, 64, 40):
        target = np.array([(1.0, 1.0), (1.0 + width * step, 1.0), (1.0, 2.0)])
        check(match(zigzag(8), target, [(0, 0), (8, 1), (9, 2)]), zigzag(8), target)
    with pytest.raises(InvalidPolygon, match=r"^source: the edge from vertex 0 at .* too short"):
        match(target, zigzag(60), [(0, 0), (1, 60), (2, 61)])
    with pytest.raises(InvalidPolygon, match=r"^target: the edge from vertex 0 at .* too short") as error:
        match(zigzag(60), target, [(0, 0), (60, 1), (61, 2)])
    assert error.value.vertices == (0,)


def test_given_orders_and_types_do_not_matter():
    source, target = two_opt(9, 1), two_opt(11, 2)
    expected = match(Polygon(source), Polygon(target), [(1, 2), (4, 6)])
    for given_source in (source.tolist(), shapely.Polygon(source)):
        pair = match(given_source, target, ((1, 2), (np.int64(4), 6)))
        np.testing.assert_array_equal(pair.source, expected.source)
        np.testing.assert_array_equal(pair.target, expected.target)


def test_marks_name_the_points_as_they_were_given():
    source, target = two_opt(9, 1), two_opt(11, 2)
    clockwise = target[::-1]
    pair = match(source, clockwise, [(1, 8), (4, 4)])
    check(pair, source, clockwise, [(1, 8), (4, 4)])
    assert pairs_of(pair) == pairs_of(match(source, target, [(1, 2), (4, 6)]))


@given(
    st.integers(5, 16),
    st.integers(0, 40),
    st.floats(0.1, 3),
    st.integers(0, 15),
    st.sampled_from([1e-6, 1, 1e6]),
)
def test_a_copy_moved_scaled_and_started_elsewhere_is_recognised_without_marks(n, seed, move, shift, scale):
    ring = two_opt(n, seed)
    copy = np.roll(ring, -shift, axis=0) * scale + move * scale
    pair = match(ring, copy)
    np.testing.assert_array_equal(pair.target_vertices, (np.arange(n) - shift) % n)


@pytest.mark.parametrize("seed", range(12))
def test_a_turned_copy_is_recognised_without_marks(seed):
    ring = two_opt(14, seed)
    pair = match(ring, np.roll(turned(ring, 2.0), -5, axis=0))
    np.testing.assert_array_equal(pair.target_vertices, (np.arange(14) - 5) % 14)


def test_of_alignments_equally_good_the_upright_one_is_taken():
    diamond = turned(SQUARE - 1, 0.3)
    for shift in range(4):
        pair = match(SQUARE, np.roll(diamond, -shift, axis=0))
        np.testing.assert_allclose(pair.target, diamond, atol=1e-12)


def test_the_alignment_is_the_cheapest_of_all():
    rng = np.random.default_rng(5)

    def price(first, second, pairs):
        alone = [
            set(range(len(c.turns))) - {p[side] for p in pairs} for side, c in enumerate((first, second))
        ]
        total = sum(
            abs(first.shares[i] - second.shares[j])
            + TURN_PRICE * abs(first.turns[i] - second.turns[j]) / np.pi
            for i, j in pairs
        )
        for chain, rest in zip((first, second), alone, strict=True):
            total += sum(ALONE_PRICE + TURN_PRICE * abs(chain.turns[k]) / np.pi for k in rest)
        return total

    for p, q in [(1, 1), (2, 4), (3, 3), (5, 2), (4, 5), (0, 3)] * 5:
        first, second = (Chain(np.sort(rng.random(n)), rng.uniform(-3, 3, n)) for n in (p, q))
        every = [
            price(first, second, list(zip(a, b, strict=True)))
            for k in range(min(p, q) + 1)
            for a in combinations(range(p), k)
            for b in combinations(range(q), k)
        ]
        prices = ChainPrices(first, second)
        found = align(prices, Task())
        assert price(first, second, found) == pytest.approx(min(every), abs=1e-12)
        assert alignment_prices(prices, Task()) == pytest.approx(min(every), abs=1e-12)


@pytest.mark.parametrize("seed", range(20))
def test_the_vertices_of_a_bent_and_stretched_relative_find_their_partners(seed):
    source, target = related(18, seed)
    pair = match(source, target, [(0, 0)])
    np.testing.assert_array_equal(pair.source_vertices, pair.target_vertices)


def test_two_thousand_vertices_without_marks():
    ring = blob(2000, arms=5, depth=0.5)
    pair = match(ring, np.roll(ring, -777, axis=0))
    np.testing.assert_array_equal(pair.target_vertices, (np.arange(2000) - 777) % 2000)


def test_a_long_alignment_can_be_stopped():
    asked = []

    def should_stop():
        asked.append(None)
        return len(asked) == 5

    with pytest.raises(Cancelled):
        match(blob(600), blob(600, seed=1), should_stop=should_stop)


def test_results_cannot_be_changed_and_are_equal_to_the_bit():
    first, second = (match(two_opt(12, 3), two_opt(9, 4), [(2, 2)]) for _ in range(2))
    for name in ("source", "target", "source_vertices", "target_vertices"):
        assert getattr(first, name).tobytes() == getattr(second, name).tobytes()
        with pytest.raises(ValueError, match="read-only"):
            getattr(first, name)[0] = 0


@pytest.mark.parametrize(
    ("marks", "message", "named"),
    [
        ([(0, 0), (9, 1)], "mark 1 names vertex 9 of the source, which has 9", ((9, 1),)),
        ([(0, -1)], "mark 0 names vertex -1 of the target", ((0, -1),)),
        ([(0, 0), (3, 3), (0, 5)], "marks 0 and 2 both name vertex 0 of the source", ((0, 0), (0, 5))),
        ([(0, 4), (3, 4)], "marks 0 and 1 both name vertex 4 of the target", ((0, 4), (3, 4))),
        ([(0, 0), (3, 6), (6, 3)], "one order round the source", None),
        ([(0, 0), (2, 2), (4, 4), (6, 6), (5, 7)], r"marks 3 \(6, 6\) and 4 \(5, 7\)", ((6, 6), (5, 7))),
        ([(0, 0), (2, 2), (4, 4), (6, 6), (1, 3)], r"marks 1 \(2, 2\) and 4 \(1, 3\)", ((2, 2), (1, 3))),
        ([(0, 0), (1, 2, 3)], "not pairs of vertices", ()),
        ([(0.5, 0)], "not pairs of vertices", ()),
    ],
)
def test_impossible_marks_are_refused_by_name(marks, message, named):
    with pytest.raises(InvalidMarks, match=message) as error:
        match(two_opt(9, 1), two_opt(9, 2), marks)
    assert error.value.mend
    if named is not None:
        assert error.value.marks == named


@given(st.permutations(range(6)), st.integers(0, 8))
def test_marks_are_refused_exactly_where_their_cyclic_orders_disagree(order, shift):
    marks = [(i, (j + shift) % 9) for i, j in enumerate(order)]
    start = order.index(0)
    cyclic = [order[(start + k) % 6] for k in range(6)]
    if cyclic == sorted(cyclic):
        check(match(two_opt(9, 1), two_opt(9, 2), marks), two_opt(9, 1), two_opt(9, 2), marks)
    else:
        with pytest.raises(InvalidMarks) as error:
            match(two_opt(9, 1), two_opt(9, 2), marks)
        assert set(error.value.marks) < set(marks)
        assert len(error.value.marks) == 2


def test_without_the_named_marks_the_others_are_accepted():
    marks = [(0, 0), (1, 1), (2, 5), (3, 3), (4, 4)]
    left = list(marks)
    while True:
        try:
            match(two_opt(9, 1), two_opt(9, 2), left)
            break
        except InvalidMarks as error:
            left.remove(error.marks[1])
    assert len(left) >= 3


def test_a_bad_shape_is_named():
    bow_tie = [(0, 0), (2, 2), (2, 0), (0, 2)]
    with pytest.raises(InvalidPolygon, match=r"^source: edges 0-1 and 2-3 cross"):
        match(bow_tie, SQUARE)
    with pytest.raises(InvalidPolygon, match=r"^target: edges 0-1 and 2-3 cross") as caught:
        match(SQUARE, bow_tie)
    assert caught.value.vertices == (0, 1, 2, 3)


def test_marks_stand_at_the_points_that_were_given_also_where_these_run_clockwise():
    square, clockwise = [(0, 0), (4, 0), (4, 4), (0, 4)], [(0, 0), (0, 4), (4, 4), (4, 0)]
    for pair in (
        starskel.match(clockwise, square, marks=[(1, 3), (2, 2)]),
        starskel.match(starskel.Shape([clockwise]), starskel.Shape([square]), marks=[[(1, 3), (2, 2)]]),
    ):
        (ring,) = pair.ring_pairs
        assert ring.source[list(ring.marked_rows)].tolist() == [[0, 4], [4, 4]]
        assert ring.target[list(ring.marked_rows)].tolist() == [[0, 4], [4, 4]]
        assert ring.marks == ((1, 3), (2, 2))
