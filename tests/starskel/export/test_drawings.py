"""Drawings as files: what other programs make of them, and what stands in them."""

import io
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from pypdf import PdfReader
from pypdf.generic import ContentStream

from starskel.export.pdf import pdf_document
from starskel.export.postscript import eps_text, postscript_text
from starskel.export.svg import svg_text
from starskel.sheet.drawing import Area, Disc, Drawing, Group, Label, Line, Stroke
from tests.starskel.export.rendering import (
    DOTS,
    assert_filled,
    ghostscript,
    needs_ghostscript,
    needs_rsvg,
    painted_box,
    rendered_postscript,
    rendered_svg,
    write_eps,
    write_pdf,
    write_postscript,
    write_svg,
)

INK = Stroke("#203040", 0.5)
UPSIDE = np.array(
    [[20, 10], [35, 10], [35, 60], [90, 60], [90, 75], [20, 75]], dtype=float
)  # no symmetry at all
TEXTS = ("edge-angle", "(a) \\ b) 100 % <&> \"'", "Größe \u2013 5 µm", "куб → 方", "\0\n\t\x1b", "")


def drawing(*items, width=120.0, height=85.5, title="A title"):
    return Drawing(title, width, height, items)


def everything(ring=UPSIDE):
    labels = [
        Label(text, (60, 8 + 10 * i), 8, "#102030", anchor, bold)
        for i, text in enumerate(TEXTS)
        for anchor, bold in (("start", True), ("middle", False), ("end", True))
    ]
    shapes = (Area(ring, "#aaccee", INK), Line(ring, INK), Disc((50, 40), 5, "#ff0000", INK), Disc((9, 9), 2))
    return drawing(Group("frame <&> 1", shapes), *labels, title=TEXTS[1])


@needs_rsvg
def test_an_svg_file_shows_the_area_where_it_is(tmp_path):
    write_svg(tmp_path / "a.svg", drawing(Area(UPSIDE, "#3366cc")))
    picture = rendered_svg(tmp_path / "a.svg")
    assert picture.shape == (85.5 * DOTS, 120 * DOTS)
    assert_filled(picture, UPSIDE)


@needs_ghostscript
def test_an_eps_file_shows_the_area_where_it_is(tmp_path):
    write_eps(tmp_path / "a.eps", drawing(Area(UPSIDE, "#3366cc"), height=85.0))
    (picture,) = rendered_postscript(tmp_path / "a.eps")
    assert picture.shape == (85 * DOTS, 120 * DOTS)
    assert_filled(picture, UPSIDE)


@needs_ghostscript
@pytest.mark.parametrize(("write", "name"), [(write_postscript, "a.ps"), (write_pdf, "a.pdf")])
def test_a_document_shows_every_area_on_its_page(tmp_path, write, name):
    rings = [UPSIDE, UPSIDE + np.array([20, 5]), UPSIDE * 0.5]
    write(tmp_path / name, [drawing(Area(ring, "#3366cc"), height=85.0) for ring in rings])
    pictures = rendered_postscript(tmp_path / name)
    assert len(pictures) == 3
    for picture, ring in zip(pictures, rings, strict=True):
        assert picture.shape == (85 * DOTS, 120 * DOTS)
        assert_filled(picture, ring)


@needs_rsvg
@needs_ghostscript
def test_all_formats_show_the_same(tmp_path):
    shapes = drawing(
        Area(UPSIDE, "#aaccee", INK),
        Line(UPSIDE * 0.5, Stroke("#aa0000", 4)),
        Disc((60, 40), 9, "#225511"),
        Area(UPSIDE[:3] + np.array([30, 5]), "#aa7711", None, (UPSIDE[:3] * 0.4 + [44, 9],)),
        height=85,
    )
    write_svg(tmp_path / "a.svg", shapes)
    write_eps(tmp_path / "a.eps", shapes)
    write_pdf(tmp_path / "a.pdf", [shapes])
    first = rendered_svg(tmp_path / "a.svg").astype(float)
    assert np.mean(first < 200) > 0.02
    for name in ("a.eps", "a.pdf"):
        second = rendered_postscript(tmp_path / name)[0].astype(float)
        assert np.mean(np.abs(first - second) > 40) < 0.01


@needs_ghostscript
def test_what_is_painted_lies_in_the_bounding_box(tmp_path):
    write_eps(tmp_path / "a.eps", drawing(Area(UPSIDE, "#aaccee", INK)))
    assert painted_box(tmp_path / "a.eps") == pytest.approx([19.75, 9.75, 90.25, 75.25], abs=0.05)


@needs_ghostscript
def test_text_of_any_kind_is_no_postscript_error(tmp_path):
    write_eps(tmp_path / "a.eps", everything())
    assert (rendered_postscript(tmp_path / "a.eps")[0] < 128).any()


