"""The manual says what is true: its links, its code, its commands and the list of names."""

import re
import shlex
from pathlib import Path

import pytest

import starskel
from starskel.cli import command_parser, main
from starskel.files.projects.examples import resource_folder

TESTS = Path(__file__).parents[1]
MANUAL = resource_folder() / "manual"
PAGES = sorted(MANUAL.glob("*.md"))
README = TESTS.parent / "README.md"
ICONS = TESTS / "files" / "icons"
FONT = next(Path("/usr/share/fonts").rglob("DejaVuSerif.ttf"), Path("no font"))

FILES = {
    "drawing.json": resource_folder() / "examples" / "arm.json",
    "pictures.json": resource_folder() / "examples" / "figure-10-dog.json",
    "shapes.json": TESTS / "shapes" / "letters.json",
    "shapes/few.json": resource_folder() / "examples" / "star.json",
    "heart.svg": ICONS / "lucide-heart.svg",
    "star.svg": ICONS / "lucide-star.svg",
    "serif.ttf": FONT,
}
"""What the commands take, by the names that the manual gives them."""

SMALLER = {"1080": "108", "480": "96", "120": "6"}
"""Fewer pixels and frames: so it takes less time."""

PARTS = {
    "rim": [(0, 0), (9, 0), (9, 9), (0, 9)],
    "left_eye": [(2, 6), (3, 6), (3, 7), (2, 7)],
    "right_eye": [(6, 6), (7, 6), (7, 7), (6, 7)],
    "mouth": [(3, 2), (6, 2), (5, 3)],
    "other": starskel.Shape(
        [[(0, 0), (90, 0), (45, 90)], [(20, 8), (30, 8), (25, 20)], [(60, 8), (70, 8), (65, 20)]]
    ),
}
"""What the README's shape is made of."""

COMMANDS = sorted(
    {
        command.partition("  #")[0].strip()
        for text in (command_parser().epilog, *(page.read_text("utf-8") for page in (README, *PAGES)))
        for command in re.findall(r"^ {2,}starskel (.+)$", text, re.MULTILINE)
    }
)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """What the commands take, in the folder that they run in."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "shapes").mkdir()
    for name, path in FILES.items():
        if path.exists():
            (tmp_path / name).write_bytes(path.read_bytes())
    drawn = [
        re.sub(
            r"<!--.*?-->|</?svg[^>]*>", "", (ICONS / f"lucide-{name}.svg").read_text(), flags=re.DOTALL
        ).replace("<path", f'<path id="{name}"')
        for name in ("heart", "star")
    ]
    (tmp_path / "icons.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{"".join(drawn)}</svg>')
    return tmp_path


def test_every_page_can_be_reached_and_every_link_leads_somewhere():
    links = set(re.findall(r"\]\(([^)]+)\)", (MANUAL / "README.md").read_text("utf-8")))
    assert links == {page.name for page in PAGES} - {"README.md"}


@pytest.mark.parametrize(
    "page", [page for page in (*PAGES, README) if "```python" in page.read_text("utf-8")], ids=str
)
def test_code_runs(page, folder):
    names = {"Path": Path, **PARTS}
    for code in re.findall(r"```python\n(.*?)```", page.read_text("utf-8"), re.DOTALL):
        exec(code, names)
    if page.stem == "scripting":
        assert (folder / "arm.svg").read_text().count('id="frame-') == 7


@pytest.mark.parametrize("line", COMMANDS)
def test_commands_do_what_they_say(line, folder):
    if "serif.ttf" in line and not FONT.exists():
        pytest.skip("DejaVu Sans is not installed")
    words = [SMALLER.get(word, word) for word in shlex.split(line.partition(">")[0])]
    if words[0] == "morph":
        words += ["--pixels", "48", "--rate", "8"]
    before = {path: path.stat().st_mtime_ns for path in folder.rglob("*")}
    assert main(words) == 0
    after = {path: path.stat().st_mtime_ns for path in folder.rglob("*")}
    assert (after != before) == ("-o" in words)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_options_of_the_manual_are_there(page):
    for option in re.findall(r"^    (--[a-z-]+)", page.read_text("utf-8"), re.MULTILINE):
        assert option in _render_help()


def _render_help():
    (verbs,) = [action for action in command_parser()._actions if action.choices]
    return verbs.choices["render"].format_help()


def test_every_public_name_is_listed_with_the_first_sentence_of_its_description():
    text = (MANUAL / "library.md").read_text("utf-8")
    assert set(re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE)) == set(starskel.__all__)
