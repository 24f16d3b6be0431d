import json
from dataclasses import replace

import av
import numpy as np
import pytest

from starskel.cli import main
from starskel.easing import Easing
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import write_project
from starskel.files.projects.step import Link, Step
from starskel.files.raster import read_image
from starskel.files.raster_writing import png_of, write_image
from starskel.polygon import Polygon
from tests.starskel.files.moving import read_animation
from tests.starskel.images.drawn import waves


@pytest.fixture
def pictures(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    sides = {}
    for name, outline in (
        ("p", [[4, 4], [4, 26], [36, 26], [36, 4]]),
        ("q", [[4, 15], [20, 28], [38, 15], [20, 2]]),
    ):
        write_image(tmp_path / f"{name}.png", waves(40, 30, len(sides)))
        sides[name] = {"image": f"{name}.png", "outline": outline}
    entry = {"id": "box", **sides, "marks": [[0, 0]]}
    (tmp_path / "pictures.json").write_text(json.dumps({"format": "image-pairs/1", "pairs": [entry]}))
    return tmp_path


def test_moving_pictures(pictures):
    for ending in ("gif", "apng", "webp"):
        words = ["--returning", "--duration", "1", "--rate", "5", "--pixels", "64", "-o", f"out.{ending}"]
        assert main(["morph", "pictures.json", *words]) == 0
        frames, durations = read_animation(pictures / f"out.{ending}")
        assert len(frames) == 8
        assert max(frames[0].shape) == 64
        assert sum(durations) == pytest.approx(1.6)
        assert np.array_equal(frames[1], frames[7])
        assert not np.array_equal(frames[0], frames[4])


def test_a_row_and_numbered_pictures(pictures, capsys):
    assert main(["morph", "pictures.json", "--pixels", "40", "-o", "row.png"]) == 0
    capsys.readouterr()
    words = ["--pixels", "40", "--layout", "frames", "--json", "-o", "f.png"]
    assert main(["morph", "pictures.json", *words]) == 0
    assert json.loads(capsys.readouterr().out) == {"files": [f"f-{k:04}.png" for k in range(1, 7)]}
    row, numbered = read_image(pictures / "row.png"), sorted(pictures.glob("f-*.png"))
    assert [path.name for path in numbered] == [f"f-{k:04d}.png" for k in range(1, 7)]
    assert np.array_equal(row, np.concatenate([read_image(path) for path in numbered], axis=1))


def test_every_pair_of_a_file_has_a_file_of_its_own(pictures):
    document = json.loads((pictures / "pictures.json").read_text())
    document["pairs"].append({**document["pairs"][0], "id": "a/b"})
    (pictures / "pictures.json").write_text(json.dumps(document))
    words = ["--frames", "2", "--pixels", "40"]
    assert main(["morph", "pictures.json", *words, "--every", "-o", "row.png"]) == 0
    assert main(["morph", "pictures.json", *words, "--id", "box", "-o", "alone.png"]) == 0
    assert (pictures / "row-box.png").read_bytes() == (pictures / "alone.png").read_bytes()
    assert (pictures / "row-a_b.png").is_file()


def test_a_project_of_several_parts_carries_its_picture(pictures):
    eye = Polygon([(1, 1), (2, 1), (2, 2), (1, 2)])
    face, other = (Polygon([(x, 0), (x + 4, 0), (x + 4, 3), (x, 3)]) for x in (0, 6))
    picture = Picture(png_of(waves(40, 30)), (2.0, 1.5), (4.0, 3.0))
    shapes = (replace(KeyShape.of(face, eye), picture=picture), KeyShape.of(other))
    links = (Link(0, 0), Link(1, None))
    write_project(pictures / "face.json", Project("face", shapes, (Step(links),)))
    assert main(["morph", "face.json", "--at", "0", "--pixels", "100", "-o", "face.png"]) == 0
    frame = read_image(pictures / "face.png")
    assert (frame[..., 3] == 0).mean() > 0.3  # the hole, and what is right of the face


def test_one_moment_on_a_ground(pictures):
    words = ["--at", "0.5", "--paper", "#ffcc00", "--method", "certified", "--pixels", "50", "-o", "m.png"]
    assert main(["morph", "pictures.json", *words]) == 0
    found = read_image(pictures / "m.png")
    assert found[0, 0].tolist() == [255, 204, 0, 255]
    assert (found[..., 3] == 255).all()


def test_a_project_with_a_picture_moves_as_its_easing_says(pictures):
    square = Polygon([(0, 0), (4, 0), (4, 3), (0, 3)])
    picture = Picture(png_of(waves(40, 30)), (2.0, 1.5), (4.0, 3.0))
    late = replace(Step.of(), easing=Easing((1, 0), (1, 0)))
    turned = Polygon([(10, 0), (14, 0), (14, 3), (10, 3)])
    write_project(
        pictures / "p.json",
        Project("p", (replace(KeyShape.of(square), picture=picture), KeyShape.of(turned)), (late,)),
    )
    assert main(["morph", "p.json", "--eased", "--frames", "3", "--pixels", "140", "-o", "row.png"]) == 0
    frames = np.split(read_image(pictures / "row.png"), 3, axis=1)
    lefts = [int(np.flatnonzero(frame[..., 3].any(axis=0))[0]) for frame in frames]
    assert lefts[1] - lefts[0] < 0.3 * (lefts[2] - lefts[0])


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["pictures.json", "-o", "x.svg"], "end it in .gif or .apng or .webp or .mp4 or .png"),
        (["pictures.json", "--step", "1", "-o", "x.gif"], "is no project and has no steps"),
        (["plain.json", "-o", "x.gif"], 'no picture behind the shapes of "plain"; place one'),
        (["pictures.json", "--id", "bax", "-o", "x.gif"], 'no pair "bax"; choose one of box'),
        (["p.png", "-o", "x.gif"], "make a project of two of them: starskel convert p.png OTHER"),
        (["pictures.json", "--frames", "900", "-o", "x.png"], "is too large; take fewer"),
    ],
)
def test_what_is_wrong_is_said(pictures, capsys, words, said):
    square = KeyShape.of(Polygon([(0, 0), (4, 0), (4, 3), (0, 3)]))
    write_project(pictures / "plain.json", Project("plain", (square, square), (Step.of(),)))
    assert main(["morph", *words]) == 2
    assert said in capsys.readouterr().err
    assert not list(pictures.glob("x.*"))


@pytest.mark.parametrize(
    "words", [["--pixels", "0"], ["--duration", "-1"], ["--paper", "red"], ["--frames", "1"]]
)
def test_words_that_are_no_numbers_are_refused(pictures, words):
    with pytest.raises(SystemExit):
        main(["morph", "pictures.json", *words, "-o", "x.gif"])


def test_video(pictures):
    assert (
        main(["morph", "pictures.json", "--rate", "6", "--duration", "2", "--pixels", "61", "-o", "x.mp4"])
        == 0
    )
    with av.open(str(pictures / "x.mp4")) as container:
        frames = list(container.decode(video=0))
        assert len(frames) == 12
        assert float(container.duration / av.time_base) == pytest.approx(2, abs=0.05)
        assert frames[0].to_ndarray(format="rgb24")[0, 0].min() > 240
