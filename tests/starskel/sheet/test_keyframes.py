"""Keyframes: what of a blend is to be seen."""

import numpy as np
import pytest

import starskel
from starskel.errors import StarskelError
from starskel.export.film import Film, Scene, Track
from starskel.export.settings import Settings, even_times
from starskel.images.placed import PlacedImage
from starskel.sheet.keyframe import Shown
from starskel.sheet.keyframes import keyframes
from starskel.sheet.style import PartLook

SQUARE = np.array([(0, 0), (4, 0), (4, 4), (0, 4)], dtype=float)
HIDDEN, SEEN = PartLook(visible=False), PartLook()


def growing():
    """A square that stays, and another one that grows from a point."""
    shapes = starskel.Shape([SQUARE]), starskel.Shape([SQUARE, SQUARE + 10])
    pair = starskel.match(*shapes, pairing=[(0, 0), (None, 1)], places={(None, 1): (9, 9)})
    return starskel.blend(pair, "vertex")


def test_what_is_a_point_is_left_out_where_something_else_is_to_be_seen():
    start, end = keyframes(growing(), [0, 1])
    assert [len(start.parts), len(end.parts)] == [1, 2]
    assert [len(frame.parts) for frame in keyframes(growing(), [0, 1], moving=True)] == [2, 2]


@pytest.mark.parametrize("layout", ["frames", "row"])
def test_a_point_stands_for_the_only_part_that_is_to_be_seen(layout):
    picture = PlacedImage.in_box(np.full((5, 5, 3), 90, dtype=np.uint8), (12, 12), (5, 5))
    scene = Scene(growing(), looks=(HIDDEN, SEEN), pictures=lambda: (None, picture))
    (start,) = scene.frames([0], Shown())
    assert start.box.tolist() == [[9, 9], [9, 9]]
    assert start.simple
    assert not len(start.crossings)
    for pictured in (False, True):
        film = Film("Growing", (Track("vertex", (scene,)),), Settings(layout, even_times(3)))
        assert len(list(film.drawings(pictured=pictured))) == (3 if layout == "frames" else 1)


def test_all_parts_may_not_be_hidden():
    with pytest.raises(StarskelError, match="all parts are hidden; show at least one of them"):
        keyframes(growing(), [0.5], looks=(HIDDEN, HIDDEN))


@pytest.mark.parametrize("method", starskel.METHODS)
def test_a_polygon_is_seen_as_the_shape_of_this_one_polygon_is(method):
    kite = np.array([(1, 0), (3, 2), (1, 5), (-1, 2)], dtype=float)
    one = starskel.blend(SQUARE, kite, [(0, 0), (2, 2)], method)
    shapes = starskel.Shape([SQUARE]), starskel.Shape([kite])
    same = starskel.blend(starskel.match(*shapes, [[(0, 0), (2, 2)]], pairing=[(0, 0)]), method)
    shown = Shown(marks=True, pieces=method != "certified", vertices=True)
    for frame, other in zip(*(keyframes(blend, [0, 0.5, 1], shown) for blend in (one, same)), strict=True):
        assert frame.parts[0].rings[0] == pytest.approx(other.parts[0].rings[0], abs=1e-9)
        assert frame.pins == pytest.approx(other.pins, abs=1e-9)
        assert frame.vertices == pytest.approx(other.vertices, abs=1e-9)
        assert len(frame.parts[0].pieces) == len(other.parts[0].pieces)
