"""Silhouettes read from pictures."""

import numpy as np
import pytest
import shapely
from PIL import Image, ImageDraw

from starskel.cli import main
from starskel.errors import InvalidFile
from starskel.files.projects.project_file import read_project
from starskel.reading.readers import read_shapes

RING = shapely.Point(100, 80).buffer(60).difference(shapely.Point(100, 80).buffer(25))
FORMS = {"opaque": ("RGBA", (0, 0, 0, 0)), "dark": ("RGB", (250, 250, 250)), "light": ("RGB", (5, 5, 5))}


def picture(path, what):
    """A ring and a small square beside it, on their ground, four times as large and then shrunk."""
    mode, ground = FORMS[what]
    image = Image.new(mode, (1000, 640), ground)
    ink = (5, 5, 5) if what == "dark" else (250, 250, 250)
    draw = ImageDraw.Draw(image)
    draw.ellipse((160, 80, 640, 560), fill=ink)
    draw.ellipse((300, 220, 500, 420), fill=ground)
    draw.rectangle((800, 80, 880, 160), fill=ink)
    image.resize((250, 160), Image.Resampling.BOX).save(path)
    return path


@pytest.mark.parametrize("ending", [".png", ".jpg", ".webp"])
@pytest.mark.parametrize("what", FORMS)
def test_a_silhouette_has_its_parts_and_holes_within_a_pixel(tmp_path, what, ending):
    if what == "opaque" and ending == ".jpg":
        pytest.skip("JPEG knows no transparency")
    reading = read_shapes(picture(tmp_path / f"ring{ending}", what))
    (found,) = reading.shapes
    area = found.shape.to_shapely()
    known = shapely.union(RING, shapely.box(200, 120, 220, 140))
    assert found.shape.outer in {(-1, -1, 0), (-1, 0, -1)}
    assert shapely.hausdorff_distance(area.boundary, known.boundary) < 1.6
    assert found.repairs == (f"what is {what} was traced",)


def test_what_holds_no_silhouette_is_told(tmp_path):
    Image.new("RGB", (40, 30), "#888").save(tmp_path / "grey.png")
    (tmp_path / "no.png").write_bytes(b"GIF89b, or something")
    for name in ("grey.png", "no.png"):
        with pytest.raises(InvalidFile, match=name):
            read_shapes(tmp_path / name)


def test_two_pictures_become_a_project(tmp_path):
    paths = [str(picture(tmp_path / f"{what}.png", what)) for what in ("dark", "light")]
    assert main(["convert", *paths, "-o", str(tmp_path / "ways.json")]) == 0
    first, second = read_project(tmp_path / "ways.json").shapes
    assert np.isclose(first.shape.area, second.shape.area, rtol=0.02)
