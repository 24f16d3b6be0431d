"""The verbs of the command, called in this process."""

import json
import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import starskel
from starskel.blending import METHODS
from starskel.cli import main
from starskel.files.projects.examples import resource_folder
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import read_project, write_project
from tests.starskel.export.rendering import needs_ghostscript, rendered_postscript

SHAPES = Path(__file__).parents[2] / "shapes"
LETTERS = str(SHAPES / "letters.json")
HEART, STAR = (str(SHAPES.parent / "files" / "icons" / f"lucide-{name}.svg") for name in ("heart", "star"))
COAST = str(SHAPES / "coasts.json")
ARM = str(resource_folder() / "examples" / "arm.json")
PAIR = ("--id", "letter-T-Y")


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def texts(path):
    return [element.text for element in ET.parse(path).iter("{http://www.w3.org/2000/svg}text")]


def ids(path):
    return [element.get("id") for element in ET.parse(path).iter("{http://www.w3.org/2000/svg}g")]


def refused(capsys, *words):
    """The message of a command that fails with status 2."""
    try:
        status = main(words)
    except SystemExit as leaving:  # argparse's way
        status = leaving.code
    assert status == 2
    out, message = capsys.readouterr()
    assert out == ""
    return message


def test_frames_in_json_are_those_of_the_library(shape_pairs):
    assert main(["render", LETTERS, *PAIR, "--method", "edge-angle", "--frames", "5", "-o", "out.json"]) == 0
    document = json.loads(Path("out.json").read_text())
    pair = shape_pairs["letter-T-Y"]
    blend = starskel.blend(pair.source, pair.target, pair.marks, "edge-angle")
    assert document["format"] == "starskel-frames/1"
    assert document["method"] == "edge-angle"
    assert document["times"] == [0, 0.25, 0.5, 0.75, 1]
    assert np.array_equal(document["frames"], blend.frames(document["times"]))
    for row, (i, j) in zip(document["marks"], pair.marks, strict=True):
        assert document["frames"][0][row] == pair.source.vertices[i].tolist()
        assert document["frames"][-1][row] == pytest.approx(pair.target.vertices[j].tolist())


def test_as_many_frames_as_asked_for_stand_in_the_row():
    main(["render", LETTERS, *PAIR, "--frames", "4", "-o", "out.svg"])
    assert ids("out.svg") == [f"frame-{number}" for number in range(4)]
    assert texts("out.svg") == ["t = 0", "t = 0.333", "t = 0.667", "t = 1"]


def test_frames_at_given_times_and_without_captions():
    main(["render", LETTERS, *PAIR, "--at", "0.25", "1", "--plain", "-o", "out.svg"])
    assert len(ids("out.svg")) == 2
    assert texts("out.svg") == []


def test_one_frame_is_drawn_large():
    main(["render", LETTERS, *PAIR, "--at", "0.5", "-o", "one.svg"])
    main(["render", LETTERS, *PAIR, "--at", "0.5", "0.6", "-o", "two.svg"])
    one, two = (float(ET.parse(name).getroot().get("height")[:-2]) for name in ("one.svg", "two.svg"))
    assert one > 2 * two


def test_postscript_has_a_page_for_each_frame():
    main(["render", LETTERS, *PAIR, "--frames", "7", "-o", "out.ps"])
    assert "%%Pages: 7\n" in Path("out.ps").read_text()


@needs_ghostscript
def test_eps_holds_all_frames_in_a_row(tmp_path):
    main(["render", LETTERS, *PAIR, "--frames", "3", "--plain", "-o", "out.eps"])
    (picture,) = rendered_postscript(tmp_path / "out.eps")
    filled = (picture < 250).any(axis=0)
    assert np.count_nonzero(np.diff(filled.astype(int)) == 1) == 3


def test_marks_pieces_and_skeleton_are_drawn_when_asked_for():
    words = ["render", LETTERS, "--id", "letter-K-X", "--method", "star-skeleton", "--plain"]
    main([*words, "-o", "plain.svg"])
    sizes = [Path("plain.svg").stat().st_size]
    for option in ("--marks", "--pieces", "--skeleton"):
        main([*words, option, "-o", "out.svg"])
        sizes.append(Path("out.svg").stat().st_size)
    assert min(sizes[1:]) > sizes[0]
    main([*words, "--marks", "-o", "out.svg"])
    assert texts("out.svg") == list("12345678") * 6


