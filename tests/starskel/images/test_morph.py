import numpy as np
import pytest
import shapely

import starskel
from starskel.images.morph import ImageMorph, image_morph
from starskel.images.placed import PlacedImage
from tests.starskel.images.drawn import noise, premultiplied, waves

SIZE = 96, 80
VIEW = 0.0, 0.0, 96.0, 80.0

SOURCE = np.array([(12, 8), (60, 10), (88, 30), (70, 36), (84, 70), (40, 60), (14, 72), (24, 40)])
TARGET = np.array([(8, 16), (50, 6), (86, 18), (60, 44), (90, 62), (46, 74), (6, 60), (40, 34)])


def inside(ring, size=SIZE, reach=0.0):
    x, y = np.meshgrid(np.arange(size[0]) + 0.5, size[1] - np.arange(size[1]) - 0.5)
    return shapely.contains_xy(shapely.Polygon(ring).buffer(-reach), x, y)


@pytest.fixture(scope="module")
def pair():
    return starskel.match(SOURCE, TARGET, marks=[(k, k) for k in range(8)])


@pytest.fixture(scope="module", params=starskel.METHODS)
def blend(request, pair):
    return starskel.blend(pair, method=request.param)


@pytest.mark.parametrize("quality", ["precise", "preview"])
@pytest.mark.parametrize("seed", [None, 1])
def test_at_the_ends_the_pictures_are_the_input_inside_the_outline(blend, quality, seed):
    first = waves(*SIZE) if seed is None else noise(*SIZE, seed=seed)
    second = waves(*SIZE, phase=2) if seed is None else noise(*SIZE, seed=seed + 1)
    morph = ImageMorph(blend, PlacedImage(first), PlacedImage(second))
    for t, ring, given in ((0, SOURCE, first), (1, TARGET, second)):
        frame = morph.at(t, SIZE, VIEW, quality=quality)
        deep = inside(ring, reach=0.75)
        off = np.abs(premultiplied(frame) - premultiplied(given))[deep]
        assert off.mean() <= 0.6
        if seed is None:
            assert (frame[..., 3][inside(ring)] > 0).all()  # none is missing
            assert off.max() <= 2
        assert (frame[~inside(ring, reach=-0.75)] == 0).all()


def test_at_the_ends_pixels_at_the_outline_count_by_what_lies_inside(pair):
    morph = ImageMorph(starskel.blend(pair), PlacedImage(np.full((80, 96, 3), 200, dtype=np.uint8)))
    x, y = np.meshgrid(np.arange(96), 79 - np.arange(80))
    cells = shapely.box(x, y, x + 1, y + 1)
    shares = shapely.area(shapely.intersection(shapely.Polygon(SOURCE), cells))
    assert np.abs(morph.at(0, SIZE, VIEW)[..., 3] - 255 * shares).max() <= 0.51
    assert (morph.at(0, SIZE, VIEW)[shares > 0.01][:, :3] == 200).all()


def test_colours_from_outside_the_outline_never_come_in(blend):
    pictures = []
    for ring in (SOURCE, TARGET):
        pixels = np.full((80, 96, 4), (255, 0, 0, 255), dtype=np.uint8)
        pixels[inside(ring, reach=-1e-9)] = (0, 90, 200, 255)
        pictures.append(PlacedImage(pixels))
    for t in (0, 0.3, 0.5, 0.9, 1):
        frame = ImageMorph(blend, *pictures).at(t, 150)
        assert (frame[..., 0][frame[..., 3] > 0] <= 1).all()


@pytest.mark.parametrize("method", ["star-skeleton", "stitched", "rigid", "certified"])
def test_a_picture_that_is_all_alike_has_no_seams(pair, method):
    flat = PlacedImage(np.full((80, 96, 3), 77, dtype=np.uint8))
    morph = ImageMorph(starskel.blend(pair, method=method), flat, flat)
    for quality in ("precise", "preview"):
        frame = morph.at(0.4, (611, 503), quality=quality)
        off = np.abs(premultiplied(frame)[..., :3] - frame[..., 3:] * (77 / 255))
        assert off.max() <= (0.51 if quality == "precise" else 1.01)
        assert set(np.unique(frame[frame[..., 3] == 255][:, :3])) == {77}
        whole = shapely.Polygon(starskel.blend(pair, method=method).at(0.4)).area
        left, bottom, right, top = morph.view
        area = frame[..., 3].sum() / 255 * (right - left) / 611 * (top - bottom) / 503
        assert abs(area - whole) < 1e-3 * whole


