import numpy as np
import pytest

from starskel.blending.blend import blend
from starskel.files.examples import example
from starskel.quality import measure
from starskel.sheet.words import figures, percent, spans, verdict

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
    assert verdict(report) == "simple"
    assert figures(report) == ("area drift 0.0 %", "length drift 0.0 %")


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
