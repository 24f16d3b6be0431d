import numpy as np
import pytest

from starskel.blending.edge_angle import EdgeAngleBlend
from starskel.correspondence import Correspondence, match
from starskel.outline import edge_lengths, turning_angles
from tests.families import related, two_opt
from tests.starskel.blending.cases import CASES, pair_of

TIMES = np.linspace(0, 1, 23)


def identity(source, target):
    rows = np.arange(len(source))
    return Correspondence(source, target, (), rows, rows)


@pytest.mark.parametrize("name", CASES)
def test_the_outline_closes_before_it_is_placed(name):
    blend = EdgeAngleBlend(pair_of(name))
    lengths, directions = blend.lengths(TIMES), blend.edges.directions(TIMES)
    gaps = np.abs((lengths * directions).sum(axis=1))
    assert (gaps <= 1e-12 * np.abs(lengths).sum(axis=1)).all()


@pytest.mark.parametrize("seed", range(20))
def test_it_closes_for_pairs_that_have_nothing_in_common(seed):
    blend = EdgeAngleBlend(identity(two_opt(15, seed), two_opt(15, seed + 500)))
    lengths, directions = blend.lengths(TIMES), blend.edges.directions(TIMES)
    gaps = np.abs((lengths * directions).sum(axis=1))
    assert (gaps <= 1e-12 * np.abs(lengths).sum(axis=1)).all()


@pytest.mark.parametrize("seed", range(10))
def test_turning_angles_are_linear_where_no_length_is_negative(seed):
    source, target = related(14, seed)
    blend = EdgeAngleBlend(identity(source, target))
    start, end = turning_angles(source), turning_angles(target)
    for t in TIMES[~blend.negative_lengths(TIMES)]:
        np.testing.assert_allclose(turning_angles(blend.at(t)), (1 - t) * start + t * end, atol=1e-7)


def test_lengths_change_by_the_least_weighted_sum_of_squares():
    """Against the normal equations of the same problem, solved densely (Sederberg et al., section 3)."""
    source, target = two_opt(12, 1), two_opt(12, 2)
    blend = EdgeAngleBlend(identity(source, target))
    start, end = edge_lengths(source), edge_lengths(target)
    change = np.abs(start - end)
    weights = np.maximum(change, 1e-4 * max(change.max(), (start + end).mean() / 2)) ** 2
    for t in (0.2, 0.5, 0.9):
        direction = blend.edges.directions(np.array([t]))[0]
        closing = np.stack([direction.real, direction.imag])
        wanted = (1 - t) * start + t * end
        multipliers = np.linalg.solve(closing * weights @ closing.T, closing @ wanted)
        np.testing.assert_allclose(
            blend.lengths([t])[0], wanted - weights * (multipliers @ closing), atol=1e-9
        )


def test_negative_lengths_are_told():
    blend = EdgeAngleBlend(pair_of("spiral-opposite"))
    negative = blend.negative_lengths(TIMES)
    assert negative.any()
    np.testing.assert_array_equal(negative, (blend.lengths(TIMES) < 0).any(axis=1))
    assert not EdgeAngleBlend(pair_of("run-walk")).negative_lengths(TIMES).any()


def test_lengths_are_those_of_the_frames():
    blend = EdgeAngleBlend(pair_of("hand-open"))
    np.testing.assert_allclose(edge_lengths(blend.frames(TIMES)), np.abs(blend.lengths(TIMES)), atol=1e-9)


def test_lengths_that_differ_by_rounding_alone_do_not_decide_what_gives_way():
    ring = two_opt(10, 8)
    edges = np.roll(ring, -1, axis=0) - ring
    for seed in range(5):
        noise = 1 + 1e-15 * np.random.default_rng(seed).normal(size=len(ring))
        blend = EdgeAngleBlend(identity(ring, np.roll(np.cumsum(edges * noise[:, None], axis=0), 1, axis=0)))
        softness = blend.softness
        assert softness.max() == softness.min() == 1


def test_the_shape_turns_the_shorter_way_as_a_whole():
    ring = two_opt(10, 4)
    for angle in (3.0, -3.0):
        copy = np.stack(
            [ring @ [np.cos(angle), -np.sin(angle)], ring @ [np.sin(angle), np.cos(angle)]], axis=1
        )
        blend = EdgeAngleBlend(match(ring, copy, [(k, k) for k in range(10)]))
        np.testing.assert_allclose(blend.edges.rotations, angle)
