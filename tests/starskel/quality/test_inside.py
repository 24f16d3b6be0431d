"""Distortion of the pieces' fans, against triangles whose maps are known."""

import numpy as np
import pytest

from starskel.correspondence import match
from starskel.decomposition import decompose
from starskel.quality import measure
from starskel.quality.inside import Triangles
from starskel.shapes.blend import blend
from tests.families import turned, two_opt

SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
CORNERS = [(k, k) for k in range(4)]


def points(ring):
    return np.concatenate([ring, ring.mean(axis=0)[None]])


def distortion(target, *frames):
    """The distortion of frames of a square that becomes the target, at even times."""
    decomposition = decompose(match(SQUARE, target, CORNERS))
    triangles = Triangles(decomposition, points(SQUARE), points(target))
    times = np.linspace(0, 1, len(frames))
    return triangles.distortion(*triangles.logarithms(np.stack([points(f) for f in frames]), times))


def test_a_rigid_motion_distorts_nothing():
    found = distortion(turned(SQUARE, 1.0), SQUARE, turned(SQUARE, 0.4) + 7, turned(SQUARE, 1.0))
    assert found.worst_stretch == pytest.approx(1, abs=1e-7)
    assert found.worst_spread == pytest.approx(1)
    assert found.folded == 0


def test_stretching_on_the_way_counts_both_ways():
    """The frame is stretched by 3 in a direction, and both shapes are not: K = 3 there and back."""
    found = distortion(SQUARE, SQUARE, SQUARE * (3, 1), SQUARE)
    assert found.worst_stretch == pytest.approx(3)
    assert found.worst_spread == pytest.approx(3)
    assert found.stretch == pytest.approx(3 ** (1 / 3))
    assert found.spread == pytest.approx(3 ** (1 / 3))


def test_half_of_the_stretching_that_the_pair_demands_is_none():
    found = distortion(SQUARE * (4, 1), SQUARE, SQUARE * (2, 1), SQUARE * (4, 1))
    assert found.worst_stretch == pytest.approx(1, abs=1e-7)
    assert found.worst_spread == pytest.approx(2.5 / 2)


def test_what_is_turned_over_is_counted_apart():
    dented = SQUARE.copy()
    dented[0] = (1.5, 1.5)
    found = distortion(SQUARE, SQUARE, SQUARE * (-1, 1), SQUARE)
    assert found.folded == pytest.approx(1)
    assert found.worst_stretch == pytest.approx(1, abs=1e-7)


def test_shapes_that_are_turned_only_are_hardly_distorted_by_any_method():
    ring = two_opt(14, 5)
    for method in ("star-skeleton", "stitched", "rigid"):
        inside = measure(blend(ring, turned(ring, 1.0), [(k, k) for k in range(14)], method)).inside
        assert inside is not None
        assert inside.stretch < 1.001
        assert inside.folded < 0.001


def test_factors_are_at_least_one_and_worst_are_no_less_than_mean(shape_pair):
    made = blend(shape_pair.source, shape_pair.target, shape_pair.marks, "rigid")
    inside = measure(made, frames=11).inside
    assert inside is not None
    assert 1 <= inside.stretch <= inside.worst_stretch
    assert 1 <= inside.spread <= inside.worst_spread
    assert 0 <= inside.folded < 0.5
