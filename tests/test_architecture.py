"""Rules of the layout that import-linter cannot express."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
MODULES = sorted(
    path.relative_to(ROOT) for name in ("starskel", "app", "tests") for path in (ROOT / name).rglob("*.py")
)
DRAWING = ("PySide6.QtGui", "PySide6.QtWidgets")
VAGUE = {"util", "utils", "helper", "helpers", "common", "misc", "manager"}
LONGEST = 400


def imported(path):
    """The names of the modules that a file imports, anywhere in it."""
    for node in ast.walk(ast.parse((ROOT / path).read_bytes())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def draws(path):
    return any(name.startswith(DRAWING) for name in imported(path))


def test_only_the_view_draws():
    """A rule about submodules of an external package: import-linter knows only whole ones."""
    drawing = {path for path in MODULES if path.parts[0] != "tests" and draws(path)}
    allowed = {path for path in drawing if path.parts[:2] in (("app", "view"), ("app", "__main__.py"))}
    assert drawing == allowed
    assert drawing, "the check finds nothing at all"


@pytest.mark.parametrize("path", MODULES, ids=str)
def test_a_module_has_a_telling_name_and_a_length_to_be_read(path):
    assert path.stem not in VAGUE
    assert len((ROOT / path).read_text().splitlines()) <= LONGEST


def test_the_command_starts_without_the_libraries_that_take_long():
    program = "import sys, starskel.cli; print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    ).stdout.split()
    assert "starskel.cli" in loaded
    assert not {"numpy", "shapely", "msgspec", "PySide6"} & set(loaded)


def test_the_library_and_the_command_never_load_qt():
    """Not even by way of another package."""
    modules = [".".join(path.with_suffix("").parts) for path in MODULES if path.parts[0] == "starskel"]
    program = f"import sys\nfor name in {modules}: __import__(name)\nprint(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    ).stdout.split()
    assert "starskel.blending" in loaded
    assert not [name for name in loaded if name.startswith("PySide6")]
