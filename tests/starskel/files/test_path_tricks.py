"""Names in files of strangers lead to no other place, and files of newer versions are refused, saying so."""

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from starskel.cli import main
from starskel.errors import InvalidFile
from starskel.files.file_name import file_name_of, file_names_of
from starskel.files.image_pairs import read_image_pairs
from starskel.files.multi_pairs import read_multi_pairs
from starskel.files.pairs import read_pairs
from starskel.files.projects.project_file import read_project
from starskel.files.raster_writing import write_image
from starskel.reading.readers import read_content
from tests.starskel.images.drawn import waves
from tests.watched import opened_by

TRICKS = [
    *(
        "../../x",
        "/etc/passwd",
        "..",
        ".",
        "",
        " ",
        "a/../../b",
        "..\\..\\x",
        "C:\\x",
        "c:x",
        "\\\\host\\share",
    ),
    *(
        "a\0b",
        "\n",
        "\x1b[2J",
        "nul",
        "CON.txt",
        "com1",
        "Lpt9.json",
        ".bashrc",
        "~/x",
        "-rf",
        "a" * 5000,
        "ä" * 300,
    ),
    *("\u202egnp.exe", "\ud800", "a:b", "a?b*c", "trailing. ", "|sh", "$(x)", "`x`"),
]


@pytest.mark.parametrize("name", TRICKS, ids=range(len(TRICKS)))
def test_a_file_of_any_name_lies_in_its_folder(name: str, tmp_path: Path) -> None:
    path = tmp_path / f"{file_name_of(name)}-12345.json"
    path.write_text("here")
    assert [each.name for each in tmp_path.iterdir()] == [path.name]
    assert path.parent.resolve() == tmp_path.resolve()


@given(st.lists(st.one_of(st.sampled_from(TRICKS), st.text(max_size=20)), max_size=30))
def test_file_names_are_fit_for_every_system_and_differ(names: list[str]) -> None:
    found = file_names_of(names)
    assert len({name.casefold() for name in found}) == len(names)
    for name in found:
        assert name
        assert name == Path(name).name
        assert len(name.encode()) <= 220
        assert not set(name) & set('/\\:*?"<>|\0')
        assert name.strip(". ") == name
        assert name.partition(".")[0].lower() not in {"con", "prn", "aux", "nul", "com1", "lpt9"}


def image_pairs(folder: Path, image: str) -> Path:
    path = folder / "pairs.json"
    outline = [[4, 4], [4, 26], [36, 26], [36, 4]]
    sides = {side: {"image": image, "outline": outline} for side in "pq"}
    path.write_bytes(encode({"format": "image-pairs/1", "pairs": [{"id": "a", **sides}]}))
    return path


