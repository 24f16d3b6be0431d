from app.model.filing import Filed, document_of, project_of
from starskel.files.projects.examples import example, example_names


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


def test_a_file_is_overtaken_when_another_program_has_changed_it_not_when_it_has_gone(tmp_path):
    path = tmp_path / "a.json"
    path.write_text("one")
    file = Filed.now(path)
    path.write_text("one")
    assert not file.overtaken
    path.write_text("two")
    assert file.overtaken
    path.unlink()
    assert not file.overtaken
    assert not Filed.now(path).overtaken