@needs_rsvg
def test_text_of_any_kind_is_no_svg_error(tmp_path):
    write_svg(tmp_path / "a.svg", everything())
    assert (rendered_svg(tmp_path / "a.svg") < 128).any()


@needs_ghostscript
@pytest.mark.parametrize("anchor", ["start", "middle", "end"])
def test_text_stands_where_its_anchor_says(tmp_path, anchor):
    write_eps(tmp_path / "a.eps", drawing(Label("mmmm", (60, 40), 10, "#000000", anchor), height=85))
    columns = np.flatnonzero((rendered_postscript(tmp_path / "a.eps")[0] < 128).any(axis=0)) / DOTS
    expected = {"start": columns[0], "middle": (columns[0] + columns[-1]) / 2, "end": columns[-1]}[anchor]
    assert expected == pytest.approx(60, abs=1.5)


@needs_ghostscript
def test_an_eps_file_can_be_included_in_a_page(tmp_path):
    """It leaves the stacks as they were and defines nothing that would hide the page's own names."""
    write_eps(tmp_path / "a.eps", everything())
    page = tmp_path / "page.ps"
    page.write_text(
        f"/m (mine) def /showpage {{}} def 1 2 countdictstack ({tmp_path}/a.eps) run\n"
        "countdictstack eq count 3 eq and m (mine) eq and { (well) = } { (ill) = } ifelse\n"
    )
    assert ghostscript(f"--permit-file-read={tmp_path}/", "-sDEVICE=nullpage", page) == b"well\n"


def test_coordinates_are_read_back_from_svg_to_a_millionth(tmp_path):
    ring = np.random.default_rng(1).random((50, 2)) * [120, 85.5]
    root = ET.fromstring(svg_text(drawing(Area(ring, "#aaccee"))))
    (path,) = root.iter("{http://www.w3.org/2000/svg}path")
    numbers = np.array(re.findall(r"-?\d+\.?\d*", path.get("d")), dtype=float).reshape(-1, 2)
    assert np.abs(numbers * [1, -1] + [0, 85.5] - ring).max() <= 1e-6


def test_coordinates_are_read_back_from_postscript_to_a_millionth():
    ring = np.random.default_rng(2).random((50, 2)) * [120, 85.5]
    text = eps_text(drawing(Area(ring, "#aaccee")))
    numbers = np.array(re.findall(r"^(\S+) (\S+) [ml]$", text, re.MULTILINE), dtype=float)
    assert np.abs(numbers - ring).max() <= 1e-6


def test_coordinates_are_read_back_from_pdf_to_a_millionth():
    ring = np.random.default_rng(3).random((50, 2)) * [4000, 85.5]
    page = PdfReader(io.BytesIO(pdf_document([drawing(Area(ring, "#aaccee"), width=4000.0)]))).pages[0]
    operations = ContentStream(page.get_contents(), None).operations
    numbers = [[float(value) for value in values] for values, name in operations if name in (b"m", b"l")]
    assert np.abs(numbers - ring).max() <= 1e-6


def test_text_of_any_kind_and_the_title_are_kept_in_pdf():
    reader = PdfReader(io.BytesIO(pdf_document([everything()])))
    assert reader.metadata.title == TEXTS[1]
    assert "Größe \u2013 5 µm" in reader.pages[0].extract_text()


def test_names_and_titles_are_kept_in_svg():
    root = ET.fromstring(svg_text(everything()))
    assert root.find("{http://www.w3.org/2000/svg}title").text == TEXTS[1]
    assert root.find("{http://www.w3.org/2000/svg}g").get("id") == "frame <&> 1"
    shown = [label.text or "" for label in root.iter("{http://www.w3.org/2000/svg}text")]
    assert shown[:9:3] == list(TEXTS[:3])


def test_postscript_is_plain_seven_bit_text_with_short_lines():
    for text in (eps_text(everything()), postscript_text([everything()] * 2)):
        assert text.isascii()
        assert max(map(len, text.splitlines())) <= 255


def test_a_document_says_how_many_pages_it_has_and_where_they_begin():
    text = postscript_text([drawing(), drawing(width=200.25), drawing()])
    assert text.startswith("%!PS-Adobe-3.0\n%%BoundingBox: 0 0 201 86\n%%HiResBoundingBox: 0 0 200.25 85.5\n")
    assert "\n%%Pages: 3\n" in text
    assert re.findall(r"^%%Page: (.*)$", text, re.MULTILINE) == ["1 1", "2 2", "3 3"]
    assert text.endswith("\n%%EOF\n")


@pytest.mark.parametrize("render", [svg_text, eps_text, lambda drawing: pdf_document([drawing])])
def test_equal_drawings_are_equal_files(render):
    assert render(everything(UPSIDE)) == render(everything(UPSIDE.copy()))
