"""Letters read from fonts, beside what FreeType draws of them."""

from pathlib import Path

import numpy as np
import pytest
import shapely
from PIL import Image, ImageDraw, ImageFont

from starskel.cli import main
from starskel.errors import InvalidFile
from starskel.files.projects.project_file import read_project
from starskel.reading.readers import read_shapes

FONT = next(Path("/usr/share/fonts").rglob("DejaVuSans.ttf"), Path("no font"))
EM = 2048

needs_font = pytest.mark.skipif(not FONT.exists(), reason="DejaVu Sans is not installed")


def drawn_by_freetype(text, size=256):
    """Where FreeType sees a text, as an array of booleans, the base line one size from above."""
    font = ImageFont.truetype(FONT, size, layout_engine=ImageFont.Layout.BASIC)
    image = Image.new("L", (size * len(text), 2 * size))
    ImageDraw.Draw(image).text((0, size), text, font=font, fill=255, anchor="ls")
    return np.asarray(image) > 127


@needs_font
@pytest.mark.parametrize("text", ["B", "g", "&", "Öl", "HiH"])
def test_a_text_is_where_freetype_draws_it(text):
    seen = drawn_by_freetype(text)
    (found,) = read_shapes(FONT, texts=[text]).shapes
    assert found.name == text
    area = shapely.transform(found.shape.to_shapely(), lambda p: p * [1, -1] / EM * 256 + [0, 256])
    x, y = np.meshgrid(np.arange(seen.shape[1]) + 0.5, np.arange(seen.shape[0]) + 0.5)
    assert seen.sum() > 1000
    assert seen[shapely.contains_xy(area.buffer(-1.5), x, y)].all()
    assert not seen[~shapely.contains_xy(area.buffer(1.5), x, y)].any()


@needs_font
def test_curves_are_left_by_no_more_than_the_tolerance():
    rough, fine = (read_shapes(FONT, tolerance, texts=["O"]).shapes[0].shape for tolerance in (1e-2, 1e-6))
    away = shapely.hausdorff_distance(rough.to_shapely().boundary, fine.to_shapely().boundary)
    assert len(rough.rings[0]) < len(fine.rings[0]) / 20
    assert away <= 1e-2 * 1556


@needs_font
def test_letters_are_placed_with_kerning():
    width = {
        text: np.ptp(read_shapes(FONT, texts=[text]).shapes[0].shape.to_shapely().bounds[::2])
        for text in ("AV", "AH", "A", "V", "H")
    }
    assert width["AV"] - width["A"] - width["V"] < width["AH"] - width["A"] - width["H"] - 100


@needs_font
def test_without_texts_the_usual_letters_are_given():
    names = [found.name for found in read_shapes(FONT).shapes]
    assert names[:3] == ["A", "B", "C"]
    assert len(names) == len(set(names)) == 65


@needs_font
@pytest.mark.parametrize(
    ("text", "message"), [("a\u4e2d", 'has no letter "\u4e2d"'), (" ", "a text is empty"), ("", "is empty")]
)
def test_a_text_that_cannot_be_set_is_told(text, message):
    with pytest.raises(InvalidFile, match=message) as caught:
        read_shapes(FONT, texts=[text])
    assert "DejaVuSans.ttf" in str(caught.value)


@needs_font
@pytest.mark.parametrize("length", [0, 9, 4000, 300_000])
def test_a_damaged_font_gives_a_message_or_letters_but_never_a_crash(tmp_path, length):
    path = tmp_path / "cut.ttf"
    path.write_bytes(FONT.read_bytes()[:length])
    try:
        told = bool(read_shapes(path).shapes)
    except InvalidFile as error:
        told = "cut.ttf" in str(error)
    assert told


@needs_font
def test_two_texts_become_a_project(tmp_path):
    path = tmp_path / "letters.json"
    assert main(["convert", str(FONT), "--text", "ä", "--text", "&", "-o", str(path)]) == 0
    project = read_project(path)
    assert [len(shape.parts) for shape in project.shapes] == [4, 2]
