"""SVG files read, beside what librsvg paints of them."""

from pathlib import Path

import numpy as np
import pytest
import shapely

from starskel.errors import InvalidFile
from starskel.reading.readers import read_shapes
from tests.starskel.export.rendering import grey, needs_rsvg, run

ICONS = sorted((Path(__file__).parents[2] / "files" / "icons").glob("*.svg"))
ZOOM = 8

ALL_KINDS = """
<defs><rect id="tile" width="9" height="5"/><clipPath id="c"><circle r="80"/></clipPath></defs>
<style>.line { fill: none; stroke: black; stroke-width: 3 } .gone { display: none }</style>
<symbol id="sign"><path d="M0 0h9v9z"/></symbol>
<rect x="2" y="2" width="14" height="9" rx="3"/>
<circle cx="30" cy="8" r="6"/>
<ellipse cx="50" cy="8" rx="9" ry="5" transform="rotate(30 50 8)"/>
<polygon points="66,2 80,2 73,14"/>
<polyline points="84,2 96,2 90,14"/>
<line class="line" x1="4" y1="20" x2="16" y2="28" stroke-linecap="round"/>
<g transform="translate(22 18) scale(1.5)"><path d="M0 0 C0 8 8 8 8 0 S4 -4 0 0"/>
  <use href="#tile" x="12" y="2" transform="skewX(10)"/></g>
<path fill-rule="evenodd" d="M60 18h20v20h-20z M64 22h12v12h-12z"/>
<path d="M84 18h14v14h-14z M88 22h6v6h-6z"/>
<path d="M4 40 A8 5 20 1 1 16 44 Q10 52 6 44 T4 40z"/>
<path d="M22 36 l12 12 v-12 l-12 12z"/>
<use href="#sign" x="40" y="36"/>
<polyline class="line" points="54,44 64,54 74,44" stroke-linejoin="bevel"/>
<rect class="gone" width="100" height="60"/>
<text x="5" y="5"></text>
"""


def svg(inside, head='width="100" height="60" viewBox="0 0 100 60"'):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {head}>{inside}</svg>'


def read(folder, text, **options):
    (folder / "drawing.svg").write_text(text, encoding="utf-8")
    return read_shapes(folder / "drawing.svg", **options)


def assert_painted(folder, path, reading):
    """Show that what librsvg paints is what was read, up to a pixel at its edge."""
    image = folder / "painted.png"
    run("rsvg-convert", "-z", ZOOM, "-b", "white", "-o", image, path)
    dark = grey(image) < 128
    area = shapely.union_all([shapely.make_valid(found.shape.to_shapely()) for found in reading.shapes])
    area = shapely.transform(area, lambda points: points * [ZOOM, -ZOOM])
    x, y = np.meshgrid(np.arange(dark.shape[1]) + 0.5, np.arange(dark.shape[0]) + 0.5)
    assert dark.any()
    assert dark[shapely.contains_xy(area.buffer(-1.2), x, y)].all()
    assert not dark[~shapely.contains_xy(area.buffer(1.2), x, y)].any()


@needs_rsvg
@pytest.mark.parametrize("path", ICONS, ids=lambda path: path.stem)
def test_icons_are_read_as_they_are_painted(tmp_path, path):
    reading = read_shapes(path)
    assert reading.notes == ()
    assert_painted(tmp_path, path, reading)


@needs_rsvg
def test_every_kind_of_shape_is_read_as_it_is_painted(tmp_path):
    reading = read(tmp_path, svg(ALL_KINDS))
    assert len(reading.shapes) == 14
    assert_painted(tmp_path, tmp_path / "drawing.svg", reading)
    assert reading.notes == ("texts in the file were left out",)


@needs_rsvg
@pytest.mark.parametrize(
    ("head", "scale"),
    [
        ('width="2in" height="1in" viewBox="0 0 100 50"', 192 / 100),
        ('width="100" height="60" viewBox="-10 -5 200 120"', 1 / 2),
        ('width="50mm" height="30mm"', 1),
    ],
)
def test_view_boxes_and_units_are_honoured(tmp_path, head, scale):
    reading = read(tmp_path, svg('<path d="M2 2h30v40l-9 -30z"/>', head))
    assert_painted(tmp_path, tmp_path / "drawing.svg", reading)
    triangle = shapely.Polygon([(2, 2), (32, 2), (32, 42), (23, 12)])
    assert reading.shapes[0].shape.area == pytest.approx(scale**2 * triangle.area, rel=1e-6)


@pytest.mark.parametrize("tolerance", [0.01, 0.0005, 0.00001])
def test_curves_are_left_by_no_more_than_the_tolerance(tmp_path, tolerance):
    reading = read(tmp_path, svg('<circle cx="50" cy="30" r="20"/>'), tolerance=tolerance)
    ring = reading.shapes[0].shape.rings[0].vertices - [50, -30]
    middles = (ring + np.roll(ring, 1, axis=0)) / 2
    assert np.hypot(*middles.T).min() >= 20 - 40 * tolerance - 1e-3 * tolerance
    assert np.hypot(*ring.T) == pytest.approx(20, rel=3e-4)


def test_names_are_those_of_the_file_and_unique(tmp_path):
    square = "M{} 0h9v9z"
    paths = [
        f'<path {own} d="{square.format(12 * k)}"/>' for k, own in enumerate(('id="leaf"', "", 'id="leaf"'))
    ]
    assert [found.name for found in read(tmp_path, svg("".join(paths))).shapes] == [
        "leaf",
        "path 2",
        "leaf 2",
    ]


@pytest.mark.parametrize(
    ("path", "repairs", "area"),
    [
        ("M0 0h9v9h-9z", (), 81),
        ("M0 0h9v9h-9", ("an open path was closed",), 81),
        ("M0 0h9h0v9h-9z", ("repeated vertices were left out",), 81),
        ("M0 0l8 8v-8l-8 8z", ("it crossed or touched itself and was cut there",), 32),
        ("M0 0h9v9h-9z M2 2h3v3h-3z M3 3h5v5h-5z", ("it crossed or touched itself and was cut there",), 81),
        ("M0 0h9v9h-9z M20 20h3z", ("a part without an area was left out",), 81),
    ],
)
def test_what_is_mended_is_told(tmp_path, path, repairs, area):
    (found,) = read(tmp_path, svg(f'<path d="{path}"/>')).shapes
    assert (found.repairs, found.shape.area) == (repairs, pytest.approx(area))


def test_rings_that_touch_are_moved_apart(tmp_path):
    (found,) = read(tmp_path, svg('<path fill-rule="evenodd" d="M0 0h9v9h-9z M0 4l4 2l0 -4z"/>')).shapes
    assert found.repairs[-1] == "parts of it touched and were moved apart"
    assert found.shape.area == pytest.approx(81 - 8, rel=1e-4)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is damaged"),
        ("<svg", "is damaged"),
        ("<html/>", "is no SVG"),
        (svg(""), "holds no shape"),
        (svg('<path d="M0 0 L9 9"/>'), "holds no shape"),
        ('<!DOCTYPE svg [<!ENTITY a "aaaa">]>' + svg("<text>&a;</text>"), "declares entities"),
    ],
)
def test_what_cannot_be_read_is_told(tmp_path, text, message):
    with pytest.raises(InvalidFile, match=message) as caught:
        read(tmp_path, text)
    assert "drawing.svg" in str(caught.value)
