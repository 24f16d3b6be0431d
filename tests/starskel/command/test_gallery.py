"""The gallery, read back by parsers of HTML and XML."""

import json
import xml.etree.ElementTree as ET
from html.parser import HTMLParser
from pathlib import Path

import pytest

from starskel.blending import COMPARED
from starskel.cli import main
from starskel.files.projects.examples import example, resource_folder
from tests.starskel.command.test_verbs import LETTERS, texts

HAND = str(resource_folder() / "examples" / "hand.json")
QUICK = ("--method", "vertex", "--method", "star-skeleton", "--frames", "3")

TRIANGLE = [[0, 0], [4, 0], [0, 3]]
BOW = [[0, 0], [1, 1], [1, 0], [0, 1]]
VOID = {"meta", "input", "br", "img"}


class Page(HTMLParser):
    """A page taken to pieces; it complains where tags do not match."""

    def __init__(self, path):
        super().__init__()
        self.tags, self.attributes, self.open, self.texts = [], [], [], []
        self.feed(path.read_text(encoding="utf-8"))
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append((self.open[-1] if self.open else "", data.strip()))

    def having(self, tag, name):
        return [attributes[name] for own, attributes in self.attributes if own == tag and name in attributes]

    def inside(self, tag):
        return [text for own, text in self.texts if own == tag and text]


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.fixture(scope="module")
def gallery(tmp_path_factory):
    """A page of five pairs from two files."""
    folder = tmp_path_factory.mktemp("gallery") / "deep" / "down"
    assert main(["gallery", "-o", str(folder), HAND, LETTERS, *QUICK]) == 0
    return folder


def pairs_file(*entries):
    pairs = [{"id": name, "p": ring, "q": TRIANGLE, "marks": []} for name, ring in entries]
    Path("pairs.json").write_text(json.dumps({"format": "polygon-pairs/1", "pairs": pairs}))
    return "pairs.json"


def test_every_pair_has_a_place_an_anchor_and_a_sheet_beside_the_page(gallery):
    page = Page(gallery / "index.html")
    places = page.having("section", "id")
    assert places == ["a-hand-opens", "letter-c-s", "letter-e-f", "letter-k-x", "letter-t-y"]
    assert set(page.having("a", "href")) == {f"#{place}" for place in places}
    assert page.having("img", "src") == [f"{place}.svg" for place in places]
    assert {path.name for path in gallery.iterdir()} == {"index.html", *page.having("img", "src")}
    assert all(page.having("img", "alt"))


def test_texts_tell_what_the_pair_is(gallery):
    first, letter = [text for text in Page(gallery / "index.html").inside("p") if "vertices" in text][:2]
    assert first.endswith("63 and 78 vertices, 7 marks.")
    assert letter.startswith("DejaVu")
    main(["gallery", "-o", "out", str(resource_folder() / "examples" / "figure-11-coil.json"), *QUICK])
    (text,) = [text for text in Page(Path("out", "index.html")).inside("p") if "vertices" in text]
    assert text.startswith(example("figure-11-coil").description.rstrip("."))


