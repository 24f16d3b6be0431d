import tracemalloc

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from starskel.crossings import crossing_edges
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon
from tests.families import comb, two_opt

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]


def test_a_counter_clockwise_ring_is_kept_as_given():
    polygon = Polygon(SQUARE)
    np.testing.assert_array_equal(polygon.vertices, SQUARE)
    assert polygon.area == 4
    assert [polygon.vertex_of(i) for i in range(4)] == [0, 1, 2, 3]


def test_a_clockwise_ring_is_turned_round_and_knows_where_its_points_went():
    polygon = Polygon(SQUARE[::-1])
    assert polygon.area == 4
    for i, point in enumerate(SQUARE[::-1]):
        np.testing.assert_array_equal(polygon.vertices[polygon.vertex_of(i)], point)


def test_vertices_cannot_be_changed():
    with pytest.raises(ValueError, match="read-only"):
        Polygon(SQUARE).vertices[0] = 1


def test_a_closed_ring_and_a_shapely_polygon_give_the_same():
    assert Polygon([*SQUARE, SQUARE[0]]) == Polygon(SQUARE) == Polygon(shapely.Polygon(SQUARE))


@pytest.mark.parametrize(
    ("points", "message", "vertices"),
    [
        ([], "polygon of 0 points", ()),
        ([(0, 0), (1, 0)], "polygon of 2 points", ()),
        ("a shape", "not numbers", ()),
        ([(0, 0, 0), (1, 0, 0), (1, 1, 0)], "shape \\(3, 3\\)", ()),
        ([(0, 0), (1, float("nan")), (1, 1)], "vertex 1 is at \\(1, nan\\)", (1,)),
        ([(0, 0), (1, float("inf")), (1, 1)], "vertex 1", (1,)),
        ([(0, 0), (1, 1e200), (1, 1)], "vertex 1", (1,)),
        ([(0, 0), (1, 0), (1, 0), (0, 1)], "vertices 1 and 2 are both at \\(1, 0\\)", (1, 2)),
        ([(0, 0), (1, 0), (0, 1), (2, 2), (1, 0)], "vertices 1 and 4", (1, 4)),
        ([(0, 0), (2, 2), (2, 0), (0, 2)], "edges 0-1 and 2-3 cross or touch at \\(1, 1\\)", (0, 1, 2, 3)),
        ([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)], "edges 0-1 and 2-3", (0, 1, 2, 3)),
        ([(0, 0), (2, 0), (1, 0), (1, 1)], "edges 0-1 and 1-2", (0, 1, 1, 2)),
        ([(0, 0), (1, 0), (2, 0), (3, 0)], "area is zero", ()),
        ([(5, 5), (5, 5), (5, 5)], "all points are the same", ()),
    ],
)
def test_what_is_no_simple_polygon_is_refused_with_its_place(points, message, vertices):
    with pytest.raises(InvalidPolygon, match=message) as caught:
        Polygon(points)
    assert caught.value.vertices == vertices
    assert caught.value.mend


def test_a_shapely_polygon_with_a_hole_is_refused():
    with pytest.raises(InvalidPolygon, match="holes"):
        Polygon(shapely.Point(0, 0).buffer(2) - shapely.Point(0, 0).buffer(1))


@given(st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=3, max_size=8, unique=True))
def test_crossings_agree_with_shapely(points):
    ring = np.array(points, dtype=float)
    assert (len(crossing_edges(ring)) == 0) == shapely.is_simple(shapely.linearrings(ring))


def test_equal_polygons_hash_alike_and_tell_their_size():
    assert hash(Polygon(SQUARE)) == hash(Polygon([*SQUARE, SQUARE[0]]))
    assert len(Polygon(comb(5))) == len(comb(5))
    assert repr(Polygon(two_opt(12, 1))) == "Polygon of 12 vertices"


def test_rings_and_polygons_of_shapely_and_our_own_are_taken():
    ring = shapely.LinearRing(SQUARE)
    assert Polygon(ring) == Polygon(Polygon(SQUARE)) == Polygon(SQUARE)


@pytest.mark.parametrize(
    "points", [[("0", "0"), ("1", "0"), ("0", "1")], [(0, 0), (1, 0), (0, 1j)], [(10**400, 0)] * 3]
)
def test_what_numpy_would_bend_into_numbers_is_refused(points):
    with pytest.raises(InvalidPolygon, match="not numbers"):
        Polygon(points)


@pytest.mark.parametrize("far", [0.0, 1e6])
def test_a_vertex_within_the_rounding_of_an_edge_is_refused(far):
    near = 1e-9 if far else 1e-15
    with pytest.raises(InvalidPolygon, match="vertex 4 all but touches edge 0-1") as caught:
        Polygon(np.array([(0, 0), (4, 0), (4, 4), (3, 4), (2, near), (1, 4), (0, 4)]) + far)
    assert caught.value.vertices == (4, 0, 1)


def test_crossings_are_the_same_whatever_the_blocks(monkeypatch):
    tangle = np.random.default_rng(1).random((80, 2))
    whole = crossing_edges(tangle)
    assert len(whole) > 100
    for candidates in (1, 100, 1000):
        monkeypatch.setattr("starskel.crossings.CANDIDATES", candidates)
        np.testing.assert_array_equal(crossing_edges(tangle), whole)


def test_a_tangle_is_refused_without_taking_memory_for_all_its_crossings():
    points = np.random.default_rng(1).random((20_000, 2))  # some 40 million crossings
    tracemalloc.start()
    try:
        with pytest.raises(InvalidPolygon, match="cross or touch"):
            Polygon(points)
        assert tracemalloc.get_traced_memory()[1] < 200e6
    finally:
        tracemalloc.stop()


def test_ten_thousand_vertices_on_one_line_are_a_side_of_a_polygon_or_none():
    line = np.stack([np.arange(10_000.0), np.zeros(10_000)], axis=1)
    assert Polygon([*line, (5000, 3)]).area == 9999 * 1.5
    with pytest.raises(InvalidPolygon, match="area is zero"):
        Polygon(line)