@pytest.mark.parametrize("method", starskel.METHODS)
def test_a_picture_morphed_to_itself_stands_still(method):
    picture = PlacedImage(waves(*SIZE, alpha=True))
    blend = starskel.blend(SOURCE, SOURCE, method=method)
    morph = ImageMorph(blend, picture, picture)
    first = premultiplied(morph.at(0, SIZE, VIEW))
    for t in (0.25, 0.5, 0.8):
        off = np.abs(premultiplied(morph.at(t, SIZE, VIEW)) - first)
        assert off.mean() <= 0.05
        assert off.max() <= 2


@pytest.mark.parametrize("method", ["star-skeleton", "stitched", "rigid", "certified", "edge-angle"])
def test_morphed_to_a_turned_copy_it_turns(method):
    pixels, angle, middle = waves(*SIZE), 1.0, (48.0, 40.0)
    turned = (np.exp(1j * angle) * (SOURCE @ (1, 1j) - complex(*middle))).view(float).reshape(-1, 2) + middle
    blend = starskel.blend(SOURCE, turned, [(k, k) for k in range(8)], method)
    pictures = [PlacedImage.in_box(pixels, middle, SIZE, rotation) for rotation in (0.0, angle)]
    frame = ImageMorph(blend, *pictures).at(0.5, SIZE, VIEW)
    ring = blend.at(0.5)
    centre = np.array(shapely.Polygon(ring).centroid.coords[0])
    own = np.array(shapely.Polygon(SOURCE).centroid.coords[0])
    back = np.exp(-0.5j * angle)
    alone = PlacedImage.in_box(pixels, middle, SIZE)
    y, x = np.nonzero(inside(ring, reach=1.5))
    places = (np.stack([x + 0.5, 80 - y - 0.5], axis=1) - centre) @ (1, 1j) * back
    there = alone.to_picture(np.stack([places.real, places.imag], axis=1) + own)
    column, row = np.floor(there).astype(int).T
    off = np.abs(frame[y, x].astype(float) - pixels[row, column])
    assert off.mean() < 9  # half a pixel away the waves differ by as much
    wrong = np.abs(frame[y, x].astype(float) - pixels[y, x])
    assert wrong.mean() > 30


def test_a_picture_alone_is_carried_all_the_way_at_full_strength(pair):
    blend = starskel.blend(pair)
    for given in ({"source": PlacedImage(waves(*SIZE))}, {"target": PlacedImage(waves(*SIZE))}):
        for t in (0, 0.5, 1):
            frame = image_morph(blend, t=t, size=SIZE, view=VIEW, **given)
            assert (frame[inside(blend.at(t), reach=0.75)][:, 3] == 255).all()


def test_a_transparent_picture_fades_the_other_one_out(pair):
    blend = starskel.blend(pair)
    nothing = PlacedImage(np.zeros((1, 1, 4), dtype=np.uint8))
    morph = ImageMorph(blend, PlacedImage(waves(*SIZE)), nothing, fade=lambda t: t)
    frame = morph.at(0.25, SIZE, VIEW)
    assert np.abs(frame[inside(blend.at(0.25), reach=0.75)][:, 3].astype(int) - 191).max() <= 1
    assert not morph.at(1, SIZE, VIEW).any()


def test_the_fade_says_how_much_of_the_target_is_seen(pair):
    black, white = (PlacedImage(np.full((80, 96, 3), level, dtype=np.uint8)) for level in (0, 255))
    blend = starskel.blend(pair)
    for fade, wanted in (
        (lambda t: t, 51),
        (lambda t: t * t, 10),
        (lambda t: 0.0, 0),
        (lambda t: 1.0, 255),
    ):
        frame = image_morph(blend, black, white, 0.2, SIZE, VIEW, fade=fade)
        assert np.abs(frame[inside(blend.at(0.2), reach=1)][:, 0].astype(int) - wanted).max() <= 1


