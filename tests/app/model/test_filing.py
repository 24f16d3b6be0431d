from app.model.filing import document_of, project_of
from starskel.files.examples import example, example_names


def test_a_project_comes_back_from_its_document_as_it_was():
    described = 0
    for name in example_names():
        project = example(name)
        back = project_of(document_of(project, ()), "unnamed")
        assert (back.name, back.description) == (project.name, project.description)
        assert (back.methods, back.steps) == (project.methods, project.steps)
        assert back.shapes == project.shapes
        described += project.description != ""
    assert described
