import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.compute import Result
from app.export import FORMATS, Choice, ExportedStep, Layout, write_choice
from app.model.easing import Easing
from starskel import Cancelled, InvalidFile, Polygon, StarskelError, blend, match, measure
from starskel.cli import main
from starskel.export.write import paths_of
from starskel.files.projects.examples import example, resource_folder
from starskel.files.projects.key_shape import KeyShape, Part
from starskel.files.projects.part_looks import part_looks
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import write_project
from starskel.files.projects.step import Link, Step
from starskel.files.raster import read_image
from starskel.files.raster_writing import png_of
from starskel.sheet.drawing import Stroke
from starskel.sheet.keyframe import Shown
from starskel.sheet.style import USUAL, Look
from starskel.task import Task
from tests.starskel.images.drawn import waves

PICTURE = Picture(png_of(waves(40, 30)), (2.0, 1.5), (4.0, 3.0), rotation=0.1)
OWN = Look(("#ff8800", "#0044cc"), Stroke("#223344", 2.5), "#fafaf0", margin=7, size=150, captions=False)
OWN_WORDS = ["--fill", "#ff8800", "#0044cc", "--stroke", "#223344", "--stroke-width", "2.5"]
OWN_WORDS += ["--paper", "#fafaf0", "--margin", "7", "--size", "150", "--plain"]


@pytest.fixture(scope="module")
def results() -> tuple[Result, ...]:
    project = example("star").pair(0)
    pair = match(project.source, project.target, project.marks)
    blends = {method: blend(pair, method=method) for method in ("vertex", "edge-angle")}
    return tuple(Result(method, made, measure(made), np.zeros((2, 2))) for method, made in blends.items())


@pytest.mark.parametrize(
    ("layout", "ending"), [(layout, each.ending) for layout, formats in FORMATS.items() for each in formats]
)
def test_every_layout_is_written_in_each_of_its_formats(
    layout: Layout, ending: str, results: tuple[Result, ...], tmp_path: Path
) -> None:
    path = tmp_path / f"out{ending}"
    choice = Choice(layout, "vertex", frames=5, seconds=0.2)
    write_choice(path, "Star", choice, [ExportedStep(results, pictures=(PICTURE, None))])
    files = [path] if layout == "morph" else list(paths_of(path, choice.settings))
    assert sorted(tmp_path.iterdir()) == files
    text = files[-1].read_bytes().decode("latin-1")
    starts = {".svg": "<?xml", ".eps": "%!PS-Adobe-3.0 EPSF", ".ps": "%!PS-Adobe", ".pdf": "%PDF"}
    pictures = {".png": "\x89PNG", ".apng": "\x89PNG", ".gif": "GIF89a", ".webp": "RIFF", ".mp4": "\0\0\0"}
    assert text.startswith({**starts, **pictures, ".json": "{", ".csv": "method,"}[ending])
    assert ("<animate" in text) == (layout == "animation" and ending == ".svg")
    if ending == ".ps":
        assert text.count("%%Page:") == (5 if layout == "pages" else 1)


@pytest.mark.parametrize("ending", [".gif", ".apng", ".webp", ".mp4", ".png"])
def test_pictures_alone_are_what_the_command_writes_to_the_byte(ending: str, tmp_path: Path) -> None:
    _, exported = saved(tmp_path)
    choice = Choice(
        "morph", "stitched", frames=3, eased=True, seconds=0.3, returning=True, pixels=64, rate=20
    )
    write_choice(tmp_path / f"editor{ending}", "p", choice, [exported])
    words = ["--frames", "3", "--eased", "--duration", "0.3", "--returning", "--pixels", "64", "--rate", "20"]
    out = tmp_path / f"command{ending}"
    assert main(["morph", str(tmp_path / "p.json"), *words, "-o", str(out)]) == 0
    assert out.read_bytes() == (tmp_path / f"editor{ending}").read_bytes()


@pytest.mark.parametrize("pictures", [True, False])
def test_films_with_pictures_are_what_the_command_writes_to_the_byte(pictures: bool, tmp_path: Path) -> None:
    _, exported = saved(tmp_path)
    choice = Choice("animation", "stitched", seconds=0.2, pixels=64, rate=20, shown=Shown(pictures=pictures))
    write_choice(tmp_path / "editor.webp", "p", choice, [exported])
    words = ["--duration", "0.2", "--pixels", "64", "--rate", "20", *([] if pictures else ["--no-pictures"])]
    out = tmp_path / "command.webp"
    assert main(["render", str(tmp_path / "p.json"), *words, "-o", str(out)]) == 0
    assert out.read_bytes() == (tmp_path / "editor.webp").read_bytes()


PARTS = (
    Part(Polygon([(0, 0), (8, 0), (8, 8), (0, 8)]), colour="#ff0000"),
    Part(Polygon([(2, 2), (6, 2), (6, 6), (2, 6)])),
    Part(Polygon([(10, 0), (14, 0), (14, 4), (10, 4)])),
    Part(Polygon([(20, 0), (28, 0), (28, 8), (20, 8)]), colour="#00ffff", visible=False),
)
MOVED = tuple(replace(part, ring=Polygon(np.add(part.ring.vertices, (1, 2)))) for part in PARTS)


