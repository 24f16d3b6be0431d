"""What is measured of blends of shapes."""

import numpy as np
import pytest

import starskel
from starskel import Shape
from starskel.files.multi_pairs import read_multi_pairs
from tests.starskel.files.test_multi_pairs import MULTI
from tests.starskel.shapes.drawn import EIGHT, A, B, I, moved

FILE = read_multi_pairs(MULTI)


@pytest.mark.parametrize("pair_id", FILE.ids)
@pytest.mark.parametrize("method", ["stitched", "star-skeleton", "rigid", "edge-angle", "vertex"])
def test_the_pairs_of_shapes_blend_without_fault(pair_id, method):
    pair = FILE.pair(pair_id)
    blend = starskel.blend(pair.source, pair.target, pair.marks, method, pairing=pair.pairing)
    report = starskel.measure(blend, 41)
    assert report.simple
    assert report.holes_inside
    assert report.overlap < 1e-9
    if method == "stitched":
        assert report.area_deviation < 0.02


def test_a_shape_that_stands_still_drifts_nowhere():
    report = starskel.measure(starskel.blend(Shape(B), Shape(B)), 11)
    np.testing.assert_allclose(report.area_deviations, 0, atol=1e-9)
    assert report.overlap == 0


def test_crossing_rings_and_straying_holes_are_seen():
    collapsed = starskel.blend(Shape(EIGHT), Shape(moved(EIGHT, 3.1)), method="vertex")
    assert starskel.measure(collapsed, 41).area_deviation > 0.9
    pair = starskel.match(Shape(B), Shape(B), pairing=[(0, 0), (1, 2), (2, 1)])
    report = starskel.measure(starskel.blend(pair, method="vertex"), 41)
    assert not report.holes_inside
    assert not report.simple
    assert 20 in report.crossing_frames


def test_parts_that_come_to_overlap_are_seen():
    pair = starskel.match(Shape(I), Shape(moved(I, np.pi)), pairing=[(0, 0), (1, 1)])
    assert starskel.measure(starskel.blend(pair, joined=False), 41).overlap > 0.01
    assert starskel.measure(starskel.blend(pair), 41).overlap < 1e-9


def test_rings_that_are_a_point_at_an_end_are_no_fault():
    report = starskel.measure(starskel.blend(Shape(A), Shape([A[0]])), 21)
    assert report.simple
    assert report.areas[0] == pytest.approx(Shape(A).area)
