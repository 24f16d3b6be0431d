import pytest

from starskel.crossings import crossing_edges
from starskel.errors import InvalidFile
from starskel.files.multi_pairs import MultiPair
from starskel.files.projects.examples import example, example_names


def test_the_first_example_is_the_arm():
    assert example_names()[0] == "arm"


@pytest.mark.parametrize("name", example_names())
def test_an_example_is_a_whole_project(name):
    project = example(name)
    assert project.name
    for step in range(len(project.steps)):
        pair = project.pair(step)
        assert isinstance(pair, MultiPair) or len(pair.marks) >= 2
    assert project.methods


def test_the_arm_crosses_itself_when_its_vertices_move_on_straight_lines():
    arm = example("arm").pair(0)
    assert len(arm.source) == len(arm.target)  # drawn with the same vertices, so that row i is vertex i
    assert len(crossing_edges((arm.source.vertices + arm.target.vertices) / 2))


def test_an_unknown_example_is_answered_with_the_known_ones():
    with pytest.raises(InvalidFile, match='no example "leg"; choose one of arm, '):
        example("leg")
