from dataclasses import replace

import numpy as np
import pytest

from starskel.files.projects.examples import example
from starskel.quality import Crossing, measure
from starskel.shapes.blend import blend
from starskel.shapes.shape import Shape
from starskel.sheet.words import crossing_counts, figures, percent, spans, verdict

SQUARE = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], dtype=float)
TIMES = np.linspace(0, 1, 101).tolist()


@pytest.mark.parametrize(
    ("frames", "text"),
    [
        ([], ""),
        ([7], "0.07"),
        ([7, 8, 9], "0.07-0.09"),
        ([0, 1, 50, 99, 100], "0-0.01, 0.5, 0.99-1"),
        ([1, 3, 5, 7, 8], "0.01, 0.03, 0.05, ..."),
    ],
)
def test_frames_that_follow_each_other_are_one_span(frames, text):
    assert spans(TIMES, frames) == text


@pytest.mark.parametrize(
    ("part", "text"), [(0, "0.0 %"), (0.0123, "1.2 %"), (0.0994, "9.9 %"), (0.0996, "10 %"), (1.5, "150 %")]
)
def test_small_parts_have_two_digits(part, text):
    assert percent(part) == text


def test_a_simple_blend_is_called_so():
    report = measure(blend(SQUARE, SQUARE + 7, method="vertex"))
    assert verdict(report) == crossing_counts(report) == "simple, proven"
    assert figures(report) == ("area drift 0.0 %", "length drift 0.0 %")
    assert verdict(measure(blend(SQUARE, SQUARE + 7, method="edge-angle"))) == "simple"


@pytest.mark.parametrize("kind", [np.array, lambda ring: Shape([ring])])
def test_a_certified_blend_tells_how_it_came_about(kind):
    report = measure(blend(kind(SQUARE), kind(SQUARE + 7), method="certified"), 5)
    assert verdict(report) == crossing_counts(report) == "proven, as stitched"


def report_of(*crossings):
    """A report that names these crossings, as time, frame and whether natural."""
    report = measure(blend(SQUARE, SQUARE + 7, method="vertex"))
    return replace(report, crossings=tuple(Crossing(t, k, np.empty((0, 2)), n) for t, k, n in crossings))


def test_natural_and_harmful_crossings_are_told_apart():
    natural, harmful = (0.5, 50, True), (0.51, 51, False)
    assert verdict(report_of(natural)) == "natural crossing at t = 0.5"
    assert crossing_counts(report_of(natural)) == "1 natural"
    assert verdict(report_of(harmful)) == "crosses at t = 0.51"
    assert crossing_counts(report_of(harmful)) == "1 harmful"
    assert verdict(report_of(natural, harmful)) == "crosses at t = 0.5-0.51, natural in 1 frame"
    assert crossing_counts(report_of(natural, harmful)) == "1 natural 1 harmful"


def test_a_crossing_between_frames_is_told_by_its_moment():
    assert verdict(report_of((0.50751, None, False))) == "crosses at t = 0.5075"
    assert crossing_counts(report_of((0.50751, None, False))) == "crosses at t = 0.5075"


def test_a_crossing_blend_is_called_so_with_its_times():
    arm = example("arm").pair(0)
    report = measure(blend(arm.source, arm.target, arm.marks, "vertex"))
    first, last = report.crossing_times[0], report.crossing_times[-1]
    assert 0 < first < 0.5 < last < 1
    assert verdict(report) == f"crosses at t = {first:.2f}-{last:.2f}"
    assert figures(report) == (
        f"area drift {percent(report.area_deviation)}",
        f"length drift {percent(report.length_deviation)}",
    )


def test_negative_lengths_are_told(shape_pairs):
    pair = shape_pairs["spiral-opposite"]
    report = measure(blend(pair.source, pair.target, pair.marks, "edge-angle"))
    times = spans(report.times.tolist(), report.negative_lengths)
    assert times
    assert figures(report)[2:] == (f"negative lengths at t = {times}",)
