"""The letters with holes among the examples, with shapely as the judge."""

import numpy as np
import pytest
import shapely

import starskel
from starskel.files.projects.examples import example, example_names

LETTERS = [name for name in example_names() if name.startswith("letters-")]
METHODS = ("stitched", "rigid", "star-skeleton", "certified")


def test_there_are_letters_with_one_hole_with_two_and_of_two_parts():
    pairs = [example(name).pair(0) for name in LETTERS]
    assert [pair.source.outer for pair in pairs] == [(-1, 0), (-1, 0, 0), (-1, -1), (-1, 0)]
    assert all(not any(pair.marks) for pair in pairs)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", LETTERS)
def test_holes_stay_inside_and_parts_apart(name, method):
    pair = example(name).pair(0)
    blend = starskel.blend(pair.source, pair.target, method=method, pairing=pair.pairing)
    outer = blend.pair.outer
    for rings in blend.frames(np.linspace(0, 1, 41)):
        areas = [shapely.Polygon(ring) for ring in rings]
        assert all(area.is_valid for area in areas)
        for ring, owner in enumerate(outer):
            if owner >= 0:
                assert areas[owner].contains_properly(areas[ring])
        for one in range(len(areas)):
            for other in range(one):
                if outer[one] == outer[other]:
                    assert areas[one].disjoint(areas[other])


@pytest.mark.parametrize("name", LETTERS)
def test_a_letter_is_given_back_exactly(name):
    pair = example(name).pair(0)
    blend = starskel.blend(pair.source, pair.target, pairing=pair.pairing)
    for t, shape, side in ((0, pair.source, 0), (1, pair.target, 1)):
        for ring, link in zip(blend.at(t), blend.pair.pairing, strict=True):
            given = shapely.Polygon(shape.rings[link[side]].vertices)
            assert shapely.hausdorff_distance(given, shapely.Polygon(ring)) <= 1e-9 * given.length