def test_where_frames_cross_all_that_the_outline_goes_round_is_filled():
    strip = np.array([(0, 0), (60, 0), (60, 8), (0, 8)], dtype=float)
    coil = np.array([(0, 0), (60, 0), (60, 8), (0, 8)], dtype=float) @ [[-1, 0], [0, -1]] + (60, 8)
    blend = starskel.blend(strip, coil, [(k, k) for k in range(4)], method="vertex")
    picture = PlacedImage(np.full((8, 60, 3), 50, dtype=np.uint8))
    frame = ImageMorph(blend, picture, picture).at(0.45, (300, 300), (-5, -26, 65, 44))
    ring = blend.at(0.45)
    x, y = np.meshgrid(-5 + (np.arange(300) + 0.5) * 70 / 300, 44 - (np.arange(300) + 0.5) * 70 / 300)
    round_it = shapely.contains_xy(shapely.Polygon(ring).buffer(0), x, y)
    assert (frame[round_it][:, 3] > 0).all()


def test_fast_and_exact_frames_agree_within_a_few_levels(blend):
    morph = ImageMorph(blend, PlacedImage(waves(*SIZE, alpha=True)), PlacedImage(waves(*SIZE, 1)))
    for t in (0.2, 0.5, 0.7):
        first, second = (premultiplied(morph.at(t, 200, quality=q)) for q in ("precise", "preview"))
        assert np.abs(first - second).mean() < 0.5


@pytest.mark.parametrize("quality", ["precise", "preview"])
def test_colours_are_multiplied_by_alpha_when_that_is_asked_for(pair, quality):
    morph = ImageMorph(starskel.blend(pair), PlacedImage(waves(*SIZE, alpha=True)))
    straight = premultiplied(morph.at(0.4, SIZE, VIEW, quality=quality))
    assert np.abs(morph.at(0.4, SIZE, VIEW, quality=quality, premultiplied=True) - straight).max() <= 1.5


def test_shrunk_pictures_are_means_and_do_not_flicker(pair):
    checks = (np.indices((160, 192)).sum(axis=0) % 2).astype(np.uint8) * 255
    picture = PlacedImage.in_box(np.repeat(checks[..., None], 3, axis=2), (48, 40), (96, 80))
    morph = ImageMorph(starskel.blend(pair), picture, picture)
    for quality in ("precise", "preview"):
        frame = morph.at(0.5, (24, 20), VIEW, quality=quality)
        seen = frame[frame[..., 3] == 255][:, :3].astype(int)
        assert np.abs(seen - 127).max() < 40  # at the outline some means are of a few texels
        assert np.percentile(np.abs(seen - 127), 85) < 8


def test_equal_input_gives_equal_output_and_preparing_changes_nothing(pair):
    first, second = noise(*SIZE), noise(*SIZE, seed=1)
    kept = first.copy()
    frames = [
        image_morph(starskel.blend(pair), PlacedImage(first), PlacedImage(second), 0.4, 120) for _ in range(2)
    ]
    assert np.array_equal(*frames)
    assert np.array_equal(first, kept)


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_size_and_place_of_the_document_make_no_difference(pair, scale):
    def moved(points):
        return (points + np.array([3, -7])) * scale

    frames = []
    for change in (lambda points: points, moved):
        corner, right, down = change(np.array([(0, 80), (96, 80), (0, 0)], dtype=float))
        placement = np.stack([(right - corner) / 96, (down - corner) / 80, corner], axis=1)
        blend = starskel.blend(change(SOURCE), change(TARGET), [(k, k) for k in range(8)])
        pictures = [PlacedImage(waves(*SIZE, phase), placement) for phase in (0, 1)]
        view = change(np.array([(0, 0), (96, 80)], dtype=float)).ravel()
        frames.append(premultiplied(ImageMorph(blend, *pictures).at(0.5, SIZE, tuple(view))))
    assert np.abs(frames[0] - frames[1]).mean() < 0.05


