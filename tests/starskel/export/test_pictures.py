"""Films as pixels: what Pillow and FFmpeg's libraries read of them."""

from dataclasses import replace

import av
import numpy as np
import pytest
import shapely
from PIL import Image, ImageSequence

from starskel.errors import InvalidFile, StarskelError
from starskel.export.animation import Animation
from starskel.export.formats import FORMATS
from starskel.export.pixels import pixels_of
from starskel.export.write import write
from starskel.files import raster_writing
from starskel.sheet.drawing import Area, Disc, Drawing, Line, Stroke
from starskel.sheet.keyframe import Shown
from starskel.sheet.style import Look
from tests.starskel.export.films import arm, pictured, ring, steps
from tests.starskel.export.rendering import needs_ghostscript, needs_rsvg, run

MOVING = (".gif", ".apng", ".webp")
SQUARE = np.array([[10, 10], [30, 10], [30, 30], [10, 30]], dtype=float)
HOLE = (SQUARE - 20) / 2 + 20
FEW = {"rate": 5.0, "duration": 2.0, "pixels": 160}


def drawing(*items):
    return Drawing("A title", 40.0, 60.0, items)


def seen(path):
    """The pictures of an animation as arrays, and how long each is seen, in thousandths of a second."""
    with Image.open(path) as image:
        return [
            (np.array(own.convert("RGBA")), own.info.get("duration")) for own in ImageSequence.Iterator(image)
        ]


def size(path):
    with Image.open(path) as image:
        return image.size


def own_frame(film, time):
    """What the blend has at a share of the way, in the picture of the film: rings in pixels, y down."""
    scene, t = film.tracks[0].at(time, film.settings.eased)
    frame = film.tracks[0].scenes[scene].blend.at(t)
    stage, look = Animation(film).stage, film.settings.look
    scale = stage.longer_side / np.ptp(stage.box, axis=0).max()
    width, height = np.ptp(stage.box, axis=0) * scale + 2 * look.margin
    dots = film.settings.pixels / max(width, height)
    rings = [frame] if isinstance(frame, np.ndarray) else frame
    places = [(own - stage.box[0]) * scale + look.margin for own in rings]
    return [np.column_stack([own[:, 0], height - own[:, 1]]) * dots for own in places]


def assert_shows(picture, rings):
    """Show that just these rings are covered, but for two pixels at their edges."""
    area = shapely.Polygon(rings[0], rings[1:2] if len(rings) > 2 else [])
    area = shapely.union_all([area, *map(shapely.Polygon, rings[2:])])
    height, width = picture.shape[:2]
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    inside, near = (shapely.contains_xy(area.buffer(by), x, y) for by in (-2, 2))
    assert inside.sum() > 100
    assert (picture[inside, 3] == 255).all()
    assert (picture[~near, 3] == 0).all()


def test_what_is_drawn_is_where_it_belongs_in_its_colours_with_smooth_edges():
    picture = pixels_of(drawing(Area(SQUARE, "#4080c0", None, (HOLE,)), Disc((20, 50), 5, "#ff0000")))
    assert picture.shape == (120, 80, 4)
    assert picture[80, 25].tolist() == [64, 128, 192, 255]
    assert picture[80, 40].tolist() == [0, 0, 0, 0]
    assert picture[20, 40].tolist() == [255, 0, 0, 255]
    edge = picture[(picture[..., 3] > 0) & (picture[..., 3] < 255)]
    assert len(edge) > 20
    # an edge has the colour of what it is the edge of, however little of it there is
    assert (np.abs(edge[:, :3].astype(int) - [255, 0, 0]).max(axis=1) < 12).all()


def test_strokes_are_round_where_they_turn_and_end():
    corner = np.array([[10, 10], [30, 10], [10, 13]], dtype=float)
    picture = pixels_of(drawing(Line(corner, Stroke("#000000", 6))))
    covered = picture[..., 3] > 127
    known = shapely.LineString(corner * [2, -2] + [0, 120]).buffer(6)
    x, y = np.meshgrid(np.arange(80) + 0.5, np.arange(120) + 0.5)
    assert abs(covered.sum() - known.area) < 0.02 * known.area
    assert not covered[~shapely.contains_xy(known.buffer(1), x, y)].any()


@pytest.mark.parametrize("longer_side", [1, 7, 333])
def test_a_picture_has_the_size_asked_for(longer_side):
    height, width = pixels_of(drawing(Area(SQUARE, "#4080c0")), longer_side).shape[:2]
    assert (height, width) == (longer_side, max(1, round(longer_side * 2 / 3)))


def test_too_many_pixels_are_refused_before_they_are_drawn():
    with pytest.raises(StarskelError, match="20000"):
        pixels_of(drawing(), 20_000)
    with pytest.raises(StarskelError, match="at most 50000000"):
        pixels_of(drawing(), 12_000)


@pytest.mark.parametrize("ending", MOVING)
@pytest.mark.parametrize(
    "film", [arm(**FEW), ring(**FEW), steps(**FEW, eased=True)], ids=lambda film: film.name
)
def test_moving_pictures_show_every_frame_where_the_blend_has_it(film, ending, tmp_path):
    film = replace(film, settings=replace(film.settings, look=Look(outline=None)))
    (path,) = write(tmp_path / f"film{ending}", film)
    pictures = seen(path)
    assert [length for _, length in pictures] == [200] * 10
    for time, (picture, _) in zip(film.settings.moments, pictures, strict=True):
        assert max(picture.shape) == 160
        assert_shows(picture, own_frame(film, time))


