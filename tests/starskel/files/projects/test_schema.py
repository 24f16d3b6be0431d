"""The schema of project files, held against projects by a program that knows nothing of this one."""

import json

import pytest
from jsonschema import Draft202012Validator

from starskel.files.documents import document_text
from starskel.files.projects.examples import example, example_names, resource_folder
from starskel.files.projects.project_file import project_schema, write_project

SCHEMA = resource_folder() / "project.schema.json"


def test_the_schema_that_is_given_out_is_that_of_this_version():
    assert SCHEMA.read_text("utf-8") == document_text(project_schema())
    Draft202012Validator.check_schema(project_schema())


@pytest.mark.parametrize("name", example_names())
def test_projects_are_as_the_schema_says(tmp_path, name):
    write_project(tmp_path / "a.json", example(name))
    document = json.loads((tmp_path / "a.json").read_text("utf-8"))
    validator = Draft202012Validator(project_schema())
    validator.validate(document)
    del document["steps"]
    assert not validator.is_valid(document)
