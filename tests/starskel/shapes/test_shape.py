"""Shapes: rings nested, checked, to shapely and back."""

import numpy as np
import pytest
import shapely

from starskel import InvalidPolygon, Polygon, Shape
from tests.starskel.shapes.drawn import COLON, FACE, A, B, ellipse

SQUARE = np.array([(0, 0), (10, 0), (10, 10), (0, 10)], dtype=float)


def test_a_ring_inside_another_is_its_hole_and_one_inside_a_hole_a_part():
    shape = Shape([SQUARE, SQUARE * 0.5 + 2, SQUARE * 0.2 + 4])
    assert shape.outer == (-1, 0, -1)
    assert shape.outlines == (0, 2)
    assert shape.holes(0) == (1,)
    assert shape.area == pytest.approx(100 - 25 + 4)


def test_the_order_of_the_rings_does_not_matter_for_what_they_are():
    assert Shape([SQUARE * 0.2 + 4, SQUARE * 0.5 + 2, SQUARE]).outer == (-1, 2, -1)


def test_rings_that_cross_are_parts_that_overlap():
    assert Shape([SQUARE, SQUARE + 5]).outer == (-1, -1)


def test_parts_may_lie_on_each_other_where_that_is_said():
    assert Shape.of_parts([(SQUARE, []), (SQUARE * 0.5 + 2, [])]).outer == (-1, -1)


@pytest.mark.parametrize("rings", [A, B, COLON, FACE])
def test_shapely_goes_in_and_comes_out(rings):
    shape = Shape(rings)
    out = shape.to_shapely()
    assert out.is_valid
    assert out.area == pytest.approx(shape.area)
    assert Shape(out) == shape
    assert Shape(out.geoms[0]).rings[0] == shape.rings[0]


def test_a_shape_of_one_polygon():
    assert Shape(Polygon(SQUARE)).rings == (Polygon(SQUARE),)
    assert Shape(Shape([SQUARE])) == Shape([SQUARE])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (lambda: Shape([]), "without rings"),
        (lambda: Shape([SQUARE, SQUARE[[0, 2, 1, 3]] + 20]), r"ring 1: edges 0-1 and 2-3 cross"),
        (lambda: Shape(shapely.LineString(SQUARE)), "a LineString bounds no area"),
        (lambda: Shape.of_parts([(SQUARE, [SQUARE + 5])]), "ring 1, a hole, does not lie inside ring 0"),
        (
            lambda: Shape.of_parts([(SQUARE, [SQUARE * 0.5 + 1, SQUARE * 0.5 + 3])]),
            "rings 1 and 2, holes of one part, meet",
        ),
        (
            lambda: Shape.of_parts([(SQUARE, [ellipse(5, 5, 3, 3), ellipse(5, 5, 1, 1)])]),
            "rings 1 and 2, holes of one part, meet",
        ),
    ],
)
def test_what_is_no_shape_is_refused(given, message):
    with pytest.raises(InvalidPolygon, match=message):
        given()
