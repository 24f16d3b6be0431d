"""Animations played by programs that know nothing of this one, beside the blends that they show."""

import html
import json
import re
import shutil

import numpy as np
import pytest
from lottie.objects import Animation
from lottie.objects.shapes import Ellipse, Fill, Group, Path

from starskel.export.lottie import files as lottie_files
from starskel.export.svg_animation import files as svg_files
from starskel.sheet.keyframe import Shown
from starskel.task import UNWATCHED
from tests.starskel.export.films import SLOW_START, arm, ring, steps, straying
from tests.starskel.export.rendering import run

TIMES = (0.0, 0.21, 0.5, 0.83, 0.97)
TOLERANCE = 0.001

needs_chromium = pytest.mark.skipif(not shutil.which("chromium"), reason="Chromium is not installed")

PLAYER = """<!DOCTYPE html><meta charset="utf-8"><body>%s<script>
const painted = () => new Promise(done => setTimeout(done, 60));
const shown = svg => [...svg.querySelectorAll("path")].map(path => {
  const style = getComputedStyle(path);
  return [style.visibility, style.d, style.fill];
});
onload = async () => {
  const pictures = [...document.querySelectorAll("svg")];
  const seen = pictures.map(() => []);
  for (const time of %s) {
    for (const svg of pictures) { svg.pauseAnimations(); svg.setCurrentTime(time * 3); }
    await painted();
    pictures.forEach((svg, number) => seen[number].push(shown(svg)));
  }
  document.body.textContent = JSON.stringify(seen);
};
</script>"""


def frames_of(film, times):
    """The frames that are known: all rings of the blend at shares of the time, one below the other."""
    found = []
    for time in times:
        number, t = film.tracks[0].at(time, film.settings.eased)
        frame = film.tracks[0].scenes[number].blend.at(t)
        found.append(frame if isinstance(frame, np.ndarray) else np.concatenate(frame))
    return found


def content(writer, film):
    (written,) = writer(film, UNWATCHED)
    return written.decode()


def played(folder, *films):
    """What Chromium shows of films: for each time the visible paths, as rows of points and a fill."""
    pictures = "".join(content(svg_files, film).partition("?>")[2] for film in films)
    (folder / "player.html").write_text(PLAYER % (pictures, json.dumps(TIMES)), encoding="utf-8")
    page = run_chromium(folder / "player.html")
    (body,) = re.findall(r"<body>(.*?)</body>", page, re.DOTALL)
    return [
        [[(points(d), fill) for seen, d, fill in paths if seen == "visible"] for paths in moments]
        for moments in json.loads(html.unescape(body))
    ]


def run_chromium(page):
    options = [
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--log-level=3",
        "--virtual-time-budget=9000",
        f"--user-data-dir={page.parent}/own",
    ]
    return run("chromium", *options, "--dump-dom", page.as_uri(), quiet=False).decode()


def paths_in(group):
    """The paths of a Lottie layer or group, in the order of drawing: there what comes first lies on top."""
    yield from (shape for shape in group.shapes if isinstance(shape, Path))
    for shape in reversed(group.shapes):
        if isinstance(shape, Group):
            yield from paths_in(shape)


def points(path):
    """The rings of path data, one below the other."""
    return np.array(re.findall(r"-?[\d.]+(?:e-?\d+)?", path), dtype=float).reshape(-1, 2)


@needs_chromium
def test_a_browser_shows_every_frame_where_the_blend_has_it(tmp_path):
    films = [arm(eased=True), arm(), ring(), steps(eased=True)]
    for film, moments in zip(films, played(tmp_path, *films), strict=True):
        seen = [np.concatenate([ring for ring, _ in paths]) for paths in moments]
        assert straying(frames_of(film, TIMES), seen) <= TOLERANCE
    fills = [paths[0][1] for paths in played(tmp_path, arm())[0]]
    assert len(set(fills)) == len(TIMES)


@pytest.mark.parametrize("film", [arm(), arm(eased=True), ring(), steps(eased=True), arm(returning=True)])
def test_a_lottie_player_shows_every_frame_where_the_blend_has_it(film):
    animation = Animation.load(json.loads(content(lottie_files, film)))
    way = (lambda time: 1 - abs(2 * time - 1)) if film.settings.returning else (lambda time: time)
    known, seen = frames_of(film, [way(time) for time in TIMES]), []
    for time in TIMES:
        frame = time * animation.out_point
        (layer,) = [own for own in animation.layers if own.in_point <= frame < own.out_point]
        rings = [path.shape.get_value(frame).vertices for path in paths_in(layer)]
        seen.append(np.array([list(point)[:2] for ring in rings for point in ring]))
    assert straying(known, seen) <= TOLERANCE


def test_lottie_has_one_count_of_vertices_a_path_and_all_that_is_shown():
    film = arm("star-skeleton")
    film = type(film)(
        film.name, film.tracks, type(film.settings)("animation", shown=Shown(True, True, True, True))
    )
    document = json.loads(content(lottie_files, film))
    animation = Animation.load(document)
    shapes = [
        shape
        for group in animation.layers[0].shapes[0].shapes
        if isinstance(group, Group)
        for shape in group.shapes
    ]
    blend = film.tracks[0].scenes[0].blend
    pieces, n = len(blend.decomposition.pieces), len(blend.pair)
    assert sum(isinstance(shape, Path) for shape in shapes) == pieces + 1 + 2 * (pieces - 1)
    assert sum(isinstance(shape, Ellipse) for shape in shapes) == pieces + pieces - 1 + n + len(
        blend.pair.marks
    )
    assert sum(isinstance(shape, Fill) for shape in shapes) >= pieces
    for shape in shapes:
        if isinstance(shape, Path) and shape.shape.animated:
            assert len({len(key.value.vertices) for key in shape.shape.keyframes}) == 1


def test_a_film_without_easing_runs_evenly_and_with_it_does_not():
    even, eased = steps(), steps(eased=True)
    assert even.tracks[0].at(2 / 3, False) == (1, pytest.approx(0.5))
    assert eased.tracks[0].at(2 / 3, True) == (1, pytest.approx(SLOW_START.t(0.5)))
