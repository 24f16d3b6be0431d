"""The example projects that come with the program."""

from pathlib import Path

from starskel.errors import InvalidFile
from starskel.files.project import Project, read_project

_PACKAGE = Path(__file__).resolve().parent.parent


def resource_folder() -> Path:
    """Give the folder of everything that comes with the program but is not code.

    An installed package has it inside; a checkout has it beside the package.
    """
    inside = _PACKAGE / "resources"
    return inside if inside.is_dir() else _PACKAGE.parent / "resources"


def example_names() -> tuple[str, ...]:
    """Give the names of the examples; the first is the one that a first start shows."""
    return tuple(sorted(path.stem for path in (resource_folder() / "examples").glob("*.json")))


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