def parted(folder: Path) -> ExportedStep:
    """Save a project of parts: one red that becomes green, with a hole, one usual, one hidden."""
    source, target = KeyShape(PARTS), KeyShape((replace(MOVED[0], colour="#00FF00"), *MOVED[1:]))
    step = Step(tuple(Link(k, k) for k in range(4)))
    write_project(folder / "p.json", Project("p", (source, target), (step,)))
    made = blend(match(source.shape, target.shape, pairing=[link.ends for link in step.links]))
    result = Result("stitched", made, measure(made), np.zeros((2, 2)))
    return ExportedStep((result,), step, looks=part_looks(source, step, target))


@pytest.mark.parametrize("ending", [".svg", ".eps", ".ps", ".pdf", ".png"])
def test_colours_and_hidden_parts_hold_in_every_format_as_the_command_writes_it(
    ending: str, tmp_path: Path
) -> None:
    choice = Choice("frame", "stitched", t=0.25, shown=Shown(), look=replace(USUAL, captions=False))
    write_choice(tmp_path / f"editor{ending}", "p", choice, [parted(tmp_path)])
    out = tmp_path / f"command{ending}"
    words = ["--at", "0.25", "--layout", "frames", "--plain", "-o", str(out)]
    assert main(["render", str(tmp_path / "p.json"), *words]) == 0
    assert out.read_bytes() == (tmp_path / f"editor{ending}").read_bytes()
    if ending == ".svg":
        fills = re.findall(r'fill="(#\w+)"', out.read_text())
        assert fills == ["#bf4000", USUAL.fill(0.25)]
        assert "evenodd" in out.read_text()
    if ending == ".png":
        pixels = read_image(out)
        colours = {tuple(colour) for colour in pixels[pixels[..., 3] == 255][:, :3].tolist()}
        assert (0xBF, 0x40, 0) in colours
        assert not any(blue > green > red + 100 for red, green, blue in colours)
        width, height = pixels.shape[1], pixels.shape[0]
        assert width / height == pytest.approx((14 * 360 / 14 + 36) / (8 * 360 / 14 + 36), rel=0.05)


def test_colours_of_parts_move_and_hidden_ones_stay_away(tmp_path: Path) -> None:
    exported = parted(tmp_path)
    write_choice(tmp_path / "a.svg", "p", Choice("animation", "stitched"), [exported])
    text = (tmp_path / "a.svg").read_text()
    assert re.search(r'attributeName="fill"[^>]*values="#ff0000;[^"]*#00ff00"', text)
    assert text.count("<path") == 2
    fills = replace(exported, looks=tuple(replace(look, visible=False) for look in exported.looks))
    with pytest.raises(StarskelError, match="all parts are hidden"):
        write_choice(tmp_path / "b.svg", "p", Choice("row", "stitched"), [fills])
    bare = Choice("row", "stitched", look=replace(USUAL, colours=()))
    write_choice(tmp_path / "c.svg", "p", bare, [exported])
    assert set(re.findall(r'fill="([^"]+)"', (tmp_path / "c.svg").read_text())) == {"none", "#6b7480"}


def test_hidden_parts_are_not_painted_by_what_shows_pictures_alone(tmp_path: Path) -> None:
    exported = replace(
        parted(tmp_path), pictures=(Picture(png_of(waves(40, 30)), (14.0, 4.0), (28.0, 8.0)), None)
    )
    write_choice(tmp_path / "m.png", "p", Choice("morph", "stitched", frames=2, pixels=140), [exported])
    first = read_image(tmp_path / "m.png")[:, :140]
    assert first[..., 3].max() == 255
    assert first[:, 100:, 3].max() == 0


def test_what_is_given_up_leaves_no_file(tmp_path: Path) -> None:
    _, exported = saved(tmp_path)
    choice, steps = Choice("morph", "stitched", seconds=2.0, pixels=64), []
    task = Task(steps.append, lambda: len(steps) > 20)
    with pytest.raises(Cancelled):
        write_choice(tmp_path / "out.gif", "p", choice, [exported], task)
    assert steps == sorted(steps)
    assert not (tmp_path / "out.gif").exists()


def saved(folder: Path) -> tuple[Step, ExportedStep]:
    """Save a project with a picture and an easing; give its step as the editor exports it."""
    box, wide = (Polygon([(0, 0), (width, 0), (width, 3), (0, 3)]) for width in (4, 6))
    step = replace(Step.of(((0, 0),)), easing=Easing((0.4, 0.0), (0.6, 1.0)))
    shapes = replace(KeyShape.of(box), picture=PICTURE), KeyShape.of(wide)
    write_project(folder / "p.json", Project("p", shapes, (step,)))
    made = blend(match(box, wide, ((0, 0),)))
    result = Result("stitched", made, measure(made), np.zeros((2, 2)))
    return step, ExportedStep((result,), step, pictures=(PICTURE, None))


