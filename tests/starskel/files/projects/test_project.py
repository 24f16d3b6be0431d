import json
from dataclasses import replace
from pathlib import Path

import pytest

from starskel.easing import Easing
from starskel.errors import InvalidFile
from starskel.files.projects.key_shape import KeyShape, Part
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project, letter
from starskel.files.projects.project_file import read_project, write_project
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon

TRIANGLE = Polygon([[0, 0], [1, 0], [0.1, 1 / 3]])
SQUARE = Polygon([[0, 0], [4, 0], [4, 4], [0, 4]])
TRIANGULAR, SQUARED, EMPTY = KeyShape.of(TRIANGLE), KeyShape.of(SQUARE), KeyShape()
WHOLE = Project(
    "Dreieck → Quadrat", (TRIANGULAR, SQUARED), (Step.of(((0, 1), (2, 3))),), methods=("stitched", "vertex")
)
LONG = Project(
    "long",
    (TRIANGULAR, SQUARED, EMPTY, SQUARED),
    (
        replace(Step.of(((0, 1),)), duration=0.5),
        Step((Link(0, None),)),
        Step((Link(None, 0),), duration=1.25),
    ),
)
STEERED = Project(
    "steered",
    (TRIANGULAR, SQUARED),
    (Step((Link(0, 0, ((0, 1),), root=(0.3, 0.2)),), 2.0, Easing((0.4, 0.0), (0.6, 1.0)), -1),),
)
EYE = Polygon([[1, 1], [2, 1], [2, 2], [1, 2]])
PARTS = Project(
    "face",
    (
        KeyShape((Part(SQUARE, "face", "#ffcc00"), Part(EYE, "eye", "", False))),
        KeyShape((Part(SQUARE), Part(TRIANGLE))),
    ),
    (Step((Link(0, 0, ((1, 1),)), Link(1, None, place=(1.5, 0.5)), Link(None, 1)), joined=False),),
)
TURNED = Project(
    "turned",
    (KeyShape((Part(SQUARE),), Picture(b"none", (2, 2), (4, 2), rotation=0.25, cropped=True)), SQUARED),
    (Step((Link(0, 0),)),),
)
FILES = Path(__file__).parents[3] / "files"
OLD = FILES / "project-version-1.json"


@pytest.fixture
def path(tmp_path):
    return tmp_path / "drawing.json"


@pytest.mark.parametrize(
    "project",
    [
        WHOLE,
        LONG,
        STEERED,
        PARTS,
        TURNED,
        Project(""),
        Project("half", (TRIANGULAR, EMPTY), (Step((Link(0, None),)),)),
        Project("other half", (EMPTY, TRIANGULAR), (Step((Link(None, 0),)),)),
    ],
    ids=lambda project: project.name or "empty",
)
def test_a_project_comes_back_as_it_was_written(path, project):
    write_project(path, project)
    assert read_project(path) == project


def test_an_equal_project_is_an_equal_file(path, tmp_path):
    write_project(path, WHOLE)
    write_project(tmp_path / "again.json", read_project(path))
    assert path.read_bytes() == (tmp_path / "again.json").read_bytes()


def test_a_moved_vertex_changes_one_line(path):
    write_project(path, WHOLE)
    before = path.read_text().splitlines()
    moved = Polygon([[0, 0], [1, 0], [0.2, 1 / 3]])
    write_project(path, Project(WHOLE.name, (KeyShape.of(moved), SQUARED), WHOLE.steps, WHOLE.methods))
    after = path.read_text().splitlines()
    assert len(before) == len(after)
    assert sum(a != b for a, b in zip(before, after, strict=True)) == 1


def test_a_file_of_version_1_is_a_project_of_one_step(path):
    old, rows = read_project(OLD), json.loads(OLD.read_text())
    assert old.name == rows["name"]
    assert [shape.rings[0].vertices.tolist() for shape in old.shapes] == [rows["source"], rows["target"]]
    assert old.steps == (Step.of(tuple(map(tuple, rows["marks"]))),)
    assert list(old.methods) == rows["methods"]
    write_project(path, old)
    assert json.loads(path.read_text())["version"] == 4
    assert read_project(path) == old


def test_a_file_of_version_2_has_even_unsteered_steps(path):
    old = read_project(FILES / "project-version-2.json")
    rows = json.loads((FILES / "project-version-2.json").read_text())
    first, second = old.steps
    marks = tuple(map(tuple, rows["steps"][0]["marks"]))
    assert first == replace(Step.of(marks), duration=rows["steps"][0]["duration"])
    assert second == Step((Link(0, None),), duration=rows["steps"][1]["duration"])
    assert (old.description, old.shapes[2]) == (rows["description"], EMPTY)
    assert old.shapes[1].picture.size == (2.0, 1.0)
    write_project(path, old)
    assert read_project(path) == old


def test_version_3_has_upright_pictures_and_one_root_for_each_step(path):
    for project in (TURNED, STEERED):
        write_project(path, project)
        document = json.loads(path.read_text())
        document["version"] = 3
        for shape in document["shapes"]:
            for name in ("rotation", "cropped") if shape["picture"] else ():
                del shape["picture"][name]
        for step in document["steps"]:
            step["root"] = step["links"][0].pop("root")
        path.write_text(json.dumps(document))
        read = read_project(path)
        assert read.steps == project.steps
        if picture := project.shapes[0].picture:
            assert read.shapes[0].picture == replace(picture, rotation=0.0, cropped=False)


