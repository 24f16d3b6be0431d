"""Which rings bound a sheet in layers."""

from functools import cache

import numpy as np
import pytest

from starskel.crossings import crossing_edges
from starskel.outline import turning_angles
from starskel.quality.layers import in_layers
from tests.families import two_opt

BOW = [(0, 0), (2, 2), (2, 0), (0, 2)]

PRETZEL = [(0, 0), (10, 0), (10, 6), (2, 6), (2, -2), (4, -2), (4, 4), (8, 4), (8, 2), (0, 2)]
"""A bar whose end comes round and lies over its beginning (paper, figure 11)."""


def winding_numbers(ring, points):
    """The winding numbers of a ring about points, by summing angles."""
    spokes = ring[None] - points[:, None]
    turned = np.roll(spokes, -1, axis=1)
    cross = spokes[..., 0] * turned[..., 1] - spokes[..., 1] * turned[..., 0]
    return np.round(np.arctan2(cross, (spokes * turned).sum(axis=2)).sum(axis=1) / (2 * np.pi))


@pytest.mark.parametrize("seed", range(10))
def test_a_simple_ring_is_a_sheet_and_turned_over_it_is_none(seed):
    ring = two_opt(20, seed)
    assert in_layers(ring)
    assert not in_layers(ring[::-1])


def test_a_bar_that_lies_over_itself_is_a_sheet():
    assert in_layers(np.array(PRETZEL, dtype=float))


def test_what_is_twisted_is_none():
    assert not in_layers(np.array(BOW, dtype=float))


def test_what_turns_round_twice_is_none():
    angles = np.linspace(0, 4 * np.pi, 21)[:-1]
    radii = np.linspace(1, 2, 20)
    ring = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    assert round(turning_angles(ring).sum() / (2 * np.pi)) == 2
    assert not in_layers(ring)


def test_folds_and_repeated_vertices_are_none():
    assert not in_layers(np.array([(0, 0), (4, 0), (4, 4), (4, 2), (0, 4)], dtype=float))
    assert not in_layers(np.array([(0, 0), (4, 0), (4, 4), (4, 4), (0, 4)], dtype=float))
    assert not in_layers(np.zeros((4, 2)))


def crooked_bar(seed):
    """A bar along a random way, which may come over itself, and whose sides are shaken."""
    random = np.random.default_rng(seed)
    angles = np.cumsum(random.uniform(0.2, 1.4, 8))
    way = np.concatenate([[0], np.cumsum(random.uniform(0.5, 1.5, 8) * np.exp(1j * angles))])
    across = 0.15j * np.exp(1j * np.append(angles, angles[-1]) - 0.4j)
    sides = np.concatenate([way - across, (way + across)[::-1]])
    return np.stack([sides.real, sides.imag], axis=1) + random.normal(0, random.uniform(0, 0.3), (18, 2))


def can_be_cut(ring):
    """Whether a string of vertices can be cut into counter-clockwise triangles, by trying all ways."""

    @cache
    def between(i, j):
        if j - i == 1:
            return True
        return any(left(i, k, j) and between(i, k) and between(k, j) for k in range(i + 1, j))

    def left(i, k, j):
        (ax, ay), (bx, by) = ring[k] - ring[i], ring[j] - ring[i]
        return ax * by - ay * bx > 0

    return between(0, len(ring) - 1)


def test_answers_are_those_of_trying_all_triangulations():
    """Corners are cut off first: that changes no answer. Sheets have no negative winding numbers."""
    points = np.random.default_rng(0).uniform(-3, 3, (300, 2))
    counts = {True: 0, False: 0}
    for seed in range(200):
        ring = crooked_bar(seed)
        once = round(turning_angles(ring).sum() / (2 * np.pi)) == 1
        answer = in_layers(ring)
        assert answer == (once and can_be_cut(ring)), seed
        if answer:
            assert winding_numbers(ring, points).min() >= 0
        counts[answer] += once and len(crossing_edges(ring)) > 0
    assert min(counts.values()) >= 15


@pytest.mark.parametrize("seed", range(0, 150, 15))
def test_moving_scaling_turning_and_another_start_change_no_answer(seed):
    ring = crooked_bar(seed)
    turn = np.array([(0.6, 0.8), (-0.8, 0.6)])
    for same in (ring * 1e6, ring * 1e-6, ring @ turn + 100, np.roll(ring, 4, axis=0)):
        assert in_layers(same) == in_layers(ring)


def test_long_ways_round_are_cut_down_first(shape_pairs):
    """A bar of many vertices that lies over itself."""
    ring = np.array(PRETZEL, dtype=float)
    steps = np.linspace(0, 1, 41)[:-1, None]
    dense = np.concatenate(
        [a + steps * (b - a) for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True)]
    )
    wavy = dense + np.random.default_rng(1).normal(0, 0.004, dense.shape)
    assert in_layers(dense)
    assert in_layers(wavy)