def test_a_row_holds_so_many_keyframes_and_a_frame_but_one(
    results: tuple[Result, ...], tmp_path: Path
) -> None:
    write_choice(tmp_path / "row.svg", "Star", Choice("row", "vertex", frames=7), [ExportedStep(results)])
    write_choice(tmp_path / "one.svg", "Star", Choice("frame", "vertex", t=0.25), [ExportedStep(results)])
    assert (tmp_path / "row.svg").read_text().count('id="frame-') == 7
    assert (tmp_path / "one.svg").read_text().count('id="frame-') == 1
    assert "t = 0.25" in (tmp_path / "one.svg").read_text()


def test_the_sheet_has_a_row_for_each_method(results: tuple[Result, ...], tmp_path: Path) -> None:
    write_choice(tmp_path / "sheet.svg", "Star", Choice("sheet", "vertex"), [ExportedStep(results)])
    text = (tmp_path / "sheet.svg").read_text()
    assert ">vertex<" in text
    assert ">edge-angle<" in text


def test_an_ending_that_does_not_fit_is_refused_before_anything_is_written(
    results: tuple[Result, ...], tmp_path: Path
) -> None:
    with pytest.raises(InvalidFile, match="end it in"):
        write_choice(tmp_path / "out.gif", "Star", Choice("row", "vertex"), [ExportedStep(results)])
    assert list(tmp_path.iterdir()) == []


def test_keyframes_are_apart_as_they_are_played(results: tuple[Result, ...], tmp_path: Path) -> None:
    easing = Easing((0.4, 0.0), (0.6, 1.0))
    step = Step(easing=easing)
    write_choice(
        tmp_path / "row.svg",
        "Star",
        Choice("row", "vertex", frames=5, eased=True),
        [ExportedStep(results, step)],
    )
    texts = re.findall("t = ([0-9.]+)", (tmp_path / "row.svg").read_text())
    assert texts == [f"{easing.t(time):.3g}" for time in (0, 0.25, 0.5, 0.75, 1)]
    assert float(texts[1]) < 0.2
    one = Choice("frame", "vertex", t=0.3, eased=True)
    write_choice(tmp_path / "one.svg", "Star", one, [ExportedStep(results, step)])
    assert "t = 0.3<" in (tmp_path / "one.svg").read_text()


def test_the_whole_sequence_takes_all_steps_as_long_as_each_lasts(
    results: tuple[Result, ...], tmp_path: Path
) -> None:
    there = ExportedStep(results, Step(duration=3.0), "A-B")
    again = ExportedStep(results, Step(), "B-C")
    choice = Choice("row", "vertex", frames=5, eased=True, whole=True)
    write_choice(tmp_path / "row.svg", "Star", choice, [there, again])
    texts = re.findall("t = ([0-9.]+)", (tmp_path / "row.svg").read_text())
    assert texts == ["0", "0.333", "0.667", "0", "1"]
    write_choice(tmp_path / "sheet.svg", "Star", Choice("sheet", "vertex", whole=True), [there, again])
    sheet = (tmp_path / "sheet.svg").read_text()
    assert [sheet.count(f">{name}<") for name in ("vertex, A-B", "vertex, B-C")] == [1, 1]


@pytest.mark.parametrize(
    ("layout", "ending", "words"),
    [
        ("row", ".svg", ["--frames", "5", "--marks"]),
        ("frame", ".eps", ["--at", "0.25"]),
        ("row", ".svg", ["--frames", "3", "--vertices", *OWN_WORDS]),
        ("frame", ".png", ["--at", "0.25", *OWN_WORDS]),
        ("pages", ".pdf", ["--frames", "3"]),
        ("sheet", ".svg", ["--layout", "sheet", "--method", "edge-angle"]),
        ("animation", ".svg", ["--layout", "animation", "--returning"]),
        ("row", ".png", ["--frames", "3"]),
        ("animation", ".gif", ["--duration", "0.4"]),
        ("animation", ".json", ["--layout", "animation", "--duration", "0.4"]),
        ("numbers", ".csv", ["--frames", "4"]),
    ],
)
def test_the_command_writes_the_same_bytes(
    layout: Layout, ending: str, words: list[str], results: tuple[Result, ...], tmp_path: Path
) -> None:
    frames = int(words[1]) if words[0] == "--frames" else 6
    choice = Choice(
        layout,
        "vertex",
        frames=frames,
        t=0.25,
        shown=Shown("--marks" in words, vertices="--vertices" in words),
        look=OWN if "--fill" in words else USUAL,
        seconds=0.4 if "--duration" in words else 3.0,
        returning="--returning" in words,
    )
    project = example("star")
    write_choice(
        tmp_path / f"editor{ending}", project.name, choice, [ExportedStep(results, project.steps[0])]
    )
    path = str(resource_folder() / "examples" / "star.json")
    out = str(tmp_path / f"command{ending}")
    assert main(["render", path, "--method", "vertex", *words, "-o", out]) == 0
    assert (tmp_path / f"command{ending}").read_bytes() == (tmp_path / f"editor{ending}").read_bytes()