def test_marks_of_every_step_follow_shapes_given_clockwise(path):
    write_project(path, Project("", (SQUARED,) * 3, (Step.of(((1, 2),)), Step.of(((2, 3),)))))
    document = json.loads(path.read_text())
    document["shapes"][1]["parts"][0]["ring"] = [[0, 0], [0, 4], [4, 4], [4, 0]]
    path.write_text(json.dumps(document))
    project = read_project(path)
    assert project.shapes == (SQUARED,) * 3
    assert [step.links[0].marks for step in project.steps] == [((1, 2),), ((2, 3),)]
    assert project.pair(1).marks == ((2, 3),)


def test_steps_are_named_by_the_letters_of_their_shapes():
    assert LONG.pair(0).id == "long A-B"
    assert WHOLE.pair(0).id == WHOLE.name
    with pytest.raises(InvalidFile, match="long has no shape C yet"):
        LONG.pair(1)
    assert [letter(shape) for shape in (0, 25, 26, 27, 702)] == ["A", "Z", "AA", "AB", "AAA"]


def changed(path, **change):
    write_project(path, WHOLE)
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    return path


def link(**change):
    return {"source": 0, "target": 0, "place": None, "root": None, "marks": [], **change}


def step(**change):
    steered = {"easing": [[0, 0], [1, 1]], "turns": 0, "joined": True}
    return {"duration": 1.0, **steered, "links": [link()], **change}


def shape(*rings, **change):
    look = {"name": "", "colour": "", "visible": True, **change}
    return {"picture": None, "parts": [{**look, "ring": ring} for ring in rings]}


ROWS = [[0, 0], [4, 0], [0, 4]]
NESTED = (
    [[0, 0], [9, 0], [9, 9], [0, 9]],
    [[1, 1], [5, 1], [5, 5], [1, 5]],
    [[2, 2], [7, 2], [7, 7], [2, 7]],
)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"format": "polygon-pairs/1"}, 'has the format "polygon-pairs/1"; give .* "starskel-project"'),
        ({"version": 5}, "of version 5; this program knows versions up to 4; open it with a newer starskel"),
        ({"version": 0}, "of version 0"),
        ({"version": 1}, "missing required field `source`"),
        ({"shapes": [shape([[0, 0], [1, 1]]), shape()]}, "drawing.json: shape A: a polygon of 2 points"),
        (
            {"shapes": [shape(), shape(ROWS, [[0, 0], [4, 4], [4, 0], [0, 4]])]},
            "drawing.json: shape B, part 1: edges 0-1 and 2-3",
        ),
        ({"shapes": [shape(*NESTED), shape()]}, "shape A: rings 1 and 2, holes of one part, meet"),
        ({"shapes": [shape(ROWS, colour="red"), shape()]}, r"`\$.shapes\[0\].parts\[0\].colour`"),
        ({"shapes": [shape(), shape(ROWS)]}, "drawing.json: step A-B: the links name parts that are not"),
        ({"shapes": [shape()]}, "has 1 shapes and 1 steps; give two shapes at least"),
        ({"steps": []}, "has 2 shapes and 0 steps"),
        ({"steps": [step(duration=0)]}, r"`float` > 0.0 - at `\$.steps\[0\].duration`"),
        ({"steps": [step(easing=[[0, 0], [1.5, 1]])]}, r"`float` <= 1.0 - at `\$.steps\[0\].easing"),
        ({"steps": [step(turns=0.5)]}, r"Expected `int`, got `float` - at `\$.steps\[0\].turns`"),
        ({"steps": [step(links=[link(root=[1])])]}, r"length 2 - at `\$.steps\[0\].links\[0\].root`"),
        ({"steps": [step(links=[])]}, "step A-B: the links name parts that are not there, or leave some out"),
        ({"steps": [step(links=[link(source=1)])]}, "step A-B: the links name parts that are not there"),
        (
            {"steps": [step(links=[link(target=None, marks=[[0, 0]]), link(source=None)])]},
            "step A-B: there are marks, but not both shapes",
        ),
        ({"steps": [step(links=[link(marks=[[0, 4]])])]}, "step A-B: mark 0 names vertex 4 of the target"),
        (
            {"steps": [step(links=[link(marks=[[0]])])]},
            r"length 2 - at `\$.steps\[0\].links\[0\].marks\[0\]`",
        ),
        (
            {"methods": ["vertex", "magic"]},
            'the method "magic", .* open it with a newer starskel, or name one of',
        ),
        ({"methods": ["vertex", "stitched", "vertex"]}, 'the method "vertex" twice'),
        ({"methods": [1]}, r"got `int` - at `\$.methods\[0\]`"),
    ],
)
def test_a_fault_is_named_with_its_place(path, change, message):
    with pytest.raises(InvalidFile, match=message):
        read_project(changed(path, **change))


def test_any_json_that_is_no_project_is_an_invalid_file(path):
    for text in ("", "null", "[]", "3", '"format"', "{}", '{"format": "starskel-project"}', "[" * 100_000):
        path.write_text(text)
        with pytest.raises(InvalidFile):
            read_project(path)


def test_text_that_is_not_unicode_is_an_invalid_file(path):
    write_project(path, WHOLE)
    path.write_bytes(path.read_bytes().replace(b"Dreieck", b"Dr\xe4ieck"))
    with pytest.raises(InvalidFile, match="is damaged"):
        read_project(path)
