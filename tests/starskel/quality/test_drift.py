"""Smoothness in t."""

import numpy as np
import pytest

from starskel.blending.vertex import VertexBlend
from starskel.correspondence import match
from starskel.quality import measure
from starskel.quality.drift import angle_deviation, roughness
from starskel.shapes.blend import blend
from starskel.shapes.shape import Shape
from tests.families import turned, two_opt
from tests.starskel.shapes.drawn import EIGHT, B, I, moved

SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])


def test_even_motion_is_smooth():
    report = measure(VertexBlend(match(SQUARE, 3 * SQUARE + 2, [(k, k) for k in range(4)])))
    assert report.roughness == pytest.approx(0, abs=1e-15)


def test_a_jump_counts_by_its_part_of_the_size():
    still = np.stack([SQUARE] * 25 + [SQUARE + np.array([0.5, 0])] * 26)
    assert roughness(lambda _: [], [still]) == pytest.approx(0.25)


def test_a_turn_is_as_rough_as_its_acceleration_says():
    """Half a turn: the corner goes round the middle at speed pi; it strays by half the square of a step."""
    ring = two_opt(10, 3)
    report = measure(blend(ring, turned(ring, 3.0), [(k, k) for k in range(10)], "edge-angle"))
    size = np.ptp(np.stack([ring, turned(ring, 3.0)]), axis=1).max()
    lengths = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
    middle = ((lengths + np.roll(lengths, 1))[:, None] * ring).sum(axis=0) / (2 * lengths.sum())
    radius = np.hypot(*(ring - middle).T).max()
    assert report.roughness == pytest.approx(radius * (1 - np.cos(3.0 / 50)) / size, rel=1e-6)


@pytest.mark.parametrize("rings", [I, B])
def test_rings_of_a_shape_that_turns_are_as_rough_as_its_farthest_vertex(rings):
    """As of one ring; angles and lengths stay what they are."""
    report = measure(blend(Shape(rings), Shape(moved(rings, 2.0)), method="stitched", turns=0))
    rows = np.concatenate(rings)
    size = np.ptp(np.stack([rows, np.concatenate(moved(rings, 2.0))]), axis=1).max()
    reach = report.roughness * size / (1 - np.cos(2.0 / 50))
    radii = [np.hypot(*(rows - ring.mean(axis=0)).T).max() for ring in rings]
    assert 0.8 * min(radii) < reach < 1.2 * max(radii)
    assert report.angle_deviation == pytest.approx(0, abs=1e-6)


def test_angles_of_a_ring_that_grows_from_a_point_should_stay():
    """A kite beside a bar: copies of itself have its angles, one that is spread on the way has not."""
    kite = np.array([(50.0, 0.0), (60.0, 10.0), (50.0, 40.0), (40.0, 10.0)])
    bar = np.array([(0.0, 0.0), (20.0, 0.0), (20.0, 80.0), (0.0, 80.0)])
    for source, target in (([bar], [bar, kite]), ([bar, kite], [bar])):
        report = measure(blend(Shape(source), Shape(target)), 21)
        assert report.angle_deviation == pytest.approx(0, abs=1e-9)
    times = np.linspace(0, 1, 3)
    spread = np.stack([np.full((4, 2), 50.0), kite * [1.0, 3.0], kite])
    assert angle_deviation([np.stack([bar] * 3), spread], times) > 0.01


@pytest.mark.parametrize("frames", [2, 11, 51, 73, 201])
def test_it_does_not_depend_on_how_many_frames_are_looked_at(shape_pairs, frames):
    pair = shape_pairs["letter-K-X"]
    for made in (blend(pair.source, pair.target, pair.marks, "stitched"), blend(Shape(B), Shape(EIGHT))):
        assert measure(made, frames).roughness == pytest.approx(measure(made).roughness, rel=1e-9)
