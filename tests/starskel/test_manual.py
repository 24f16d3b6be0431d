"""The manual says what is true: its links, its code, its commands and the list of names."""

import re
import shlex
from pathlib import Path

import pytest

import starskel
from starskel.cli import _parser
from starskel.files.examples import resource_folder

MANUAL = resource_folder() / "manual"
PAGES = sorted(MANUAL.glob("*.md"))
ICON = Path(__file__).parents[1] / "files" / "icons" / "lucide-heart.svg"


def test_every_page_can_be_reached_and_every_link_leads_somewhere():
    links = set(re.findall(r"\]\(([^)]+)\)", (MANUAL / "README.md").read_text("utf-8")))
    assert links == {page.name for page in PAGES} - {"README.md"}


def test_the_code_of_the_manual_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "icons.svg").write_bytes(ICON.read_bytes())
    names = {}
    for code in re.findall(r"```python\n(.*?)```", (MANUAL / "scripting.md").read_text("utf-8"), re.DOTALL):
        exec(code, names)
    assert (tmp_path / "arm.svg").read_text().count('id="frame-') == 7


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_commands_of_the_manual_are_understood(page):
    text = page.read_text("utf-8")
    for line in re.findall(r"^    starskel (.+)$", text, re.MULTILINE):
        assert _parser().parse_args(shlex.split(line))
    for option in re.findall(r"^    (--[a-z-]+)", text, re.MULTILINE):
        assert option in _render_help()


def _render_help():
    (verbs,) = [action for action in _parser()._actions if action.choices]
    return verbs.choices["render"].format_help()


def test_every_public_name_is_listed_with_the_first_sentence_of_its_description():
    text = (MANUAL / "library.md").read_text("utf-8")
    assert set(re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE)) == set(starskel.__all__)
