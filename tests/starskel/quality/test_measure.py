import numpy as np
import pytest

from starskel.blending import METHODS
from starskel.blending.edge_angle import EdgeAngleBlend
from starskel.blending.frames import Blend
from starskel.blending.pieces import PieceBlend
from starskel.blending.vertex import VertexBlend
from starskel.correspondence import Correspondence, match
from starskel.errors import Cancelled, StarskelError
from starskel.outline import edge_lengths, signed_areas
from starskel.quality import measure
from starskel.shapes.blend import blend
from tests.families import turned, two_opt

SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
BOW = np.array([(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)])


class Played(Blend):
    """Frames made up for a test."""

    def __init__(self, frames):
        rows = np.arange(frames.shape[1])
        super().__init__(Correspondence(frames[0], frames[-1], (), rows, rows))
        self._all = frames

    def _frames(self, ts):
        return self._all[np.round(ts * (len(self._all) - 1)).astype(int)]


def test_a_blend_that_stands_still_deviates_in_nothing():
    report = measure(VertexBlend(match(SQUARE, SQUARE)), frames=5)
    assert report.simple
    assert report.crossing_frames == report.crossing_times == ()
    assert report.proven
    assert report.negative_lengths == ()
    assert report.area_deviation == report.length_deviation == report.angle_deviation == 0
    np.testing.assert_array_equal(report.times, [0, 0.25, 0.5, 0.75, 1])
    np.testing.assert_array_equal(report.areas, 1)
    np.testing.assert_array_equal(report.perimeters, 4)


def test_crossing_frames_are_told_by_number_time_and_place():
    report = measure(Played(np.stack([SQUARE, BOW, SQUARE, BOW, SQUARE])), frames=5)
    assert not report.simple
    assert report.crossing_frames == (1, 3)
    assert report.crossing_times == (0.25, 0.75)
    assert report.harmful_frames == (1, 3)
    assert report.natural_frames == ()
    for crossing in report.crossings:
        np.testing.assert_allclose(crossing.places, [(0.5, 0.5)])
    np.testing.assert_array_equal(report.crosses, [False, True, False, True, False])


def test_touching_counts_as_crossing():
    touching = np.array([(0, 0), (2, 0), (2, 2), (1, 0), (0, 2)], dtype=float)
    apart = touching.copy()
    apart[3, 1] = 1
    report = measure(Played(np.stack([apart, touching, apart])), frames=3)
    assert report.crossing_frames == (1,)
    np.testing.assert_allclose(report.crossings[0].places, [(1, 0), (1, 0)])


def test_areas_are_compared_with_their_linear_blend():
    report = measure(Played(np.stack([SQUARE, 2 * SQUARE, 2 * SQUARE])), frames=3)
    np.testing.assert_allclose(report.areas, [1, 4, 4])
    np.testing.assert_allclose(report.area_deviations, [0, 4 / 2.5 - 1, 0])
    assert report.area_deviation == pytest.approx(0.6)


def test_lengths_are_compared_with_their_linear_blend():
    report = measure(Played(np.stack([SQUARE, 2 * SQUARE, SQUARE])), frames=3)
    assert report.length_deviation == pytest.approx(1 / 3)
    np.testing.assert_allclose(report.perimeters, [4, 8, 4])
    assert report.angle_deviation == pytest.approx(0, abs=1e-12)


def test_angles_are_compared_with_their_linear_blend():
    """The square leans: two angles gain, two lose what the others gain."""
    lean = 0.3
    rhombus = SQUARE @ np.array([(1, 0), (np.sin(lean), np.cos(lean))])
    report = measure(Played(np.stack([SQUARE, rhombus, SQUARE])), frames=3)
    assert report.angle_deviation == pytest.approx(lean / 3)
    assert report.length_deviation == pytest.approx(0, abs=1e-12)


def test_a_vertex_blend_to_a_turned_copy_shrinks():
    """Half way, a shape whose vertices move straight through a turn by 3 has shrunk by the cosine of 1.5."""
    ring = two_opt(12, 2)
    report = measure(VertexBlend(match(ring, turned(ring, 3.0), [(k, k) for k in range(12)])), frames=101)
    expected = 1 - (np.cos(1.5)) ** 2
    assert report.area_deviation == pytest.approx(expected, rel=1e-3)


def test_negative_lengths_are_told(shape_pairs):
    pair = shape_pairs["spiral-opposite"]
    blend = EdgeAngleBlend(match(pair.source, pair.target, pair.marks))
    report = measure(blend, frames=21)
    assert report.negative_lengths == tuple(
        k for k, t in enumerate(report.times) if blend.lengths([t]).min() < 0
    )
    assert report.negative_lengths


def test_series_are_those_of_the_frames(shape_pair):
    blend = VertexBlend(match(shape_pair.source, shape_pair.target, shape_pair.marks))
    report = measure(blend, frames=7)
    frames = blend.frames(report.times)
    np.testing.assert_array_equal(report.areas, signed_areas(frames))
    np.testing.assert_array_equal(report.perimeters, edge_lengths(frames).sum(axis=1))


@pytest.mark.parametrize("frames", [1, 0, -3])
def test_too_few_frames_are_refused(frames):
    with pytest.raises(StarskelError, match=f"{frames} is given for the number of frames"):
        measure(VertexBlend(match(SQUARE, SQUARE)), frames=frames)


@pytest.mark.parametrize("frames", [2.5, 101.0, "101", None, [0, 1]])
def test_frames_that_are_no_number_are_refused(frames):
    with pytest.raises(StarskelError, match="for the number of frames; give a whole number, from 2"):
        measure(VertexBlend(match(SQUARE, SQUARE)), frames)


def test_what_is_no_blend_is_refused():
    with pytest.raises(StarskelError, match="ndarray is no blend; give what"):
        measure(SQUARE)


def test_numpy_numbers_of_frames_are_whole_numbers():
    assert len(measure(VertexBlend(match(SQUARE, SQUARE)), np.int64(7)).times) == 7


def test_progress_only_grows_and_reaches_the_end():
    seen = []
    measure(Played(np.stack([SQUARE, BOW, SQUARE])), 31, progress=seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 1


@pytest.mark.parametrize("method", ["vertex", "stitched"])
def test_measuring_stops_wherever_it_is_told_to(shape_pairs, method):
    pair = shape_pairs["letter-C-S"]
    made = blend(pair.source, pair.target, pair.marks, method)
    asked = []
    measure(made, should_stop=lambda: bool(asked.append(None)))
    for last in {1, 2, len(asked) // 2, len(asked)}:
        answers = iter(range(last - 1))
        with pytest.raises(Cancelled):
            measure(made, should_stop=lambda answers=answers: next(answers, None) is None)


def test_frames_are_those_of_the_blend_whether_pieces_are_seen_or_not(shape_pairs):
    pair = shape_pairs["letter-K-X"]
    for method in METHODS:
        made = blend(pair.source, pair.target, pair.marks, method)
        report = measure(made, frames=7)
        np.testing.assert_array_equal(report.areas, signed_areas(made.frames(report.times)))
        assert (report.inside is None) == (not isinstance(made, PieceBlend))


def test_a_frame_that_collapses_into_a_point_is_not_simple():
    square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    report = measure(VertexBlend(match(square, np.roll(square, 2, axis=0), [(0, 0)])))
    assert report.crossing_times == (0.5,)
