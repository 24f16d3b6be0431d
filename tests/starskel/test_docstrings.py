"""The descriptions of public names are complete, and their examples are true."""

import dataclasses
import doctest
import inspect
import pkgutil
import re
import sys
from functools import cached_property
from importlib import import_module

import pytest

import starskel

MODULES = ["starskel", *(found.name for found in pkgutil.walk_packages(starskel.__path__, "starskel."))]

SCRIPTED = {
    "starskel.export.film": ("Film", "Scene", "Track"),
    "starskel.export.settings": ("Settings", "even_times"),
    "starskel.export.write": ("write",),
    "starskel.reading.readers": ("read_shapes",),
}
"""What the manual's page on scripting names besides."""

PUBLIC = {
    **{name: getattr(starskel, name) for name in starskel.__all__ if name != "METHODS"},
    **{name: getattr(import_module(module), name) for module, names in SCRIPTED.items() for name in names},
}


def members(name, public):
    """The methods and properties that a class defines, by their full names."""
    if not inspect.isclass(public):
        return {}
    found = {key: member for key, member in inspect.getmembers_static(public) if not key.startswith("_")}
    functions = {
        key: getattr(member, "fget", None) or getattr(member, "func", None) or inspect.unwrap(member)
        for key, member in found.items()
        if inspect.isfunction(member) or isinstance(member, property | cached_property | classmethod)
    }
    own = {key: getattr(function, "__func__", function) for key, function in functions.items()}
    return {
        f"{name}.{key}": function for key, function in own.items() if function.__module__ == public.__module__
    }


MAKING = {True: "__post_init__", False: "__init__"}

DESCRIBED = PUBLIC | {
    key: function for name in starskel.__all__ for key, function in members(name, PUBLIC.get(name)).items()
}


@pytest.mark.parametrize("module", MODULES)
def test_examples_give_what_they_say(module):
    assert doctest.testmod(import_module(module)).failed == 0


def test_no_module_stands_before_one_of_python_when_its_folder_comes_first():
    """So `python -m doctest FILE` runs on every file."""
    names = {module.rpartition(".")[2] for module in MODULES}
    assert names & sys.stdlib_module_names == set()


def test_public_names_have_examples():
    assert [name for name, public in PUBLIC.items() if ">>> " not in inspect.getdoc(public)] == []


@pytest.mark.parametrize("name", DESCRIBED)
def test_descriptions_name_all_that_is_given_and_held(name):
    public = DESCRIBED[name]
    text = inspect.getdoc(public)
    assert re.match(r"[A-Z].*[.:]$", text.splitlines()[0])
    words = set(re.findall(r"\w+", text))
    given = set(inspect.signature(public).parameters) - {"self", "cls"}
    if inspect.isclass(public) and "Parameters\n" not in text:  # made by functions, not by users
        given = {key for key in inspect.get_annotations(public) if not key.startswith("_")} - {"of"}
    assert given <= words, given


@pytest.mark.parametrize("name", DESCRIBED)
def test_descriptions_name_the_errors_that_are_raised(name):
    public = DESCRIBED[name]
    code = (
        getattr(public, MAKING[dataclasses.is_dataclass(public)], None) if inspect.isclass(public) else public
    )
    raised = re.findall(r"raise (\w+)\(", inspect.getsource(code)) if inspect.isfunction(code) else []
    assert set(raised) <= set(re.findall(r"\w+", inspect.getdoc(public)))
