from dataclasses import replace

import numpy as np

from app.view.wording.verdicts import crossing_rings, crossing_spans, details, summaries
from starskel import Polygon, Report, Shape, blend, match, measure
from starskel.quality import Crossing

SQUARE = Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])
STILL = measure(blend(SQUARE, SQUARE, method="vertex"))


def crossing(*moments: tuple[float, int | None, bool]) -> Report:
    """A report of these crossings: when, in which frame, and whether naturally."""
    return replace(STILL, crossings=tuple(Crossing(t, k, np.empty((0, 2)), n) for t, k, n in moments))


def test_what_is_proven_is_called_so() -> None:
    assert summaries(STILL) == (
        "proven simple, area 0.0 %",
        "simple, area 0.0 %",
        "proven simple",
        "proven",
    )
    assert summaries(replace(STILL, proven=False)) == ("simple, area 0.0 %", "simple")
    assert "proven for every t" in details(STILL)
    assert "No frame crosses itself." in details(replace(STILL, proven=False))


def test_natural_and_harmful_crossings_are_told_apart() -> None:
    natural, harmful = (0.5, 50, True), (0.51, 51, False)
    assert summaries(crossing(natural))[0] == "natural crossing, area 0.0 %"
    assert summaries(crossing(natural, harmful))[0] == "crosses at t = .50, area 0.0 %"
    assert "That is natural" in details(crossing(natural))
    assert "Natural in 1 of 2 frames" in details(crossing(natural, harmful))
    assert "atural" not in details(crossing(harmful))


def test_spans_are_those_of_frames_of_a_kind_in_a_row() -> None:
    report = crossing((0.2, 20, True), (0.21, 21, True), (0.22, 22, False), (0.7, 70, False))
    spans = [(0.2, 0.21, True), (0.22, 0.22, False), (0.7, 0.7, False)]
    np.testing.assert_allclose(crossing_spans(report), spans)
    assert crossing_rings(report, 0.704) == {0}
    assert not crossing_rings(report, 0.5)


def test_a_crossing_between_frames_is_a_span_too() -> None:
    assert crossing_spans(crossing((0.123, None, False))) == [(0.123, 0.123, False)]
    assert "t = 0.123" in details(crossing((0.123, None, False)))


def test_parts_that_lie_over_each_other_on_the_way_are_told() -> None:
    far = Polygon(SQUARE.vertices + np.array([20, 0]))
    shape = Shape([SQUARE, far])
    marks = [[(k, k) for k in range(4)]] * 2
    across = blend(match(shape, shape, marks, pairing=[(0, 1), (1, 0)]), method="vertex", joined=False)
    beside = blend(match(shape, shape, pairing=[(0, 0), (1, 1)]), method="vertex")
    assert summaries(measure(across))[0] == "simple, parts overlap by 50 %, area 0.0 %"
    assert summaries(measure(beside))[0] == "simple, area 0.0 %"


def test_how_far_angles_drift_is_told_of_shapes_too() -> None:
    roof = Polygon([(20, 0), (30, 0), (30, 10), (25, 10), (20, 10)])
    house = Polygon([(20, 0), (30, 0), (30, 10), (25, 20), (20, 10)])
    both = match(Shape([SQUARE, roof]), Shape([SQUARE, house]), [[(0, 0)]] * 2, pairing=[(0, 0), (1, 1)])
    report = measure(blend(both, method="vertex"))
    assert report.angle_deviation > 0.01
    assert f"angles drift by {np.degrees(report.angle_deviation):.1f} degrees" in details(report)
