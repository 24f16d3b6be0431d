import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import starskel
from starskel.correspondence.proposal import NEAREST
from starskel.crossings import crossing_edges
from starskel.errors import Cancelled, StarskelError
from starskel.outline import edge_lengths
from starskel.polygon import Polygon
from tests.families import articulated, blob, comb, spiral, subdivided, turned, two_opt

RECTANGLE = np.array([(0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (0.0, 2.0)])


def shares(ring):
    arcs = np.cumsum(edge_lengths(ring))
    return np.concatenate([[0.0], arcs[:-1]]) / arcs[-1]


def apart(first, second):
    return np.abs((first - second + 0.5) % 1 - 0.5)


def partners(pair):
    """Where the partner of each vertex of the source lies, as a share of the target's outline."""
    start = int(np.flatnonzero(pair.target_vertices == 0)[0])
    along = (shares(pair.target) - shares(pair.target)[start]) % 1
    return along[pair.source_vertices >= 0]


def circle(n):
    angles = np.arange(n) * 2 * np.pi / n
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


@pytest.mark.parametrize("count", [1, 3, 8])
def test_suggested_marks_are_few_apart_and_accepted_by_match(shape_pair, count):
    marks = starskel.suggest_marks(shape_pair.source, shape_pair.target, count)
    assert 1 <= len(marks) <= count
    assert marks == sorted(marks)
    assert all(type(i) is int and type(j) is int for i, j in marks)
    assert starskel.match(shape_pair.source, shape_pair.target, marks).marks == tuple(marks)
    for side, polygon in enumerate((shape_pair.source, shape_pair.target)):
        own = shares(polygon.vertices)[[mark[side] for mark in marks]]
        distances = apart(own[:, None], own) + np.eye(len(own))
        assert (
            distances.min() > 0.5 * NEAREST / count
        )  # measured along all the vertices, not the salient alone


def test_exchanging_the_shapes_mirrors_the_marks(shape_pair):
    marks = starskel.suggest_marks(shape_pair.source, shape_pair.target)
    mirrored = starskel.suggest_marks(shape_pair.target, shape_pair.source)
    assert mirrored == sorted((j, i) for i, j in marks)


def test_moving_and_scaling_the_shapes_changes_nothing(shape_pair):
    source, target = shape_pair.source.vertices, shape_pair.target.vertices
    marks = starskel.suggest_marks(source, target)
    assert starskel.suggest_marks(source * 1e-3 + 5, target * 42 - [1e3, 7]) == marks


def test_marks_removed_and_suggested_anew_are_about_the_same(shape_pair):
    """Partners as far apart as a twelfth of the outline are still neighbours, most are much nearer."""
    completed = starskel.match(shape_pair.source, shape_pair.target, shape_pair.marks)
    marks = np.array(starskel.suggest_marks(shape_pair.source, shape_pair.target))
    expected = partners(completed)[marks[:, 0]]
    found = shares(shape_pair.target.vertices)[marks[:, 1]]
    assert np.median(apart(expected, found)) < 1 / 12


@pytest.mark.parametrize(
    "name", ["comb-bent", "arm-elbow-150", "star5-to-star8", "letter-K-X", "run-walk", "wrench-hammer"]
)
def test_without_its_marks_a_pair_blends_about_as_well(shape_pairs, name):
    pair = shape_pairs[name]
    marked, suggested = (
        starskel.measure(starskel.blend(starskel.match(pair.source, pair.target, marks)), frames=21)
        for marks in (pair.marks, ())
    )
    assert suggested.simple
    assert suggested.length_deviation < 1.5 * marked.length_deviation + 0.03
    assert suggested.area_deviation < marked.area_deviation + 0.1


def test_a_spiral_is_not_matched_inside_out(shape_pairs):
    """It uncoils and coils the other way without crossing; its area drifts more than with the true marks."""
    pair = shape_pairs["spiral-opposite"]
    assert starskel.measure(starskel.blend(starskel.match(pair.source, pair.target)), frames=21).simple


@pytest.mark.parametrize("seed", range(12))
def test_limbs_find_themselves_in_another_pose(seed):
    """Turned a little, of another size, started elsewhere, a few vertices fewer."""
    source, posed = articulated(seed, 1.3)
    rng = np.random.default_rng(seed)
    kept = np.sort(rng.permutation(len(posed))[: -len(posed) // 8])
    while len(crossing_edges(posed[kept])):
        kept = np.sort(rng.permutation(len(posed))[: -len(posed) // 8])
    shift = int(rng.integers(len(kept)))
    kept = np.roll(kept, -shift)
    target = turned(posed, rng.uniform(-0.6, 0.6))[kept] * rng.uniform(0.5, 2)
    marks = np.array(starskel.suggest_marks(source, target))
    errors = apart(shares(posed)[marks[:, 0]], shares(posed)[kept[marks[:, 1]]])
    assert len(marks) >= 5
    assert (errors < 0.03).mean() > 0.8


@pytest.mark.parametrize("seed", range(4))
def test_what_limbs_find_does_not_depend_on_how_they_lie(seed):
    source, target = articulated(seed + 50)
    marks = starskel.suggest_marks(source, target)
    n = len(target)
    assert starskel.suggest_marks(source * 1e-6, target * 1e6 + [3e5, -7e6]) == marks
    assert starskel.suggest_marks(source, turned(target, 0.3) + 20) == marks
    shifted = starskel.suggest_marks(source, np.roll(target, -7, axis=0))
    assert shifted == [(i, (j - 7) % n) for i, j in marks]


@given(
    st.integers(5, 16),
    st.integers(0, 40),
    st.floats(0.1, 3),
    st.integers(0, 15),
    st.sampled_from([1e-6, 1, 1e6]),
)
def test_a_copy_moved_scaled_and_started_elsewhere_is_marked_at_the_same_vertices(
    n, seed, move, shift, scale
):
    ring = two_opt(n, seed)
    copy = np.roll(ring, -shift, axis=0) * scale + move * scale
    marks = starskel.suggest_marks(ring, copy)
    assert marks
    assert all((j - i + shift) % n == 0 for i, j in marks)


@pytest.mark.parametrize("angle", [0.5, 1.6, 3.0])
@pytest.mark.parametrize("seed", range(4))
def test_a_turned_copy_is_marked_at_the_same_vertices(seed, angle):
    for ring in (two_opt(20, seed), blob(150, seed)):
        marks = starskel.suggest_marks(ring, turned(ring, angle))
        assert len(marks) >= 5
        assert all(i == j for i, j in marks)


def test_the_order_of_the_points_does_not_matter():
    source, target = blob(90, 1), blob(70, 2, depth=0.4)
    marks = starskel.suggest_marks(source, target)
    assert starskel.suggest_marks(source, target[::-1]) == [(i, 69 - j) for i, j in marks]
    clockwise = starskel.suggest_marks(source[::-1], target[::-1])
    assert clockwise == sorted((89 - i, 69 - j) for i, j in marks)


def test_there_are_no_more_marks_than_salient_vertices():
    assert starskel.suggest_marks(RECTANGLE, RECTANGLE * [1, 2]) == [(0, 0), (1, 1), (2, 2), (3, 3)]
    long, high = subdivided(RECTANGLE, 9), subdivided(RECTANGLE * [1, 2], 7)
    assert starskel.suggest_marks(long, high) == [(0, 0), (9, 7), (18, 14), (27, 21)]
    assert len(starskel.suggest_marks(circle(60), circle(50))) == 1


def test_teeth_find_teeth_in_order():
    source = comb(5)
    target = turned(source, 0.4) * [1.0, 1.3]
    marks = starskel.suggest_marks(source, target, count=10)
    assert len(marks) == 10
    assert all(i == j for i, j in marks)


def test_two_thousand_vertices_are_marked_at_the_same_places():
    ring = blob(2000, arms=7)
    marks = starskel.suggest_marks(ring, np.roll(ring, -777, axis=0))
    assert len(marks) == 8
    assert all((j - i + 777) % 2000 == 0 for i, j in marks)


def test_without_marks_a_pair_is_matched_by_those_suggested():
    source, target = blob(90, 1), spiral(60)
    marks = starskel.suggest_marks(source, target)
    unmarked, marked = starskel.match(source, target), starskel.match(source, target, marks)
    assert unmarked.marks == ()
    np.testing.assert_array_equal(unmarked.source, marked.source)
    np.testing.assert_array_equal(unmarked.target, marked.target)


def test_suggesting_twice_gives_the_same_and_none_can_be_asked_for():
    source, target = two_opt(30, 1), two_opt(25, 2)
    assert starskel.suggest_marks(source, target) == starskel.suggest_marks(Polygon(source), target.tolist())
    assert starskel.suggest_marks(source, target, 0) == []
    with pytest.raises(StarskelError, match="-1 is given for the count of marks"):
        starskel.suggest_marks(source, target, -1)


@pytest.mark.parametrize("patience", [1, 3, 30])
def test_suggesting_can_be_stopped(patience):
    asked = []

    def should_stop():
        asked.append(None)
        return len(asked) == patience

    with pytest.raises(Cancelled):
        starskel.suggest_marks(blob(1500), blob(1400, seed=1), should_stop=should_stop)
    assert len(asked) == patience
