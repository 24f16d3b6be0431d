"""Shapes from one kind of file into another by the command, and words completed."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import shapely

from starskel.cli import main
from starskel.files.projects.project_file import read_project
from starskel.reading.readers import read_shapes

ICONS = Path(__file__).parents[2] / "files" / "icons"
CLUB, BUG = str(ICONS / "bootstrap-suit-club-fill.svg"), str(ICONS / "bootstrap-bug-fill.svg")
GEAR = str(ICONS / "bootstrap-gear-fill.svg")


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_two_drawings_become_a_project_that_can_be_rendered():
    assert main(["convert", CLUB, BUG, "-o", "both.json"]) == 0
    shapes = [key.shape for key in read_project(Path("both.json")).shapes]
    assert shapes == [read_shapes(Path(path)).shapes[0].shape for path in (CLUB, BUG)]
    assert main(["render", "both.json", "--method", "vertex", "-o", "row.svg"]) == 0


def test_a_shape_with_a_hole_becomes_a_key_shape_of_parts():
    assert main(["convert", GEAR, CLUB, GEAR, "--shape", "path 1", "-o", "two.json"]) == 2
    assert main(["convert", GEAR, CLUB, "-o", "two.json"]) == 0
    assert [len(key) for key in read_project(Path("two.json")).shapes] == [2, 1]
    assert main(["render", "two.json", "--method", "vertex", "-o", "row.svg"]) == 0


@pytest.mark.parametrize("name", ["out.geojson", "out.wkt", "out.svg"])
def test_shapes_are_read_back_as_they_were_written(name):
    assert main(["convert", GEAR, CLUB, "-o", name]) == 0
    before = [read_shapes(Path(path)).shapes[0].shape.to_shapely() for path in (GEAR, CLUB)]
    after = [found.shape.to_shapely() for found in read_shapes(Path(name)).shapes]
    if name == "out.svg":  # there the drawing stands in the corner, in points
        scale = 96 / 72
        low = np.min([area.bounds[:2] for area in before], axis=0)
        height = np.max([area.bounds[3] for area in before]) - low[1]
        before = [shapely.transform(area, lambda p: ((p - low) - [0, height]) * scale) for area in before]
    assert len(after) == 2
    for one, other in zip(before, after, strict=True):
        assert one.symmetric_difference(other).area < 1e-5 * one.area
        assert shapely.get_num_coordinates(one) == shapely.get_num_coordinates(other)


def test_what_was_converted_is_told_to_machines(capsys):
    assert main(["convert", BUG, "--shape", "path 2", "-o", "out.wkt", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["files"] == ["out.wkt"]
    assert told["shapes"] == ["path 2"]
    assert any("path 2: it crossed or touched itself" in sentence for sentence in told["mended"])


def test_shapes_are_chosen_by_name_and_what_was_mended_is_told(capsys):
    assert main(["convert", BUG, "--shape", "path 2", "-o", "out.wkt"]) == 0
    assert "bootstrap-bug-fill.svg: path 2: it crossed or touched itself" in capsys.readouterr().err
    assert len(read_shapes(Path("out.wkt")).shapes) == 1


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["convert", CLUB, "-o", "a.json"], "needs a source and a target"),
        (
            ["convert", CLUB, "--shape", "leaf", "-o", "a.wkt"],
            'there is no shape "leaf"; choose one of path 1',
        ),
        (["convert", CLUB, "-o", "a.dxf"], "end it in .json or .svg"),
        (["convert", "a.dxf", "-o", "a.svg"], "give a file that ends in .json, .svg"),
        (["info", "gone.svg"], "gone.svg cannot be read"),
    ],
)
def test_what_does_not_go_is_told(capsys, words, message):
    assert main(words) == 2
    assert message in capsys.readouterr().err
    assert list(Path().iterdir()) == []


def test_info_names_shapes_and_goes_on_after_a_file_that_fails(capsys):
    assert main(["info", GEAR, "gone.svg", BUG]) == 2
    out, err = capsys.readouterr()
    assert "279 vertices" not in err
    assert "1 hole," in out
    assert "mended: it crossed" in out
    assert "gone.svg" in err


def test_info_in_json_says_the_same(capsys):
    assert main(["info", "--json", GEAR, "gone.svg"]) == 2
    document = json.loads(capsys.readouterr().out)
    shape = read_shapes(Path(GEAR)).shapes[0].shape
    ((held,),) = [file["shapes"] for file in document["files"]]
    assert (held["parts"], held["holes"], held["vertices"]) == (1, 1, sum(map(len, shape.rings)))
    assert held["box"] == pytest.approx(list(shape.to_shapely().bounds))
    assert held["area"] == pytest.approx(shape.to_shapely().area)
    assert document["failures"][0]["path"] == "gone.svg"


def test_a_shell_completes_verbs_and_words(tmp_path):
    """As bash asks, over the file descriptor that the answer goes to."""
    line = "starskel render --lay"
    asked = {"_ARGCOMPLETE": "1", "COMP_LINE": line, "COMP_POINT": str(len(line)), "IFS": "\n"}
    code = "import os, sys; sys.argv = ['starskel']; os.dup2(1, 8); from starskel.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", code], env={**os.environ, **asked}, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "--layout"
    assert main(["completion", "bash"]) == 0