@pytest.mark.parametrize("ending", MOVING)
def test_an_animation_comes_back_the_same_way_and_plays_for_ever(ending, tmp_path):
    film = arm(rate=4.0, duration=1.5, returning=True, pixels=60)
    (path,) = write(tmp_path / f"film{ending}", film)
    pictures = [picture for picture, _ in seen(path)]
    assert len(pictures) == 10
    for there, back in zip(pictures[1:5], pictures[:5:-1], strict=True):
        assert (there == back).all()
    with Image.open(path) as image:
        assert image.info["loop"] == 0


def test_video_shows_every_frame_at_its_rate_on_the_paper(tmp_path):
    film = arm(**FEW | {"rate": 12.5, "pixels": 161})
    film = replace(film, settings=replace(film.settings, look=Look(outline=None, paper="#000000")))
    (path,) = write(tmp_path / "film.mp4", film)
    with av.open(str(path)) as container:
        (stream,) = container.streams
        assert stream.average_rate == 12.5
        pictures = [own.to_ndarray(format="rgb24") for own in container.decode(stream)]
    assert len(pictures) == 25
    assert pictures[0].shape[1] == 162
    for time, picture in list(zip(film.settings.moments, pictures, strict=True))[::6]:
        alpha = np.where(picture.max(axis=2) > 90, 255, 0)
        height, width = picture.shape[:2]
        area = shapely.Polygon(own_frame(film, time)[0])
        x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
        assert (alpha[shapely.contains_xy(area.buffer(-3), x, y)] == 255).all()
        assert (alpha[~shapely.contains_xy(area.buffer(3), x, y)] == 0).all()


def test_every_layout_of_pictures_can_be_png(tmp_path):
    film = arm(times=(0.0, 0.3, 1.0), pixels=120)
    settings = replace(film.settings, layout="frames")
    paths = write(tmp_path / "film.png", replace(film, settings=settings))
    assert [path.name for path in paths] == ["film-0001.png", "film-0002.png", "film-0003.png"]
    assert len({size(path) for path in paths}) == 1
    (row,) = write(tmp_path / "row.png", replace(film, settings=replace(settings, layout="row")))
    assert size(row)[0] == 120


@pytest.mark.parametrize("found", [own for own in FORMATS if own.module in ("png", "gif", "webp", "mp4")])
def test_equal_films_give_equal_pictures(found, tmp_path):
    layout = found.layouts[0]
    films = [arm(pixels=80, rate=2.0) for _ in range(2)]
    written = [
        write(
            tmp_path / f"{number}{found.ending}",
            replace(film, settings=replace(film.settings, layout=layout)),
        )
        for number, film in enumerate(films)
    ]
    assert written[0][0].read_bytes() == written[1][0].read_bytes()


def test_an_animation_that_would_fill_the_memory_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(raster_writing, "MOVING_PIXELS", 10_000)
    with pytest.raises(InvalidFile, match="too many pixels: 10 times 160"):
        write(tmp_path / "film.gif", arm(**FEW))
    assert not list(tmp_path.iterdir())


def assert_two_colours(picture):
    """Show that the middle row is red and then blue, and nothing round it."""
    middle = np.asarray(picture)[len(picture) // 2]
    red = (middle[:, 0] > 230) & (middle[:, 2] < 25)
    blue = (middle[:, 2] > 230) & (middle[:, 0] < 25)
    assert np.flatnonzero(red).max() < np.flatnonzero(blue).min()
    assert abs(red.sum() / (red.sum() + blue.sum()) - 4 / 9) < 0.05
    assert red.sum() + blue.sum() > 0.3 * len(middle)


BARE = Look(margin=18.0, outline=Stroke("#00ff00", 5.0), captions=False, size=100.0)


def test_a_film_with_pictures_shows_them_in_place_of_fill_and_outline(tmp_path):
    film = pictured(layout="frames", times=(0.0, 0.5, 1.0), look=BARE)
    for path in write(tmp_path / "film.png", film):
        with Image.open(path) as image:
            assert_two_colours(np.array(image))
            assert np.array(image)[..., 1].max() == 0
    assert size(tmp_path / "film-0001.png") == (272, 172)


def test_moving_pictures_carry_pictures(tmp_path):
    (path,) = write(tmp_path / "film.webp", pictured(layout="animation", rate=2.0, look=BARE))
    pictures = [picture for picture, _ in seen(path)]
    assert len(pictures) == 6
    for picture in pictures:
        assert_two_colours(picture)


def test_shapes_are_drawn_where_pictures_are_not_wanted_or_cannot_be(tmp_path):
    film = pictured(layout="frames", times=(0.5,), look=BARE, shown=Shown(pictures=False))
    (path,) = write(tmp_path / "film.png", film)
    with Image.open(path) as image:
        assert np.array(image)[..., 1].max() == 255
    (path,) = write(tmp_path / "film.eps", pictured(layout="frames", times=(0.5,), look=BARE))
    assert b" stroked" in path.read_bytes()


@needs_rsvg
def test_svg_has_pictures_inside(tmp_path):
    (path,) = write(tmp_path / "film.svg", pictured(layout="frames", times=(0.5,), look=BARE))
    run("rsvg-convert", "-o", tmp_path / "seen.png", path)
    with Image.open(tmp_path / "seen.png") as image:
        assert_two_colours(np.array(image))


@needs_ghostscript
def test_pdf_has_pictures_inside_and_equal_films_give_equal_files(tmp_path):
    film = pictured(layout="frames", times=(0.5,), look=BARE)
    (path,), (again,) = (write(tmp_path / name, film) for name in ("film.pdf", "again.pdf"))
    assert path.read_bytes() == again.read_bytes()
    run("gs", "-q", "-dBATCH", "-dNOPAUSE", "-sDEVICE=png16m", f"-o{tmp_path / 'seen.png'}", path)
    with Image.open(tmp_path / "seen.png") as image:
        assert_two_colours(np.array(image))