def encode(document: dict[str, Any]) -> bytes:
    return json.dumps(document).encode()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a picture in it, and one beside it."""
    folder = tmp_path / "inside"
    folder.mkdir()
    write_image(folder / "a.png", waves(40, 30))
    write_image(tmp_path / "secret.png", waves(40, 30))
    return folder


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("../secret.png", "is not in the folder of the file"),
        ("x/../../secret.png", "is not in the folder of the file"),
        ("..\\secret.png", "is not in the folder of the file"),
        ("/etc/passwd", "is not in the folder of the file"),
        ("C:secret.png", "is not in the folder of the file"),
        ("//host/share/a.png", "is not in the folder of the file"),
        ("a.png\0.txt", "is not in the folder of the file"),
        ("link.png", "is not in the folder of the file"),
        ("linked/secret.png", "is not in the folder of the file"),
        ("pipe.png", '"pipe.png" is no file'),
        ("", '"" is no file'),
        (".", '"." is no file'),
        ("a" * 5000 + ".png", "cannot be read: File name too long"),
        ("nul", "cannot be read"),
        ("pairs.json", "is no picture"),
    ],
)
def test_pictures_of_pairs_lie_in_the_folder(name: str, why: str, folder: Path) -> None:
    (folder / "link.png").symlink_to(folder.parent / "secret.png")
    (folder / "linked").symlink_to(folder.parent)
    os.mkfifo(folder / "pipe.png")
    with pytest.raises(InvalidFile, match=why):
        read_image_pairs(image_pairs(folder, name)).pair("a")


def test_a_link_to_a_picture_in_the_folder_is_followed(folder: Path) -> None:
    (folder / "link.png").symlink_to("a.png")
    assert read_image_pairs(image_pairs(folder, "link.png")).pair("a").source.pixels.shape == (30, 40, 4)


HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink">{}</svg>'
SQUARE = '<path d="M0 0H9V9H0z"/>'
DRAWINGS = {
    "use": HEAD.format(f'{SQUARE}<use href="file:///etc/passwd#a"/><use xlink:href="../../x.svg#a"/>'),
    "image": HEAD.format(f'{SQUARE}<image href="/etc/passwd"/><image xlink:href="http://127.0.0.1/a.png"/>'),
    "paint": HEAD.format(f'{SQUARE}<path fill="url(file:///etc/passwd#a)" d="M0 0H9V9H0z"/>'),
    "style": HEAD.format(f'<style>@import url("file:///etc/passwd"); a{{b:c}}</style>{SQUARE}'),
    "sheet": '<?xml-stylesheet type="text/css" href="file:///etc/passwd"?>' + HEAD.format(SQUARE),
    "include": HEAD.format(
        '<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="file:///etc/passwd"/>' + SQUARE
    ),
    "base": HEAD.replace("<svg ", '<svg xml:base="file:///etc/" ').format(f'<use href="passwd"/>{SQUARE}'),
    "script": HEAD.format(f'<script href="file:///etc/passwd"/>{SQUARE}'),
    "type": '<!DOCTYPE svg SYSTEM "file:///etc/passwd">' + HEAD.format(SQUARE),
}
REFUSED = {
    "entity": '<!DOCTYPE svg [<!ENTITY e SYSTEM "file:///etc/passwd">]>' + HEAD.format("&e;" + SQUARE),
    "parameter": '<!DOCTYPE svg [<!ENTITY % e SYSTEM "file:///etc/passwd"> %e;]>' + HEAD.format(SQUARE),
    "laughs": '<!DOCTYPE svg [<!ENTITY a "aaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>'
    + HEAD.format("&b;" + SQUARE),
}


@pytest.mark.parametrize("drawing", DRAWINGS.values(), ids=DRAWINGS)
def test_drawings_lead_to_no_other_file(drawing: str, in_little_memory: Callable[..., Any]) -> None:
    assert in_little_memory(opened_by, read_content, drawing.encode(), Path("a.svg")) == []


@pytest.mark.parametrize("drawing", REFUSED.values(), ids=REFUSED)
def test_drawings_that_declare_entities_are_refused(
    drawing: str, in_little_memory: Callable[..., Any]
) -> None:
    (said,) = in_little_memory(opened_by, read_content, drawing.encode(), Path("a.svg"))
    assert said == "refused: a.svg: the SVG declares entities; save it as plain SVG"


def test_what_is_opened_is_seen(in_little_memory: Callable[..., Any]) -> None:
    assert in_little_memory(opened_by, Path.read_bytes, Path("/etc/hostname")) == ["open ('/etc/hostname',)"]


def test_morphs_of_all_pairs_of_a_file_lie_beside_each_other(folder: Path) -> None:
    document = {"format": "image-pairs/1", "pairs": []}
    ids = ["../../x", "/etc/x", "a" * 5000, "a\0b", "..", "", "A", "a"]
    outline = [[4, 4], [4, 26], [36, 26], [36, 4]]
    side = {"image": "a.png", "outline": outline}
    document["pairs"] = [{"id": name, "p": side, "q": side} for name in ids]
    (folder / "pairs.json").write_bytes(encode(document))
    before = set(folder.parent.rglob("*"))
    words = ["--every", "--at", "0", "--pixels", "9", "--method", "vertex", "-o", str(folder / "out.png")]
    assert main(["morph", str(folder / "pairs.json"), *words]) == 0
    made = set(folder.parent.rglob("*")) - before
    assert len(made) == len(ids)
    assert {path.parent for path in made} == {folder}


@pytest.mark.parametrize(
    ("read", "found"),
    [
        (read_pairs, "polygon-pairs/2"),
        (read_multi_pairs, "polygon-multi-pairs/2"),
        (read_image_pairs, "image-pairs/17"),
    ],
)
def test_pairs_of_newer_versions_are_refused_saying_so(
    read: Callable[[Path], object], found: str, tmp_path: Path
) -> None:
    path = tmp_path / "a.json"
    path.write_bytes(encode({"format": found, "pairs": "of another kind"}))
    with pytest.raises(InvalidFile, match=f'has the format "{found}"; .*, or open it with a newer starskel'):
        read(path)


@pytest.mark.parametrize("version", [5, 99, 10**30])
def test_projects_of_newer_versions_are_refused_whatever_they_hold(version: int, tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    path.write_bytes(encode({"format": "starskel-project", "version": version, "shapes": "others"}))
    before = path.read_bytes()
    with pytest.raises(InvalidFile, match=r"newer|a\.json"):
        read_project(path)
    assert path.read_bytes() == before
