import numpy as np
import pytest
import shapely

import starskel
from starskel.images.morph import ImageMorph
from starskel.images.placed import PlacedImage
from tests.starskel.images.drawn import premultiplied, waves
from tests.starskel.shapes.regions import holed_pair

SIZE, VIEW = (120, 100), (0.0, 0.0, 120.0, 100.0)

FRAME = [(10, 10), (60, 12), (58, 60), (12, 56)]
HOLE = [(24, 22), (46, 24), (42, 44), (26, 40)]
DOT = [(84, 20), (100, 24), (96, 40), (82, 36)]


def moved(ring, x, y, turn=0.0):
    z = np.array(ring) @ (1, 1j)
    z = (z - z.mean()) * np.exp(1j * turn) + z.mean() + complex(x, y)
    return np.stack([z.real, z.imag], axis=1)


SOURCE = starskel.Shape([FRAME, HOLE, DOT])
TARGET = starskel.Shape([moved(FRAME, 40, 20), moved(HOLE, 40, 20), moved(DOT, -50, 40, 0.6)])
PAIRING = [(0, 0), (1, 1), (2, 2)]
MARKS = [[(0, 0)], [(0, 0)], [(0, 0)]]


def inside(shape, reach):
    x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5, SIZE[1] - np.arange(SIZE[1]) - 0.5)
    return shapely.contains_xy(shapely.union_all(list(shape.to_shapely().geoms)).buffer(-reach), x, y)


@pytest.mark.parametrize("method", starskel.METHODS)
def test_parts_and_holes_are_the_input_at_the_ends(method):
    first, second = waves(*SIZE), waves(*SIZE, 2)
    morph = ImageMorph(
        starskel.blend(SOURCE, TARGET, MARKS, method, pairing=PAIRING),
        PlacedImage(first),
        PlacedImage(second),
    )
    for quality in ("precise", "preview"):
        for t, shape, given in ((0, SOURCE, first), (1, TARGET, second)):
            frame = morph.at(t, SIZE, VIEW, quality=quality)
            off = np.abs(premultiplied(frame) - premultiplied(given))[inside(shape, 0.75)]
            assert off.mean() <= 0.6
            assert (frame[~inside(shape, -0.75)] == 0).all()  # also in the hole


@pytest.mark.parametrize("method", ["stitched", "vertex", "certified"])
def test_in_between_the_hole_stays_open_and_areas_are_covered(method):
    flat = PlacedImage(np.full((100, 120, 3), 90, dtype=np.uint8))
    blend = starskel.blend(SOURCE, TARGET, MARKS, method, pairing=PAIRING)
    frame = ImageMorph(blend, flat, flat).at(0.5, (480, 400), VIEW)
    outline = shapely.union_all(list(blend.shape_at(0.5).geoms)).area
    assert abs(frame[..., 3].sum() / 255 / 16 - outline) < 0.005 * outline


def test_pictures_follow_holes_that_are_kept_inside_by_a_repair():
    pair = holed_pair(27)
    blend = starskel.blend(pair, method="certified")
    assert blend.how == "convex morph"
    flat = PlacedImage.in_box(np.full((8, 8, 3), 90, dtype=np.uint8), (0, 0), (1e3, 1e3))
    morph = ImageMorph(blend, flat, flat)
    left, bottom, right, top = morph.view
    for t in (0.3, 0.6, 0.7):
        frame = morph.at(t, (400, 300))
        seen = frame[..., 3].sum() / 255 / 400 / 300 * (right - left) * (top - bottom)
        assert seen == pytest.approx(blend.shape_at(t).area, rel=1e-3)  # nothing is left out, nothing outside
        assert set(np.unique(frame[frame[..., 3] == 255][:, :3])) == {90}


def test_no_seam_where_a_part_is_cut_in_two():
    one = starskel.Shape([[(10, 10), (110, 10), (110, 60), (10, 60)]])
    two = starskel.Shape(
        [[(10, 10), (55, 10), (55, 60), (10, 60)], [(65, 10), (110, 10), (110, 60), (65, 60)]]
    )
    blend = starskel.blend(one, two, pairing=[(0, 0), (0, 1)])
    flat = PlacedImage(np.full((100, 120, 3), 90, dtype=np.uint8))
    for quality in ("precise", "preview"):
        frame = ImageMorph(blend, flat, flat).at(0, (177, 149), VIEW, quality=quality)
        middle = frame[67:125, 20:155]
        assert (middle[..., 3] >= 254).all()
        assert np.abs(middle[..., 0].astype(int) - 90).max() <= 1


def test_later_parts_lie_over_earlier_ones_and_let_them_through():
    shape = starskel.Shape.of_parts([(FRAME, []), (moved(FRAME, 20, 10), [])])
    blend = starskel.blend(shape, shape, pairing=[(0, 0), (1, 1)])
    pixels = np.full((100, 120, 4), (200, 0, 0, 255), dtype=np.uint8)
    frame = ImageMorph(blend, PlacedImage(pixels)).at(0, SIZE, VIEW)
    assert (frame[inside(shape, 0.75)] == (200, 0, 0, 255)).all()
    pixels[..., 3] = 128
    both = shapely.intersection(shape.part(0), shape.part(1)).buffer(-1)
    x, y = np.meshgrid(np.arange(120) + 0.5, 99.5 - np.arange(100))
    frame = ImageMorph(blend, PlacedImage(pixels)).at(0, SIZE, VIEW)
    alphas = frame[shapely.contains_xy(both, x, y)][:, 3].astype(int)
    assert np.abs(alphas - 255 * (1 - (127 / 255) ** 2)).max() <= 1


def test_a_hidden_part_is_not_painted():
    blend = starskel.blend(SOURCE, TARGET, MARKS, pairing=PAIRING)
    frame = ImageMorph(blend, PlacedImage(waves(*SIZE))).at(0, SIZE, VIEW, hidden=[2])
    assert not frame[:, 75:].any()
    assert frame[:, :70].any()


def test_a_part_that_grows_only_has_the_picture_that_it_belongs_to():
    source, target = starskel.Shape([FRAME]), starskel.Shape([FRAME, DOT])
    blend = starskel.blend(source, target, pairing=[(0, 0), (None, 1)])
    red, blue = (
        PlacedImage(np.full((100, 120, 3), colour, dtype=np.uint8)) for colour in ((255, 0, 0), (0, 0, 255))
    )
    frame = ImageMorph(blend, red, blue).at(0.5, SIZE, VIEW)
    ring = shapely.Polygon(blend.at(0.5)[1]).buffer(-1)
    x, y = np.meshgrid(np.arange(120) + 0.5, 99.5 - np.arange(100))
    grown = frame[shapely.contains_xy(ring, x, y)]
    assert len(grown) > 20
    assert (grown == (0, 0, 255, 255)).all()
    frame = ImageMorph(blend, red).at(0.5, SIZE, VIEW)
    assert not frame[shapely.contains_xy(ring, x, y)].any()
