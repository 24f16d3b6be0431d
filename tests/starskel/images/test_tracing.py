import numpy as np
import pytest
import shapely

import starskel
from starskel.images.placed import PlacedImage
from starskel.images.tracing import trace
from tests.starskel.images.drawn import noise


def disc(size=100, radius=30.0, hole=0.0, middle=None):
    """Opaque where a disc with a hole is, pixels at its edges in proportion."""
    y, x = np.mgrid[:size, :size] + 0.5
    far = np.hypot(x - (middle or size / 2), y - size / 2)
    alpha = (radius - far + 0.5).clip(0, 1) * ((far - hole + 0.5).clip(0, 1) if hole else 1)
    pixels = np.full((size, size, 4), 90, dtype=np.uint8)
    pixels[..., 3] = np.rint(255 * alpha)
    return pixels


def on(pixels, ground):
    alpha = pixels[..., 3:] / 255
    return np.rint(pixels[..., :3] * alpha + ground * (1 - alpha)).astype(np.uint8)


@pytest.mark.parametrize("tolerance", [0.0, 0.5, 2.0])
def test_a_disc_is_traced_within_the_tolerance(tolerance):
    shape = trace(PlacedImage(disc()), tolerance=tolerance)
    (ring,) = shape.rings
    far = np.hypot(*(ring.vertices - 50).T)
    assert np.abs(far - 30).max() < 0.1
    whole, found = shapely.Point(50, 50).buffer(30, 64).exterior, shapely.Polygon(ring.vertices).exterior
    assert shapely.hausdorff_distance(whole, found) < tolerance + 0.15
    assert len(ring) < (1000 if not tolerance else 60 if tolerance < 1 else 30)


def test_holes_and_parts_are_kept_when_they_are_asked_for():
    image = PlacedImage(np.concatenate([disc(hole=12), disc(radius=14)], axis=1))
    assert trace(image).outer == (-1, 0)
    assert trace(image, holes=False).outer == (-1,)
    everything = trace(image, parts="all")
    assert everything.outer == (-1, 0, -1)
    wanted = np.pi * (30**2 - 12**2 + 14**2)
    assert abs(everything.area - wanted) < 0.02 * wanted


def test_an_island_in_a_hole_is_a_part_again():
    pixels = disc(hole=20)
    pixels[..., 3] |= disc(radius=8)[..., 3]
    assert trace(PlacedImage(pixels), parts="all").outer == (-1, 0, -1)


def test_specks_are_left_out():
    pixels = disc()
    pixels[3, 3, 3] = pixels[90, 8, 3] = 255
    pixels[50, 50, 3] = 0
    assert len(trace(PlacedImage(pixels), parts="all", tolerance=0)) == 1


@pytest.mark.parametrize(("ground", "by"), [(255, "dark"), (0, "light")])
def test_without_alpha_what_stands_out_against_the_border_is_traced(ground, by):
    pixels = on(disc(), ground)
    pixels = np.where(disc()[..., 3:] > 127, 255 - ground, pixels).astype(np.uint8)
    shape = trace(PlacedImage(pixels))
    assert shape == trace(PlacedImage(pixels), by=by)
    assert abs(shape.area - np.pi * 30**2) < 0.03 * np.pi * 30**2
    assert np.abs(shape.rings[0].vertices - 50).max() < 31


def test_the_level_decides_what_belongs_to_it():
    y, x = np.mgrid[:50, :50]
    ramp = np.repeat((255 - 5 * np.hypot(x - 25, y - 25)).clip(0, 255)[..., None], 3, axis=2).astype(np.uint8)
    areas = [trace(PlacedImage(ramp), by="light", level=level).area for level in (0.3, 0.6, 0.9)]
    assert areas == sorted(areas, reverse=True)
    for level, area in zip((0.6, 0.9), areas[1:], strict=True):
        assert abs(np.sqrt(area / np.pi) - 51 * (1 - level)) < 0.8


def test_what_reaches_the_border_ends_there():
    shape = trace(PlacedImage(np.zeros((20, 30, 3), dtype=np.uint8)), by="dark", tolerance=0.1)
    assert np.abs(np.array(shape.part(0).bounds) - (0, 0, 30, 20)).max() < 0.01
    assert shape.area > 599


def test_the_outline_is_where_the_picture_is():
    middle, turn = (10.0, -4.0), 0.7
    pixels = disc(middle=70.0)
    shape = trace(PlacedImage.in_box(pixels, middle, (5.0, 5.0), turn))
    centre = np.array(shape.part(0).centroid.coords[0])
    wanted = np.array(middle) + np.array([np.cos(turn), np.sin(turn)])  # 20 of 100 pixels to the right
    assert np.abs(centre - wanted).max() < 0.02
    mirrored = trace(PlacedImage(pixels, [[-1, 0, 0], [0, -1, 0]]))
    assert mirrored.rings[0].area > 0


def test_large_pictures_are_traced_at_a_part_of_their_size():
    small, large = disc(), np.kron(disc(), np.ones((21, 21, 1), dtype=np.uint8))
    first, second = trace(PlacedImage(small)), trace(PlacedImage(large), tolerance=21)
    assert abs(second.area / 21**2 - first.area) < 0.035 * first.area


@pytest.mark.parametrize("seed", range(6))
def test_noise_gives_simple_polygons_or_a_clear_answer(seed):
    shape = trace(PlacedImage(noise(60, 50, seed)), level=0.3 + 0.1 * (seed % 3), parts="all")
    assert all(shape.part(outline).is_valid for outline in shape.outlines)
    for part in shape.outlines:
        assert shapely.Polygon(shape.rings[part].vertices).is_simple


def test_bad_input_is_refused():
    nothing = PlacedImage(np.zeros((9, 9, 4), dtype=np.uint8))
    with pytest.raises(starskel.StarskelError, match="nothing in the picture is opaque enough at"):
        trace(nothing)
    with pytest.raises(starskel.StarskelError, match="a level of 1"):
        trace(nothing, level=1)
    with pytest.raises(starskel.StarskelError, match="a tolerance of -1"):
        trace(nothing, tolerance=-1)
    with pytest.raises(
        starskel.StarskelError, match="'red' is given for what is traced; give 'alpha' or 'dark' or"
    ):
        trace(nothing, by="red")
    with pytest.raises(starskel.StarskelError, match="'some' is given for the choice of parts"):
        trace(nothing, parts="some")
    with pytest.raises(starskel.StarskelError, match="is given for the level and the tolerance"):
        trace(nothing, level="half")
    with pytest.raises(starskel.StarskelError, match="a picture of type ndarray"):
        trace(nothing.pixels)
    with pytest.raises(starskel.StarskelError, match="choose a larger tolerance: 20000"):
        trace(PlacedImage(noise(400, 400)), tolerance=0, parts="all")


def test_an_outline_of_too_many_places_is_refused_before_it_is_simplified():
    checks = np.zeros((1200, 1200, 4), dtype=np.uint8)
    checks[::2, ::2, 3] = 255
    with pytest.raises(starskel.StarskelError, match=r"at 1800000 places; .*: 300000 are the most"):
        trace(PlacedImage(checks), parts="all")


def test_the_traced_outline_carries_the_picture():
    image = PlacedImage(disc())
    shape = trace(image, tolerance=0.5)
    frame = starskel.image_morph(
        starskel.blend(shape.rings[0], shape.rings[0]), image, t=0, size=(100, 100), view=(0, 0, 100, 100)
    )
    assert np.abs(frame[..., 3].astype(int) - disc()[..., 3]).mean() < 1
