"""The example projects that come with the program."""

import re
from pathlib import Path

from starskel.errors import InvalidFile
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import read_project

_PACKAGE = Path(__file__).resolve().parents[2]


def resource_folder() -> Path:
    """Give the folder of everything that comes with the program but is not code.

    An installed package has it inside; a checkout has it beside the package.
    """
    inside = _PACKAGE / "resources"
    return inside if inside.is_dir() else _PACKAGE.parent / "resources"


def example_names() -> tuple[str, ...]:
    """Give the names of the examples: what a first start shows comes first, the paper's figures last."""
    names = [path.stem for path in (resource_folder() / "examples").glob("*.json")]
    return tuple(sorted(names, key=_rank))


def figure_number(name: str) -> int | None:
    """Give the number of the paper's figure that an example shows, or None."""
    found = re.match(r"figure-(\d+)-", name)
    return int(found[1]) if found else None


def example(name: str) -> Project:
    """Give an example project.

    Raises
    ------
    InvalidFile
        If there is none of that name.
    """
    if name not in example_names():
        raise InvalidFile(f'there is no example "{name}"', "choose one of " + ", ".join(example_names()))
    return read_project(resource_folder() / "examples" / f"{name}.json")


def _rank(name: str) -> tuple[int, str]:
    return figure_number(name) or 0, name
