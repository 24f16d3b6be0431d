import json
from pathlib import Path

import pytest

from starskel.easing import Easing
from starskel.errors import InvalidFile
from starskel.files.project import Project, letter, read_project, write_project
from starskel.files.step import Step
from starskel.polygon import Polygon

TRIANGLE = Polygon([[0, 0], [1, 0], [0.1, 1 / 3]])
SQUARE = Polygon([[0, 0], [4, 0], [4, 4], [0, 4]])
WHOLE = Project(
    "Dreieck → Quadrat", (TRIANGLE, SQUARE), (Step(((0, 1), (2, 3))),), methods=("stitched", "vertex")
)
LONG = Project("long", (TRIANGLE, SQUARE, None, SQUARE), (Step(((0, 1),), 0.5), Step(), Step((), 1.25)))
STEERED = Project(
    "steered", (TRIANGLE, SQUARE), (Step(((0, 1),), 2.0, Easing((0.4, 0.0), (0.6, 1.0)), (0.3, 0.2), -1),)
)
FILES = Path(__file__).parents[2] / "files"
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
        Project(""),
        Project("half", (TRIANGLE, None)),
        Project("other half", (None, TRIANGLE)),
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
    write_project(path, Project(WHOLE.name, (moved, SQUARE), WHOLE.steps, WHOLE.methods))
    after = path.read_text().splitlines()
    assert len(before) == len(after)
    assert sum(a != b for a, b in zip(before, after, strict=True)) == 1


def test_a_file_of_version_1_is_a_project_of_one_step(path):
    old, rows = read_project(OLD), json.loads(OLD.read_text())
    assert old.name == rows["name"]
    assert [shape.vertices.tolist() for shape in old.shapes] == [rows["source"], rows["target"]]
    assert old.steps == (Step(tuple(map(tuple, rows["marks"])), 1.0),)
    assert list(old.methods) == rows["methods"]
    write_project(path, old)
    assert json.loads(path.read_text())["version"] == 3
    assert read_project(path) == old


def test_a_file_of_version_2_has_even_unsteered_steps(path):
    old = read_project(FILES / "project-version-2.json")
    rows = json.loads((FILES / "project-version-2.json").read_text())
    assert [[tuple(mark) for mark in step["marks"]] for step in rows["steps"]] == [
        list(step.marks) for step in old.steps
    ]
    assert old.steps == tuple(
        Step(step.marks, row["duration"]) for step, row in zip(old.steps, rows["steps"], strict=True)
    )
    assert (old.description, old.shapes[2]) == (rows["description"], None)
    assert old.pictures[1].size == (2.0, 1.0)
    write_project(path, old)
    assert read_project(path) == old


def test_marks_of_every_step_follow_shapes_given_clockwise(path):
    write_project(path, Project("", (SQUARE,) * 3, (Step(((1, 2),)), Step(((2, 3),)))))
    document = json.loads(path.read_text())
    document["shapes"][1] = [[0, 0], [0, 4], [4, 4], [4, 0]]
    path.write_text(json.dumps(document))
    project = read_project(path)
    assert project.shapes == (SQUARE,) * 3
    assert [step.marks for step in project.steps] == [((1, 2),), ((2, 3),)]
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


def step(**change):
    easing = [[0, 0], [1, 1]]
    return {"duration": 1.0, "easing": easing, "root": None, "turns": 0, "marks": [], **change}


TRIANGLES = [[[0, 0], [4, 0], [0, 4]]] * 2


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"format": "polygon-pairs/1"}, 'has the format "polygon-pairs/1"; give .* "starskel-project"'),
        ({"version": 4}, "of version 4; this program knows versions up to 3; open it with a newer starskel"),
        ({"version": 0}, "of version 0"),
        ({"version": 1}, "missing required field `source`"),
        ({"shapes": [[[0, 0], [1, 1]], None]}, "drawing.json: shape A: a polygon of 2 points"),
        ({"shapes": [None, [[0, 0], [4, 4], [4, 0], [0, 4]]]}, "drawing.json: shape B: edges 0-1 and 2-3"),
        ({"shapes": [None, TRIANGLES[0]]}, "drawing.json: step A-B has marks, but not both shapes"),
        ({"shapes": [None]}, "has 1 shapes and 1 steps; give two shapes at least"),
        ({"steps": []}, "has 2 shapes and 0 steps"),
        ({"steps": [step(duration=0)]}, r"`float` > 0.0 - at `\$.steps\[0\].duration`"),
        ({"steps": [step(easing=[[0, 0], [1.5, 1]])]}, r"`float` <= 1.0 - at `\$.steps\[0\].easing"),
        ({"steps": [step(turns=0.5)]}, r"Expected `int`, got `float` - at `\$.steps\[0\].turns`"),
        ({"steps": [step(root=[1])]}, r"length 2 - at `\$.steps\[0\].root`"),
        ({"steps": [step(marks=[[0, 4]])]}, "step A-B: mark 0 names vertex 4 of the target"),
        ({"steps": [step(marks=[[0]])]}, r"length 2 - at `\$.steps\[0\].marks\[0\]`"),
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
