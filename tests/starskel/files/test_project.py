import json

import pytest

from starskel.errors import InvalidFile
from starskel.files.project import Project, read_project, write_project
from starskel.polygon import Polygon

TRIANGLE = Polygon([[0, 0], [1, 0], [0.1, 1 / 3]])
SQUARE = Polygon([[0, 0], [4, 0], [4, 4], [0, 4]])
WHOLE = Project("Dreieck → Quadrat", TRIANGLE, SQUARE, ((0, 1), (2, 3)), ("stitched", "vertex"))


@pytest.fixture
def path(tmp_path):
    return tmp_path / "drawing.json"


@pytest.mark.parametrize(
    "project",
    [WHOLE, Project(""), Project("half", source=TRIANGLE), Project("other half", target=TRIANGLE)],
    ids=["whole", "empty", "source", "target"],
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
    write_project(path, Project(WHOLE.name, moved, SQUARE, WHOLE.marks, WHOLE.methods))
    after = path.read_text().splitlines()
    assert len(before) == len(after)
    assert sum(a != b for a, b in zip(before, after, strict=True)) == 1


def changed(path, **change):
    write_project(path, WHOLE)
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    return path


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"format": "polygon-pairs/1"}, 'has the format "polygon-pairs/1"; give .* "starskel-project"'),
        ({"version": 2}, "of version 2; this program knows versions up to 1; open it with a newer starskel"),
        ({"version": 0}, "of version 0"),
        ({"source": [[0, 0], [1, 1]]}, "drawing.json: source: a polygon of 2 points"),
        ({"target": [[0, 0], [4, 4], [4, 0], [0, 4]]}, "drawing.json: target: edges 0-1 and 2-3 cross"),
        ({"source": None}, "has marks, but not both shapes"),
        ({"marks": [[0, 4]]}, "mark 0 names vertex 4 of the target"),
        ({"marks": [[0]]}, r"length 2 - at `\$.marks\[0\]`"),
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