def test_what_was_written_is_told_to_machines(capsys):
    assert main(["gallery", HAND, "-o", "out", "--json", *QUICK]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told == {"files": ["out/index.html", "out/a-hand-opens.svg"], "failures": []}
    assert all(Path(path).exists() for path in told["files"])


def test_the_sheets_show_the_methods_as_strips(gallery):
    shown = texts(gallery / "a-hand-opens.svg")
    assert {"vertex", "star-skeleton", "t = 0.5", "simple, proven"} <= set(shown)
    assert any(text.startswith("natural crossing at t = ") for text in shown)
    assert "A hand opens" not in shown  # it stands above the sheet
    assert ET.parse(gallery / "a-hand-opens.svg").getroot().get("width").endswith("pt")


def test_verdicts_and_figures_are_those_of_the_command(gallery, capsys):
    main(["measure", LETTERS, *QUICK[:4], "--json"])
    page = Page(gallery / "index.html")
    cells = page.inside("td")
    figures = json.loads(capsys.readouterr().out)["figures"]
    for found in figures:
        drift = found["area_deviation"]
        assert f"{100 * drift:.{1 if drift < 0.0995 else 0}f} %" in cells
    crossing = [f"{found['harmful_frames']} harmful" for found in figures if not found["simple"]]
    assert crossing
    assert {words for words in page.inside("span") if "harmful" in words} >= set(crossing)


def test_the_page_needs_no_scripts_and_nothing_from_elsewhere(gallery):
    page = Page(gallery / "index.html")
    text = (gallery / "index.html").read_text(encoding="utf-8")
    assert not {"script", "link", "iframe"} & set(page.tags)
    assert not any(word in text for word in ("http:", "https:", "url(", "@import", "onclick"))
    assert "prefers-color-scheme: dark" in text


def test_the_list_can_be_put_in_other_orders(gallery):
    page = Page(gallery / "index.html")
    assert page.having("input", "id") == ["by-given", "by-name", "by-crossings", "by-area"]
    for order in ("name", "crossings", "area"):
        ranks = [dict(p.split(": ") for p in s.split("; "))[f"--{order}"] for s in page.having("li", "style")]
        assert sorted(ranks) == list("01234")
    by_crossings = [s.split("--crossings: ")[1][0] for s in page.having("li", "style")]
    assert by_crossings[0] == "0"  # the hand's fingers cross in more frames than any letter


def test_names_are_ordered_by_the_value_of_their_numbers():
    names = ("figure 10", "Figure 9", "an arm")
    main(["gallery", "-o", "out", pairs_file(*((name, TRIANGLE) for name in names)), *QUICK])
    styles = Page(Path("out", "index.html")).having("li", "style")
    assert [style.split("--name: ")[1][0] for style in styles] == ["2", "1", "0"]


def test_equal_calls_write_equal_bytes(gallery):
    assert main(["gallery", HAND, LETTERS, *QUICK, "-o", "again"]) == 0
    for path in gallery.iterdir():
        assert path.read_bytes() == Path("again", path.name).read_bytes()


def test_bad_pairs_are_told_and_listed_and_the_rest_goes_on(capsys):
    file = pairs_file(("bow & tie", BOW), ("good", TRIANGLE))
    assert main(["gallery", "-o", "out", file, "missing.json", *QUICK]) == 2
    out, err = capsys.readouterr()
    assert out == f"{Path('out', 'index.html')}: 1 of 2 pairs\n"
    assert 'starskel: pairs.json: pair "bow & tie": source (p): edges 0-1 and 2-3 cross' in err
    assert "starskel: missing.json cannot be read" in err
    page = Page(Path("out", "index.html"))
    assert page.having("section", "id") == ["good"]
    assert len([text for text in page.inside("li") if "bow & tie" in text or "missing.json" in text]) == 2


def test_a_page_without_any_good_pair_is_a_page_still():
    assert main(["gallery", "-o", "out", pairs_file(("bow", BOW)), *QUICK]) == 2
    assert Page(Path("out", "index.html")).having("section", "id") == []


def test_names_become_plain_and_different_and_titles_stay_as_they_are():
    names = ("<i>É & ç</i>", "index", "Index!", "✂", "<i>é-Ç</i>")
    main(["gallery", "-o", "out", pairs_file(*((name, TRIANGLE) for name in names)), *QUICK])
    page = Page(Path("out", "index.html"))
    assert page.having("section", "id") == ["i-e-c-i", "index-2", "index-3", "pair", "i-e-c-i-2"]
    assert [text for text in page.inside("a") if text] == [*names, *names]
    assert "i" not in page.tags


def test_a_folder_that_cannot_be_made_is_told(capsys):
    Path("file").write_text("")
    assert main(["gallery", "-o", "file", LETTERS]) == 2
    assert "file cannot be made a folder: File exists; choose a folder" in capsys.readouterr().err


def test_without_files_the_examples_are_shown(monkeypatch):
    monkeypatch.setattr("starskel.command.verbs.gallery.example_names", lambda: ("star",))
    assert main(["gallery", "-o", "out", "--frames", "2"]) == 0
    page = Page(Path("out", "index.html"))
    assert len(page.having("section", "id")) == 1
    assert {text for text in page.inside("th") if text in COMPARED} == set(COMPARED)
