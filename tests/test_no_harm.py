"""What code that opens files of strangers must not do: run what they hold, or reach for the network."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FILES = sorted(path for package in ("starskel", "app") for path in (ROOT / package).rglob("*.py"))

CALLS = {
    *("eval", "exec", "compile", "__import__", "os.system", "os.popen", "np.load", "np.fromfile"),
    *("ElementTree.fromstring", "ElementTree.parse", "ElementTree.iterparse", "QDesktopServices.openUrl"),
}
MODULES = {
    *("pickle", "marshal", "shelve", "dill", "cloudpickle", "joblib", "yaml", "code", "runpy"),
    *(
        "socket",
        "ssl",
        "http",
        "urllib",
        "ftplib",
        "smtplib",
        "telnetlib",
        "xmlrpc",
        "socketserver",
        "asyncio",
    ),
    *("requests", "httpx", "aiohttp", "webbrowser", "subprocess", "pty", "ctypes", "distributed"),
    *("multiprocessing", "concurrent.futures.process", "xml.sax.expatreader", "xml.dom"),
    *("PySide6.QtNetwork", "PySide6.QtWebEngineCore", "PySide6.QtWebEngineWidgets", "PySide6.QtQml"),
}
_BATCH = "batches share their work among processes of the program's own"
ALLOWED = {
    ("app/surroundings.py", "ctypes"): "tells Windows the program's name, for the task bar",
    ("app/view/manual.py", "QDesktopServices.openUrl()"): "opens the manual's links when they are clicked",
    ("app/view/status.py", "QDesktopServices.openUrl()"): "shows the folder of a file that was written",
    ("starskel/command/batches/cluster.py", "distributed.Client"): "batches on a cluster that the user names",
    ("starskel/command/batches/cluster.py", "distributed.as_completed"): "the same",
    ("starskel/command/batches/processes.py", "multiprocessing"): _BATCH,
    ("starskel/command/batches/processes.py", "multiprocessing.context.BaseContext"): _BATCH,
    ("starskel/command/batches/processes.py", "concurrent.futures.process.BrokenProcessPool"): _BATCH,
}
"""File and name, and why it may be there."""


def imported(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def called(tree: ast.AST) -> Iterator[str]:
    return (ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call))


def harmful(code: str) -> set[str]:
    tree = ast.parse(code)
    modules = {name for name in imported(tree) for own in MODULES if f"{name}.".startswith(f"{own}.")}
    return modules | {f"{name}()" for name in called(tree) if name in CALLS}


def test_nothing_runs_what_files_hold_or_reaches_for_the_network() -> None:
    found = {
        (path.relative_to(ROOT).as_posix(), name)
        for path in FILES
        for name in harmful(path.read_text(encoding="utf-8"))
    }
    assert found == set(ALLOWED), "say why in ALLOWED, or leave it out"


@pytest.mark.parametrize(
    ("code", "name"),
    [
        ("eval('1')", "eval()"),
        ("import pickle", "pickle"),
        ("from urllib import request", "urllib.request"),
        ("import os\nos.system('ls')", "os.system()"),
        ("from PySide6.QtNetwork import QNetworkAccessManager", "PySide6.QtNetwork.QNetworkAccessManager"),
        ("from xml.etree import ElementTree\nElementTree.fromstring(b'')", "ElementTree.fromstring()"),
    ],
)
def test_what_could_do_harm_is_seen(code: str, name: str) -> None:
    assert harmful(code) == {name}
    assert not harmful("import re\nre.compile('eval')\nself.exec()\nimport https")
