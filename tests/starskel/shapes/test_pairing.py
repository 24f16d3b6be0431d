"""Pairs of rings: suggested, given, refused; parts alone and parts that are cut."""

import numpy as np
import pytest
import shapely

import starskel
from starskel import InvalidMarks, Shape, suggest_pairing
from tests.starskel.shapes.drawn import BAR, COLON, EIGHT, FACE, A, B, D, I, J, O, T, ellipse, moved


@pytest.mark.parametrize("angle", [0.0, 0.5, -2.0, 2.9])
@pytest.mark.parametrize("rings", [I, B, FACE])
def test_rings_of_a_turned_copy_find_themselves(rings, angle):
    copy = moved(rings[::-1], angle, 300, 20)
    last = len(rings) - 1
    assert suggest_pairing(Shape(rings), Shape(copy)) == [(k, last - k) for k in range(len(rings))]


@pytest.mark.parametrize(("source", "target"), [(I, J), (A, T), (B, D), (T, EIGHT), (COLON, BAR), (B, FACE)])
def test_exchanged_shapes_have_the_same_pairs(source, target):
    there, back = suggest_pairing(Shape(source), Shape(target)), suggest_pairing(Shape(target), Shape(source))
    assert set(there) == {(i, j) for j, i in back}
    assert {i for i, _ in there} - {None} == set(range(len(source)))


def test_what_is_left_over_has_no_partner():
    assert suggest_pairing(Shape(I), Shape(T)) == [(0, 0), (1, None)]
    assert suggest_pairing(Shape(B), Shape(D)) == [(0, 0), (1, 1), (2, None)]


@pytest.mark.parametrize(
    ("source", "target", "pairing", "message"),
    [
        (I, I, [(0, 0)], r"ring 1 of the source is in no pair; pair it, or say by \(1, None\)"),
        (I, I, [(0, 0), (1, None)], "ring 1 of the target is in no pair"),
        (I, I, [(0, 0), (1, 2)], "names ring 2 of the target, which has 2"),
        (A, I, [(0, 0), (1, 1)], "one is an outline and the other a hole"),
        (I, I, [(0, 0), (None, None)], r"\(None, None\) is given for a pair of rings"),
        (I, I, [(0, 0), (1, 0), (1, 1), (0, 1)], "both have several partners"),
        (I, I, [(0, 0), (1, 1), (1, 1)], r"the pairing has \(1, 1\) twice"),
        (A, B, [(0, 0), (1, 1), (1, 2)], "ring 1 of the source, a hole, is in several pairs"),
        (B, A, [(0, 0), (1, 1), (2, 1)], "ring 1 of the target, a hole, is in several pairs"),
        (I, I, [(0, 0), (1, 1), (1, None)], "has partners, and is alone besides"),
        (B, B, [(0, None), (None, 0), (1, 1), (2, 2)], "what they are holes in is not"),
        ([*I, ellipse(9, 90, 3, 3)], A, [(0, 0), (1, None), (2, 1)], "what they are holes in is not"),
    ],
)
def test_pairings_that_leave_something_open_are_refused(source, target, pairing, message):
    with pytest.raises(InvalidMarks, match=message):
        starskel.match(Shape(source), Shape(target), pairing=pairing)


def test_marks_and_places_must_belong_to_rings():
    with pytest.raises(InvalidMarks, match="1 lists of marks for 2 rings"):
        starskel.match(Shape(I), Shape(J), [[(0, 0)]])
    with pytest.raises(InvalidMarks, match="a place is given for"):
        starskel.match(Shape(I), Shape(J), places={(0, 0): (1, 1)})
    with pytest.raises(InvalidMarks, match="is cut into parts"):
        starskel.match(Shape(BAR), Shape(COLON), [[(0, 0)]], pairing=[(0, 0), (0, 1)])
    with pytest.raises(InvalidMarks, match="which is not inside its part"):
        starskel.match(Shape(A), Shape(T), places={(1, None): (500, 500)})


def test_a_part_grows_from_the_place_chosen_and_a_hole_closes_there():
    grown = starskel.blend(Shape(T), Shape(I), method="stitched", places={(None, 1): (5, 6)})
    np.testing.assert_allclose(grown.at(0)[1], np.tile((5.0, 6.0), (12, 1)), atol=1e-9)
    closed = starskel.blend(Shape(A), Shape(T), method="stitched", places={(1, None): (40, 30)})
    np.testing.assert_allclose(closed.at(1)[1], np.tile((40.0, 30.0), (3, 1)), atol=1e-9)


def test_a_part_takes_its_holes_along():
    pair = starskel.match(Shape([*T, *moved(A, 0, 200)]), Shape(T), pairing=[(0, 0), (1, None), (2, None)])
    blend = starskel.blend(pair)
    assert pair.outer == (-1, -1, 1)
    assert blend.shape_at(0.9).geoms[1].is_valid
    assert len(blend.shape_at(0.9).geoms[1].interiors) == 1
    assert len(blend.shape_at(1).geoms) == 1


@pytest.mark.parametrize("method", ["stitched", "star-skeleton", "edge-angle", "vertex"])
@pytest.mark.parametrize(
    ("source", "target", "pairing"),
    [
        (BAR, COLON, [(0, 0), (0, 1)]),
        ([EIGHT[0]], COLON, [(0, 0), (0, 1)]),
        (T, [*COLON, ellipse(40, 40, 10, 10)], [(0, 0), (0, 1), (0, 2)]),
        (EIGHT, [*O, *moved(O, 0, 90, 30)], [(0, 0), (0, 2), (1, 1), (2, 3)]),
    ],
)
def test_one_part_becomes_several_along_cuts_and_several_one(source, target, pairing, method):
    split = starskel.blend(Shape(source), Shape(target), method=method, pairing=pairing)
    joined = [(j, i) for i, j in pairing]
    merged = starskel.blend(Shape(target), Shape(source), method=method, pairing=joined)
    whole, parts = Shape(source).to_shapely(), Shape(target).to_shapely()
    for blend, ends in ((split, (whole, parts)), (merged, (parts, whole))):
        for t, end in enumerate(ends):
            shape = blend.shape_at(t)
            assert sum(part.area for part in shape.geoms) == pytest.approx(end.area)
            assert shapely.union_all(shape.geoms).symmetric_difference(end).area < 1e-6
