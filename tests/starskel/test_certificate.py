import numpy as np
import pytest

from starskel.certificate import first_unsafe, safe
from starskel.outline import cross_themselves
from tests.families import blob, spiral, subdivided, turned, two_opt


def moved(before, after, count):
    """Frames of the even motion, more densely where they are sampled anyway."""
    t = np.linspace(0, 1, count)[:, None, None]
    return (1 - t) * before + t * after


def test_the_answer_is_that_of_dense_samples():
    answers = []
    for seed in range(120):
        before = two_opt(6 + seed % 8, seed)
        after = before + np.random.default_rng(seed).normal(0, 8, before.shape) * (0.2 + seed % 5)
        answers.append(safe(before, after))
        assert answers[-1] == (not cross_themselves(moved(before, after, 1001)).any())
    assert 20 < sum(answers) < 100


def test_no_sample_of_many_finds_a_crossing_where_the_answer_is_yes():
    for before, after in ((blob(40, 1), blob(40, 2)), (spiral(30), turned(spiral(30), 0.3))):
        assert safe(before, after)
        assert not cross_themselves(moved(before, after, 20_001)).any()


@pytest.mark.parametrize("short", [0.0, 1e-4, 1e-9, 2.0**-50])
def test_vertices_that_stop_short_of_an_edge_are_safe_unless_they_reach_it(short):
    before = np.array([(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)], dtype=float)
    after = before.copy()
    after[3, 1] = short
    assert safe(before, after) == (short > 0)


@pytest.mark.parametrize("scale", [1.0, 1e6, 1e-6])
def test_a_brush_in_the_middle_of_the_motion_is_caught(scale):
    """Vertex and edge turn into each other for a ten-thousandth of the time, and are apart at both ends."""
    before = np.array([(0, 0), (10, 0), (10, 6), (5, 2), (0, 6)], dtype=float)
    for reach, crosses in ((1e-8, True), (-1e-8, False)):
        start, end = before.copy(), before.copy()
        start[3], end[3] = (1.0, 1.0 - reach), (9.0, 1.0 - reach)
        start[0:2, 1], end[0:2, 1] = (0.0, 2.0), (2.0, 0.0)  # the base seesaws through y = 1 half-way
        assert safe(scale * start, scale * end) != crosses
        sampled = cross_themselves(moved(start, end, 101)[[0, 30, 70, 100]])
        assert not sampled.any()


@pytest.mark.parametrize("ring", [subdivided(two_opt(8, 3), 5), two_opt(9, 2, grid=5)], ids=["runs", "grid"])
def test_standing_still_and_moving_along_are_safe(ring):
    assert safe(ring, ring)
    assert safe(ring, ring + np.array([64.0, -32.0]))
    assert safe(ring, 4 * ring)


def test_turning_inside_out_is_not_safe():
    ring = two_opt(10, 1)
    assert not safe(ring, -ring * [1, -1])
    assert not safe(ring, -ring)
    assert not safe(ring, np.zeros_like(ring))


def test_the_first_unsafe_link_is_named():
    ring = blob(12, 1)
    assert first_unsafe(np.stack([ring, 2 * ring, ring])) is None
    assert first_unsafe(np.stack([ring, 2 * ring, -ring, ring])) == 1