def test_a_sheet_has_a_row_for_each_method():
    assert main(["render", ARM, "--layout", "sheet", "--frames", "3", "-o", "out.svg"]) == 0
    assert set(ids("out.svg")) == {f"{method}-{number}" for method in METHODS for number in range(3)}
    assert {*METHODS, "An arm bends", "t = 0.5", "simple"} <= set(texts("out.svg"))
    assert any(re.fullmatch(r"crosses at t = 0\.\d+-0\.\d+", text) for text in texts("out.svg"))


def test_a_sheet_can_be_had_of_some_methods_and_in_every_format():
    for name in ("out.svg", "out.eps", "out.ps"):
        assert (
            main(
                [
                    "render",
                    ARM,
                    "--layout",
                    "sheet",
                    "--method",
                    "vertex",
                    "--method",
                    "edge-angle",
                    "-o",
                    name,
                ]
            )
            == 0
        )
    assert [name for name in texts("out.svg") if name in METHODS] == ["vertex", "edge-angle"]


def test_the_only_pair_of_a_file_needs_no_name():
    assert main(["render", COAST, "--method", "vertex", "-o", "out.svg"]) == 0


def test_a_table_has_a_line_for_each_pair_and_method(capsys):
    assert main(["measure", LETTERS, "--frames", "11"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 1 + 4 * len(METHODS) + 1 + len(METHODS)
    assert lines[0].split() == ["pair", "method", "area", "length", "angle", "stretch", "rough", "verdict"]
    assert max(map(len, lines)) <= 100
    assert lines[-1].startswith("vertex")
    assert re.search(r" of 4 simple \(\d proven\), \d crossing naturally, median area drift", lines[-1])


def test_figures_in_json_are_those_of_the_library(capsys, shape_pairs):
    words = ["--id", "letter-C-S", "--id", "letter-T-Y", "--method", "vertex", "--frames", "41", "--json"]
    assert main(["measure", LETTERS, *words]) == 0
    document = json.loads(capsys.readouterr().out)
    assert (document["format"], document["frames"], document["failures"]) == ("starskel-figures/2", 41, [])
    assert [figures["id"] for figures in document["figures"]] == ["letter-C-S", "letter-T-Y"]
    for figures in document["figures"]:
        pair = shape_pairs[figures["id"]]
        report = starskel.measure(starskel.blend(pair.source, pair.target, pair.marks, "vertex"), frames=41)
        assert figures["simple"] == report.simple
        assert figures["crossing_times"] == list(report.crossing_times)
        for name in ("area_deviation", "length_deviation", "angle_deviation", "roughness", "proven"):
            assert figures[name] == getattr(report, name)
        assert [moment["frame"] for moment in figures["crossings"]] == list(report.crossing_frames)
        assert figures["inside"] is None
        for name in ("areas", "area_deviations", "perimeters", "length_deviations"):
            assert figures[name] == getattr(report, name).tolist()


def test_a_failing_pair_is_named_in_json_too(capsys):
    pairs = json.loads(Path(LETTERS).read_text())
    pairs["pairs"][1]["marks"] = [[0, 999]]
    Path("bad.json").write_text(json.dumps(pairs))
    assert main(["measure", "bad.json", "--method", "vertex", "--json"]) == 2
    out, err = capsys.readouterr()
    document = json.loads(out)
    assert len(document["figures"]) == 3
    (failure,) = document["failures"]
    assert failure["id"] == pairs["pairs"][1]["id"]
    assert "mark 0 names vertex 999 of the target" in failure["error"]
    assert failure["error"] in err


def test_equal_calls_write_equal_files():
    for name in ("a.svg", "b.svg"):
        main(["render", ARM, "--layout", "sheet", "--pieces", "--skeleton", "--marks", "-o", name])
    assert Path("a.svg").read_bytes() == Path("b.svg").read_bytes()


def write_film(*missing):
    """Write a project of three steps, without these shapes."""
    shapes = [[[0, 0], [9, 0], [9, 9 - k], [0, 9]] for k in range(4)]
    steps = [{"duration": 1.0, "marks": [[0, 0]] if not {k, k + 1} & {*missing} else []} for k in range(3)]
    kept = [None if k in missing else rows for k, rows in enumerate(shapes)]
    document = {"format": "starskel-project", "version": 2, "name": "film", "shapes": kept, "steps": steps}
    Path("film.json").write_text(json.dumps({**document, "methods": []}))


def test_all_steps_of_a_project_are_rendered_or_one():
    write_film()
    main(["render", "film.json", "--method", "vertex", "--frames", "4", "-o", "out.json"])
    film = json.loads(Path("out.json").read_text())
    assert film["format"] == "starskel-frame-steps/1"
    assert [step["step"] for step in film["steps"]] == [1, 2, 3]
    assert [step["content"]["frames"][-1][2] for step in film["steps"]] == [[9, 9], [9, 8], [9, 6]]
    main(["render", "film.json", "--step", "3", "--method", "vertex", "--at", "0", "-o", "out.json"])
    third = json.loads(Path("out.json").read_text())
    assert third["frames"][0][2] == [9, 7]
    words = ["render", "film.json", "--layout", "sheet", "--method", "vertex", "--frames", "2"]
    main([*words, "--step", "2", "-o", "out.svg"])
    assert "film B-C" in texts("out.svg")
    main([*words, "-o", "out.svg"])
    assert {"film", "vertex, A-B", "vertex, C-D"} <= set(texts("out.svg"))


def test_a_project_is_blended_with_its_root_and_turns():
    pair = read_project(Path(ARM)).pair(0)
    decomposition = starskel.decompose(starskel.match(pair.source, pair.target, pair.marks))
    usual = starskel.blend(decomposition.pair, "star-skeleton")
    piece = next(k for k in range(len(decomposition.pieces)) if k != usual.skeleton.root)
    root = tuple(decomposition.source_origins[piece].tolist())
    write_project(Path("p.json"), Project.of(replace(pair, id="p", root=root, turns=1)))
    main(["render", "p.json", "--method", "star-skeleton", "--at", "0.5", "-o", "out.json"])
    frame = json.loads(Path("out.json").read_text())["frames"][0]
    steered = starskel.blend(decomposition.pair, "star-skeleton", root=piece, turns=1)
    assert np.array_equal(frame, steered.at(0.5))
    assert not np.allclose(frame, usual.at(0.5), atol=1.0)


def test_all_steps_of_a_project_are_measured_or_one(capsys):
    write_film()
    assert main(["measure", "film.json", "--method", "vertex"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line[:8] for line in lines[1:4]] == ["film A-B", "film B-C", "film C-D"]
    assert main(["measure", "film.json", "--step", "2", "--method", "vertex"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line[:8] for line in lines[1:2]] == ["film B-C"]


def test_steps_without_their_shapes_are_named_and_the_others_measured(capsys):
    write_film(3)
    assert main(["measure", "film.json", "--method", "vertex"]) == 2
    out, err = capsys.readouterr()
    assert "film B-C" in out
    assert "film.json: film has no shape D yet" in err
    write_film(1, 2)
    assert "film has no shape B yet" in refused(capsys, "measure", "film.json")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["render", LETTERS, "--step", "1", "-o", "a.svg"], "is no project and has no steps; choose a pair"),
        (["render", ARM, "--step", "2", "-o", "a.svg"], "arm.json has no step 2; give a step from 1 to 1"),
        (["measure", ARM, "--step", "0"], "'0' is no number of a step"),
        (["render", LETTERS, "-o", "a.svg"], "holds 4 pairs; choose one: --id letter-C-S | letter-E-F"),
        (
            ["render", LETTERS, "--id", "letter-TY", "-o", "a.svg"],
            'no pair "letter-TY"; choose one of letter-T-Y',
        ),
        (["measure", LETTERS, "--id", "letter-TY"], 'no pair "letter-TY"; choose one of letter-T-Y'),
        (["render", HEART, "-o", "a.svg"], "starskel convert " + HEART + " OTHER -o drawing.json"),
        (["measure", HEART], "holds shapes, but does not say which becomes which"),
        (["render", COAST, "-o", "a.bmp"], 'a.bmp ends in ".bmp"; end it in .svg or .eps or .ps'),
        (["render", COAST, "--layout", "sheet", "-o", "a"], 'a ends in ""; end it in .svg or .eps'),
        (
            ["render", COAST, "--method", "vertex", "-o", "no/a.svg"],
            "no/a.svg cannot be written: No such file",
        ),
        (["render", COAST, "--method", "magic", "-o", "a.svg"], "invalid choice: 'magic'"),
        (["render", COAST, "--frames", "1", "-o", "a.svg"], "'1' is no number of frames"),
        (["render", COAST, "--frames", "many", "-o", "a.svg"], "'many' is no number of frames"),
        (["render", COAST, "--frames", "10001", "-o", "a.svg"], "give a whole number from 2 to 10000"),
        (
            ["render", COAST, "--duration", "1e9", "-o", "a.svg"],
            "'1e9' is no number of seconds: give one from 0.01",
        ),
        (["render", COAST, "--rate", "0", "-o", "a.gif"], "'0' is no number of pictures a second"),
        (
            ["render", COAST, "--tolerance", "0", "-o", "a.svg"],
            "'0' is no tolerance: give one from 1e-06 to 1",
        ),
        (["render", COAST, "--gap", "wide", "-o", "a.svg"], "'wide' is no distance in points"),
        (["batch", "tests", "--processes", "0", "-o", "r"], "'0' is no number of processes: give 1 or more"),
        (
            ["convert", HEART, STAR, "--text", "A", "-o", "a.json"],
            'no font is there to set "A"; leave out --text',
        ),
        (["info", HEART, "--text", "A"], 'no font is there to set "A"'),
        (["render", COAST, "--at", "1.5", "-o", "a.svg"], "'1.5' is no number from 0 to 1"),
        (["render", COAST, "--at", "nan", "-o", "a.svg"], "'nan' is no number from 0 to 1"),
        (["render", COAST], "the following arguments are required: -o"),
        ([], "the following arguments are required: VERB"),
    ],
)
def test_a_fault_is_told_with_status_2_and_nothing_is_written(capsys, words, message):
    assert message in refused(capsys, *words)
    assert list(Path().iterdir()) == []


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "is damaged: Input data was truncated"),
        (
            '{"format": "recipes/2"}',
            'has the format "recipes/2"; give a file of the format "polygon-pairs/1" or',
        ),
        ("{}", "does not name its format"),
        (
            '{"format": "starskel-project", "version": 1, "name": "", "source": [[0, 0], [1, 0], [0, 1]],'
            ' "target": null, "marks": [], "methods": []}',
            "bad.json: bad has no shape B yet; draw it",
        ),
    ],
)
def test_a_file_that_cannot_be_blended_is_named(capsys, content, message):
    Path("bad.json").write_text(content)
    for words in (
        ["render", "bad.json", "-o", "a.svg"],
        ["render", "bad.json", "--layout", "sheet", "-o", "a.svg"],
        ["measure", "bad.json"],
    ):
        assert message in refused(capsys, *words)
    assert [path.name for path in Path().iterdir()] == ["bad.json"]


def test_an_interruption_ends_with_status_130(monkeypatch):
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("starskel.command.variants.blend", interrupted)
    assert main(["render", COAST, "-o", "a.svg"]) == 130
    assert list(Path().iterdir()) == []


@pytest.mark.parametrize("verb", ["render", "measure"])
def test_a_method_given_twice_is_refused(
    verb: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = ("-o", str(tmp_path / "out.svg")) if verb == "render" else ()
    with pytest.raises(SystemExit) as ended:
        main([verb, ARM, "--method", "vertex", "--method", "vertex", *out])
    assert ended.value.code == 2
    assert "given twice" in capsys.readouterr().err