def test_source_and_target_exchanged_run_backwards(pair):
    first, second = PlacedImage(waves(*SIZE)), PlacedImage(waves(*SIZE, 1))
    forwards = ImageMorph(starskel.blend(SOURCE, TARGET, [(k, k) for k in range(8)]), first, second)
    backwards = ImageMorph(starskel.blend(TARGET, SOURCE, [(k, k) for k in range(8)]), second, first)
    one, two = forwards.at(0.3, SIZE, VIEW), backwards.at(0.7, SIZE, VIEW)
    assert np.abs(premultiplied(one) - premultiplied(two)).max() <= 2


def test_bad_input_is_refused(pair):
    blend = starskel.blend(pair)
    picture = PlacedImage(waves(*SIZE))
    with pytest.raises(starskel.StarskelError, match="no picture; give one"):
        ImageMorph(blend)
    morph = ImageMorph(blend, picture)
    with pytest.raises(starskel.StarskelError, match="t = 2 is outside"):
        morph.at(2)
    with pytest.raises(starskel.StarskelError, match="0 × 5 pixels; give from 1"):
        morph.at(0.5, (0, 5))
    with pytest.raises(starskel.StarskelError, match="no area; give its left"):
        morph.at(0.5, 8, (1, 0, 0, 1))
    with pytest.raises(starskel.StarskelError, match=r"the fade gives 1\.5"):
        ImageMorph(blend, picture, fade=lambda t: 1.5).at(0.5)
    for more, message in (
        ({"size": 0.5}, r"the size is 0\.5; give width and height"),
        ({"size": "8"}, "the size is '8'"),
        ({"size": (8, 8, 8)}, "the size is"),
        ({"size": True}, "the size is True"),
        ({"view": (0, 0, 1)}, "is given for the view; give 4 finite numbers"),
        ({"view": (0, 0, np.nan, 1)}, "given for the view"),
        ({"quality": "best"}, "'best' is given for the quality; give 'precise' or 'preview'"),
    ):
        with pytest.raises(starskel.StarskelError, match=message):
            morph.at(0.5, **more)
    for fade in (lambda t: None, lambda t: np.nan):
        with pytest.raises(starskel.StarskelError, match="is given for what the fade gives"):
            ImageMorph(blend, picture, fade=fade).at(0.5)
    for solid in (-1, 0.5, "2"):
        with pytest.raises(starskel.StarskelError, match="is given for solid; give a whole number"):
            ImageMorph(blend, picture, solid=solid)
    with pytest.raises(
        starskel.StarskelError, match="the picture of the target is of type ndarray; give a Pl"
    ):
        ImageMorph(blend, picture, picture.pixels)
    for more in ({"middle": "ab"}, {"size": (1, np.inf)}, {"middle": (1, 2, 3)}, {"rotation": "a"}):
        with pytest.raises(starskel.StarskelError, match=r"is given for the .*; give . finite numbers"):
            PlacedImage.in_box(picture.pixels, **{"middle": (0, 0), "size": (1, 1)} | more)
    for pixels in ("a", [[1, 2], [3]], None):
        with pytest.raises(starskel.StarskelError, match="a picture of shape"):
            PlacedImage(pixels)
    with pytest.raises(starskel.StarskelError, match="the placement 'a' of a picture"):
        PlacedImage(picture.pixels, "a")
    with pytest.raises(starskel.StarskelError, match=r"shape \(4, 4\) and type uint8"):
        PlacedImage(np.zeros((4, 4), dtype=np.uint8))
    with pytest.raises(starskel.StarskelError, match="scale it down to at most 16384"):
        PlacedImage(np.broadcast_to(np.zeros(4, dtype=np.uint8), (1, 20000, 4)))
    with pytest.raises(starskel.StarskelError, match="keeps an area"):
        PlacedImage(waves(4, 4), [[1, 1, 0], [1, 1, 0]])


def test_it_stops_when_it_is_told_to(pair):
    with pytest.raises(starskel.Cancelled):
        ImageMorph(starskel.blend(pair, method="vertex"), PlacedImage(waves(*SIZE)), should_stop=lambda: True)
