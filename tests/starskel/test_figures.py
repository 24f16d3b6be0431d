"""What the paper's figures claim, of the examples drawn after their captions."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely

import starskel
from starskel.correspondence.match import match
from starskel.decomposition.decompose import decompose
from starskel.errors import NoDecomposition
from starskel.files.image_pairs import picture_of
from starskel.files.projects.examples import example, example_names, figure_number
from starskel.images.morph import ImageMorph
from starskel.quality import measure
from starskel.shapes.blend import blend

FRAMES = 101


def pair_of(number):
    name = next(name for name in example_names() if figure_number(name) == number)
    pair = example(name).pair(0)
    return match(pair.source, pair.target, pair.marks)


def measured(number, method):
    return measure(blend(pair_of(number), method=method), FRAMES)


def test_there_is_an_example_of_each_figure_that_shows_shapes():
    numbers = [figure_number(name) for name in example_names() if figure_number(name)]
    assert numbers == [1, 2, 3, 4, 5, 6, 8, 9, 10, 11]


def test_figures_come_last_and_say_what_they_show():
    names = example_names()
    figures = [name for name in names if figure_number(name)]
    assert list(names[-len(figures) :]) == figures
    for name in figures:
        project = example(name)
        assert project.name.startswith(f"Figure {figure_number(name)}: ")
        assert len(project.name) <= 24  # fits a menu, and the sheet beside the times
        assert project.description.endswith(".")
        assert project.methods[0] == "star-skeleton"


def test_figure_1_shows_compatible_decompositions_into_several_pieces():
    decomposition = decompose(pair_of(1), steiner=False)
    assert len(decomposition.pieces) >= 10
    assert measured(1, "star-skeleton").simple


def test_figure_2_vertex_interpolation_shrinks_and_crosses():
    straight, skeleton, edges = (measured(2, m) for m in ("vertex", "star-skeleton", "edge-angle"))
    assert straight.area_deviations.min() < -0.5
    assert not straight.simple
    assert skeleton.simple
    assert edges.simple  # "produces similar results"
    assert max(skeleton.area_deviation, edges.area_deviation) < 0.05


@pytest.mark.parametrize("number", [3, 4])
def test_figures_3_and_4_edge_angle_interpolation_distorts_the_area(number):
    skeleton, edges = measured(number, "star-skeleton"), measured(number, "edge-angle")
    assert edges.area_deviation > 0.15
    assert skeleton.simple
    assert skeleton.area_deviation < edges.area_deviation / 2


@pytest.mark.parametrize("number", [5, 6])
def test_figures_5_and_6_edge_angle_interpolation_crosses_itself(number):
    skeleton, edges = measured(number, "star-skeleton"), measured(number, "edge-angle")
    assert not edges.simple
    assert skeleton.simple
    assert skeleton.area_deviation < edges.area_deviation


def test_figure_8_needs_two_steiner_vertices_for_four_pieces():
    pair = pair_of(8)
    assert len(pair) == 8
    with pytest.raises(NoDecomposition):
        decompose(pair, steiner=False)
    decomposition = decompose(pair)
    assert len(decomposition.source) - len(pair) == 2
    assert len(decomposition.pieces) == 4
    assert measured(8, "stitched").simple


@pytest.mark.parametrize("method", ["star-skeleton", "stitched", "rigid"])
def test_figure_9_parts_move_together_by_the_meta_skeleton(method):
    pair = example("figure-9-fish").pair(0)
    together, separate = (
        starskel.blend(pair.source, pair.target, pair.marks, method, pairing=pair.pairing, joined=joined)
        for joined in (True, False)
    )
    times = np.linspace(0, 1, 21)
    for rings in together.frames(times):
        parts = [shapely.Polygon(ring) for ring in rings]
        assert sum(part.area for part in parts) - shapely.union_all(parts).area <= 1e-9
        # every part has its neighbours beside it, as at both ends, and none is left behind
        assert all(0 < one.distance(other) < 6 for one, other in pairwise(parts))
    crowded = [shapely.Polygon(ring) for ring in separate.at(0.5)]
    assert shapely.union_all(crowded).area < 0.75 * sum(part.area for part in crowded)


@pytest.mark.parametrize("method", ["star-skeleton", "stitched"])
def test_figure_10_carries_pictures_of_both_shapes(method):
    project = example("figure-10-dog")
    source, target = (picture_of(Path("figure-10-dog.json"), project, k) for k in (0, 1))
    made = blend(pair_of(10), method=method)
    morph = ImageMorph(made, source, target)
    view = 0.0, 0.0, 256.0, 256.0
    for t, picture in ((0, source), (1, target)):
        deep = shapely.Polygon(made.at(t)).buffer(-1)
        x, y = np.meshgrid(np.arange(256) + 0.5, 255.5 - np.arange(256))
        inside = shapely.contains_xy(deep, x, y)
        off = np.abs(morph.at(t, 256, view)[inside].astype(int) - picture.pixels[inside])
        assert off.mean() <= 0.5
    between = morph.at(0.5, 256, view)
    assert (between[..., 3] > 0).sum() > 0.9 * shapely.Polygon(made.at(0.5)).area


@pytest.mark.parametrize("method", ["star-skeleton", "stitched", "rigid"])
def test_figure_11_crosses_itself_naturally(method):
    report = measured(11, method)
    assert report.natural
    assert report.area_deviation < 0.1
