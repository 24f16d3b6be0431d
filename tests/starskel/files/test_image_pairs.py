import json
from dataclasses import replace

import numpy as np
import pytest

from starskel.errors import InvalidFile
from starskel.files.image_pairs import picture_of, read_image_pairs
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project
from starskel.files.projects.step import Step
from starskel.files.raster_writing import png_of, write_image
from starskel.polygon import Polygon
from tests.starskel.images.drawn import waves

OUTLINE = [[5, 5], [5, 25], [25, 25], [25, 5]]


def document(tmp_path, **changes):
    side = {"image": "a.png", "outline": OUTLINE, "name": "a"}
    entry = {"id": "one", "p": side, "q": {**side, **changes}, "marks": [[0, 0], [2, 2]]}
    path = tmp_path / "images.json"
    path.write_text(json.dumps({"format": "image-pairs/1", "pairs": [entry]}))
    write_image(tmp_path / "a.png", waves(40, 30))
    return path


def test_outlines_lie_on_their_pictures(tmp_path):
    pair = read_image_pairs(document(tmp_path)).pair("one")
    assert np.array_equal(pair.source.pixels, waves(40, 30))
    places = pair.source.to_picture(pair.shapes.source.vertices)
    assert {tuple(place) for place in places.tolist()} == {tuple(map(float, row)) for row in OUTLINE}
    for i, j in pair.shapes.marks:
        assert np.array_equal(pair.shapes.source.vertices[i], pair.shapes.target.vertices[j])
    assert pair.shapes.source.vertices[pair.shapes.marks[1][0]].tolist() == [25, 5]


def test_a_pair_is_a_project_with_the_pictures_where_they_were(tmp_path):
    path = document(tmp_path)
    pair = read_image_pairs(path).pair("one")
    project = pair.project
    assert project.name == "one"
    assert project.steps[0].links[0].marks == pair.shapes.marks
    for number, image in enumerate((pair.source, pair.target)):
        assert project.shapes[number].picture.content == (tmp_path / "a.png").read_bytes()
        placed = picture_of(path, project, number)
        assert np.array_equal(placed.pixels, image.pixels)
        np.testing.assert_allclose(placed.placement, image.placement, atol=1e-12)


@pytest.mark.parametrize("name", ["../a.png", "/etc/a.png", "x/../../a.png", "..\\a.png"])
def test_pictures_outside_the_folder_are_not_read(tmp_path, name):
    with pytest.raises(InvalidFile, match="not in the folder of the file"):
        read_image_pairs(document(tmp_path, image=name)).pair("one")


def test_what_is_wrong_is_said_with_its_place(tmp_path):
    with pytest.raises(InvalidFile, match=r'pair "one": target \(q\): '):
        read_image_pairs(document(tmp_path, outline=[[0, 0], [1, 1]])).pair("one")
    with pytest.raises(InvalidFile, match=r"missing\.png cannot be read"):
        read_image_pairs(document(tmp_path, image="missing.png")).pair("one")


def test_pictures_of_a_project_lie_where_it_says(tmp_path):
    square = Polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
    picture = Picture(png_of(waves(40, 20)), (2.0, 3.0), (8.0, 4.0))
    project = Project("p", (replace(KeyShape.of(square), picture=picture), KeyShape.of(square)), (Step.of(),))
    placed = picture_of(tmp_path / "p.json", project, 0)
    assert picture_of(tmp_path / "p.json", project, 1) is None
    assert placed.to_document([(0, 0), (40, 20)]).tolist() == [[-2, 5], [6, 1]]
    upright = replace(project.shapes[0], picture=replace(picture, rotation=np.pi / 2))
    turned = picture_of(tmp_path / "p.json", replace(project, shapes=(upright, project.shapes[1])), 0)
    np.testing.assert_allclose(turned.to_document([(0, 0), (40, 20)]), [[0, -1], [4, 7]], atol=1e-12)
    damaged = replace(project.shapes[0], picture=replace(picture, content=b"none"))
    with pytest.raises(InvalidFile, match="the picture of shape A is no picture"):
        picture_of(tmp_path / "p.json", replace(project, shapes=(damaged, project.shapes[1])), 0)
