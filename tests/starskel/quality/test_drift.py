"""Smoothness in t."""

import numpy as np
import pytest

from starskel.blending.vertex import VertexBlend
from starskel.correspondence import match
from starskel.quality import measure
from starskel.quality.drift import roughness
from starskel.shapes.blend import blend
from tests.families import turned, two_opt

SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])


def test_even_motion_is_smooth():
    report = measure(VertexBlend(match(SQUARE, 3 * SQUARE + 2, [(k, k) for k in range(4)])))
    assert report.roughness == pytest.approx(0, abs=1e-15)


def test_a_jump_counts_by_its_part_of_the_size():
    still = np.stack([SQUARE] * 25 + [SQUARE + np.array([0.5, 0])] * 26)
    assert roughness(still) == pytest.approx(0.25)


def test_a_turn_is_as_rough_as_its_acceleration_says():
    """Half a turn: the corner goes round the middle at speed pi; it strays by half the square of a step."""
    ring = two_opt(10, 3)
    report = measure(blend(ring, turned(ring, 3.0), [(k, k) for k in range(10)], "edge-angle"))
    size = np.ptp(np.stack([ring, turned(ring, 3.0)]), axis=1).max()
    lengths = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
    middle = ((lengths + np.roll(lengths, 1))[:, None] * ring).sum(axis=0) / (2 * lengths.sum())
    radius = np.hypot(*(ring - middle).T).max()
    assert report.roughness == pytest.approx(radius * (1 - np.cos(3.0 / 50)) / size, rel=1e-6)


@pytest.mark.parametrize("frames", [2, 11, 51, 73, 201])
def test_it_does_not_depend_on_how_many_frames_are_looked_at(shape_pairs, frames):
    pair = shape_pairs["letter-K-X"]
    made = blend(pair.source, pair.target, pair.marks, "stitched")
    assert measure(made, frames).roughness == pytest.approx(measure(made).roughness, rel=1e-9)
