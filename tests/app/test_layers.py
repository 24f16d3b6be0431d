"""Which module may know which part of Qt."""

import ast
from pathlib import Path

import pytest

APP = Path(__file__).parents[2] / "app"
MODULES = sorted(APP.rglob("*.py"))


def qt_parts(module: Path) -> set[str]:
    """Give the parts of Qt that a module imports: QtCore, QtGui, ..."""
    parts: set[str] = set()
    for node in ast.walk(ast.parse(module.read_text())):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("PySide6"):
            parts.add((node.module or "").removeprefix("PySide6").lstrip("."))
        elif isinstance(node, ast.Import):
            parts |= {alias.name for alias in node.names if alias.name.startswith("PySide6")}
    return parts


@pytest.mark.parametrize("module", MODULES, ids=lambda path: str(path.relative_to(APP)))
def test_qt_stays_where_it_belongs(module: Path) -> None:
    place = module.relative_to(APP)
    if place.parts[0] == "view":
        return
    allowed = {"QtCore"} if place.parts[0] in ("session.py", "compute", "recovery") else set()
    assert qt_parts(module) <= allowed


def test_there_is_something_to_check() -> None:
    assert qt_parts(APP / "view" / "main_window.py") >= {"QtCore", "QtWidgets"}
    assert qt_parts(APP / "compute" / "computer.py") == {"QtCore"}
