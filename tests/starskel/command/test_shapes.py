"""The command on files of pairs of shapes."""

import json
import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import starskel
from starskel.cli import main
from starskel.files.multi_pairs import read_multi_pairs
from starskel.files.projects.examples import resource_folder
from starskel.shapes.structure import structures_at
from tests.starskel.export.rendering import needs_ghostscript, rendered_postscript
from tests.starskel.files.test_multi_pairs import MULTI

PATH = "{http://www.w3.org/2000/svg}path"
TEXT = "{http://www.w3.org/2000/svg}text"
FACE = ("--id", "m-smile-frown")


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_a_ring_and_its_hole_are_one_path_in_svg(tmp_path):
    assert main(["render", str(MULTI), *FACE, "--at", "0.5", "-o", "face.svg"]) == 0
    paths = ET.parse(tmp_path / "face.svg").findall(f".//{PATH}")
    rims = [path for path in paths if path.get("fill-rule") == "evenodd"]
    assert len(paths) == 4
    assert [len(re.findall("Z", path.get("d", ""))) for path in rims] == [2]


@needs_ghostscript
def test_the_inside_of_the_rim_stays_white_in_eps(tmp_path):
    assert main(["render", str(MULTI), *FACE, "--at", "0.5", "--plain", "-o", "face.eps"]) == 0
    (picture,) = rendered_postscript(tmp_path / "face.eps")
    height, width = np.shape(picture)[:2]
    assert (np.asarray(picture)[int(0.3 * height), width // 2] > 250).all()


@pytest.mark.parametrize("flag", [[], ["--separate"]])
def test_json_holds_the_rings_to_the_last_bit(tmp_path, flag):
    assert main(["render", str(MULTI), "--id", "m-i-j", *flag, "--frames", "3", "-o", "frames.json"]) == 0
    document = json.loads((tmp_path / "frames.json").read_text())
    pair = read_multi_pairs(MULTI).pair("m-i-j")
    blend = starskel.blend(pair.source, pair.target, pair.marks, pairing=pair.pairing, joined=not flag)
    assert document["format"] == "starskel-shape-frames/1"
    assert document["outer"] == [-1, -1]
    for written, ring in zip(document["frames"][1], blend.frames([0, 0.5, 1])[1], strict=True):
        np.testing.assert_array_equal(written, ring)


def test_a_sheet_compares_the_methods_and_parts_moved_separately(tmp_path):
    assert (
        main(
            [
                "render",
                str(MULTI),
                "--layout",
                "sheet",
                *FACE,
                "--frames",
                "3",
                "--skeleton",
                "-o",
                "sheet.svg",
            ]
        )
        == 0
    )
    texts = [e.text for e in ET.parse(tmp_path / "sheet.svg").iter(TEXT)]
    assert {"stitched", "edge-angle", "parts separately"} <= set(texts)
    assert "certified" in texts


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([], "holds 4 pairs; choose one: --id m-i-j"),
        ([*FACE, "--step", "1"], "has no steps"),
    ],
)
def test_what_does_not_go_is_said(capsys, words, message):
    assert main(["render", str(MULTI), *words, "-o", "out.svg"]) == 2
    assert message in capsys.readouterr().err


def test_star_pieces_skeletons_and_marks_of_all_parts_are_drawn(tmp_path):
    pair = read_multi_pairs(MULTI).pair("m-smile-frown")
    made = starskel.blend(pair.source, pair.target, pair.marks, "star-skeleton", pairing=pair.pairing)
    structures = list(structures_at(made, 0.5))
    pieces = [structure.blend.decomposition.pieces for structure in structures]
    words = [str(MULTI), *FACE, "--at", "0.5", "--method", "star-skeleton", "--no-signs", "--plain"]
    assert main(["render", *words, "--pieces", "--skeleton", "--marks", "-o", "all.svg"]) == 0
    assert main(["render", *words, "-o", "bare.svg"]) == 0
    drawn, bare = (ET.parse(tmp_path / name) for name in ("all.svg", "bare.svg"))
    paths = [path.get("d").count("L") for path in drawn.iter(PATH)]
    sides = [len(piece) - 1 for part in pieces for piece in part]
    arcs = sum(2 * (len(part) - 1) for part in pieces) + len(made.meta_skeleton.tree.order) - 1
    for side in sides:
        paths.remove(side)
    outlines = [path.get("d").count("L") for path in bare.iter(PATH)]
    assert sorted(paths) == sorted(outlines + [1] * arcs)
    assert [text.text for text in drawn.iter(TEXT)] == [str(k + 1) for k in range(sum(map(len, pair.marks)))]


def test_shapes_are_measured_ring_by_ring_and_parts_beside_each_other(capsys):
    assert main(["measure", str(MULTI), *FACE, "--method", "certified", "--frames", "5", "--json"]) == 0
    (figures,) = json.loads(capsys.readouterr().out)["figures"]
    pair = read_multi_pairs(MULTI).pair("m-smile-frown")
    blend = starskel.blend(pair.source, pair.target, pair.marks, "certified", pairing=pair.pairing)
    report = starskel.measure(blend, 5)
    assert figures["rings"] == len(pair.pairing)
    assert (figures["simple"], figures["proven"], figures["holes_inside"]) == (True, True, True)
    assert figures["how"] == report.how
    assert figures["areas"] == report.areas.tolist()
    for name in ("area_deviation", "length_deviation", "angle_deviation", "roughness", "overlap"):
        assert figures[name] == getattr(report, name)


def test_the_table_leaves_out_what_only_polygons_have(capsys):
    fish = str(resource_folder() / "examples" / "figure-9-fish.json")
    assert main(["measure", fish, "--method", "vertex", "--method", "star-skeleton", "--frames", "5"]) == 0
    straight, together = capsys.readouterr().out.splitlines()[1:3]
    assert re.search(r"vertex +\d+ % +\d+ % +0\.9° +- +0\.07 % +simple$", straight)
    assert re.search(r"star-skeleton +0\.0 % +0\.0 % +0\.0° +- +\d\.\d\d % +simple$", together)


def test_a_gallery_shows_shapes_beside_their_parts_moved_separately(tmp_path):
    fish = str(resource_folder() / "examples" / "figure-9-fish.json")
    words = ["--method", "star-skeleton", "--frames", "3", "-o", "out"]
    assert main(["gallery", fish, str(MULTI), *words]) == 0
    page = (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    assert page.count("<section") == 5
    assert "The fish turns round in six parts." in page
    assert "6 and 6 rings" in page
    texts = [e.text for e in ET.parse(tmp_path / "out" / "figure-9-a-fish-turns.svg").iter(TEXT)]
    assert {"star-skeleton", "parts separately"} <= set(texts)
    assert any(text.startswith("parts overlap by ") for text in texts)
