"""One shape in every writing that SVG has for it."""

from pathlib import Path

import numpy as np
import pytest

from app.model.svg_outline import outline_svg
from starskel.outline import signed_areas
from starskel.reading.curves import flattened
from starskel.reading.readers import read_content
from starskel.shapes.shape import Shape

QUARTER_HANDLE = 0.5522847498
QUARTER = np.array([(1.0, 0.0), (1.0, QUARTER_HANDLE), (QUARTER_HANDLE, 1.0), (0.0, 1.0)])


def ring_of(svg):
    (found,) = read_content(svg.encode(), Path("drawing.svg")).shapes
    (ring,) = found.shape.rings
    return ring.vertices


def only(content):
    return ring_of(f'<svg xmlns="http://www.w3.org/2000/svg">{content}</svg>')


def test_what_the_clipboard_gets_comes_back():
    ring = np.array([(0.0, 0.0), (10.5, -3.25), (7.125, 12.0)])
    np.testing.assert_allclose(
        np.ptp(ring_of(outline_svg(Shape([ring]))), axis=0), np.ptp(ring, axis=0), atol=1e-6
    )


@pytest.mark.parametrize(
    "data",
    [
        "M0 0 L10 0 10 5 0 5 Z",
        "m0,0h10v5h-10z",
        "M 0 0 H 10 V 5 H 0 Z",
        "M0-0l10 0 0 5-10 0z",
        "M0 0 10 0 10 5 0 5",
    ],
)
def test_lines_in_every_writing(data):
    assert only(f'<path d="{data}"/>').tolist() == [[0, 0], [0, -5], [10, -5], [10, 0]]


@pytest.mark.parametrize(
    "content",
    [
        '<circle cx="5" cy="6" r="4"/>',
        '<ellipse cx="5" cy="6" rx="4" ry="4"/>',
        '<path d="M1 6a4 4 0 1 1 8 0A4 4 0 0 1 1 6z"/>',
        '<path d="M1,6a4,4,0,018,0 4 4 0 01-8 0z"/>',
        '<path d="M1 6C1 3.790861 2.790861 2 5 2S9 3.790861 9 6 7.209139 10 5 10 1 8.209139 1 6Z"/>',
    ],
)
def test_a_circle_in_every_writing(content):
    ring = only(content)
    np.testing.assert_allclose(np.hypot(*(ring - (5, -6)).T), 4, atol=0.006)
    assert abs(signed_areas(ring)) == pytest.approx(np.pi * 16, rel=2e-3)


def test_quadratic_curves_go_on_smoothly():
    ring = only('<path d="M0 0 Q5 10 10 0 T20 0 V-20 H0 Z"/>')
    np.testing.assert_allclose(ring[:, 1].min(), -5, atol=0.01)
    np.testing.assert_allclose(ring[:, 1].max(), 20, atol=0.01)
    np.testing.assert_allclose(ring[np.abs(ring[:, 0] - 15).argmin(), 1], 5, atol=0.1)


@pytest.mark.parametrize(
    ("transform", "corner"),
    [
        ("translate(3)", (3, 0)),
        ("translate(3, 4)", (3, -4)),
        ("scale(2) translate(1 1)", (2, -2)),
        ("matrix(1 0 0 1 7 8)", (7, -8)),
        ("rotate(90 1 0)", (1, 1)),
        ("skewX(45)", (0, 0)),
    ],
)
def test_transforms_of_groups_are_followed(transform, corner):
    ring = only(f'<g transform="{transform}"><rect width="2" height="1"/></g>')
    np.testing.assert_allclose(ring[0], corner, atol=1e-12)


@pytest.mark.parametrize("tolerance", [0.1, 0.01, 0.001])
def test_a_curve_is_left_by_no_more_than_the_tolerance(tolerance):
    path = np.concatenate([QUARTER[:1], flattened(QUARTER, tolerance)])
    away = 1 - np.hypot(*((path[1:] + path[:-1]) / 2).T)
    assert away.max() < tolerance + 3e-4  # the curve itself leaves the circle by as much
    assert len(flattened(QUARTER, 4 * tolerance)) < len(path)


def test_a_straight_curve_is_one_line_and_ends_are_exact():
    assert flattened(np.array([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]), 0.01).tolist() == [[3, 3]]
    assert flattened(QUARTER, 1e-9)[-1].tolist() == [0, 1]
