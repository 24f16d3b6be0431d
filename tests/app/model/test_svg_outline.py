import numpy as np
import pytest

from app.model.svg_outline import outline_svg, outlines_of
from starskel.errors import InvalidFile
from starskel.outline import signed_areas
from starskel.polygon import Polygon
from starskel.predicates import Floats


def only(content: str) -> Floats:
    (ring,) = outlines_of(f'<svg xmlns="http://www.w3.org/2000/svg">{content}</svg>')
    return ring


def test_what_goes_out_comes_back() -> None:
    ring = np.array([(0.0, 0.0), (10.5, -3.25), (7.125, 12.0)])
    (back,) = outlines_of(outline_svg(ring))
    np.testing.assert_allclose(back, ring, atol=1e-6)


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
def test_lines_in_every_writing(data: str) -> None:
    assert only(f'<path d="{data}"/>').tolist() == [[0, 0], [10, 0], [10, -5], [0, -5]]


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
def test_a_circle_in_every_writing(content: str) -> None:
    ring = only(content)
    np.testing.assert_allclose(np.hypot(*(ring - (5, -6)).T), 4, atol=0.006)
    assert abs(signed_areas(ring)) == pytest.approx(np.pi * 16, rel=2e-3)


def test_quadratic_curves_go_on_smoothly() -> None:
    ring = only('<path d="M0 0 Q5 10 10 0 T20 0 Z"/>')
    np.testing.assert_allclose(ring[:, 1].min(), -5, atol=0.01)
    np.testing.assert_allclose(ring[:, 1].max(), 5, atol=0.01)


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
def test_transforms_of_groups_are_followed(transform: str, corner: tuple[float, float]) -> None:
    ring = only(f'<g transform="{transform}"><rect width="2" height="1"/></g>')
    np.testing.assert_allclose(ring[0], corner, atol=1e-12)


def test_the_largest_comes_first_and_what_is_not_drawn_is_left_out() -> None:
    rings = outlines_of(
        "<svg><defs><rect width='99' height='99'/></defs><rect width='2' height='2'/>"
        "<polygon points='0,0 9,0 9,9'/></svg>"
    )
    assert [len(Polygon(ring)) for ring in rings] == [3, 4]


@pytest.mark.parametrize(
    "text",
    [
        "<svg",
        "<svg><path d='M0 0 L1'/></svg>",
        "<svg><path d='L1 1'/></svg>",
        "<svg><g transform='spin(3)'/></svg>",
    ],
)
def test_damage_is_said(text: str) -> None:
    with pytest.raises(InvalidFile, match="damaged"):
        outlines_of(text)


def test_entities_are_refused() -> None:
    with pytest.raises(InvalidFile, match="entities"):
        outlines_of('<!DOCTYPE svg [<!ENTITY a "b">]><svg/>')
