"""Pictures in the frames of the panels."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage

from app.view.panels.frame_view import FrameView
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project
from starskel.files.projects.step import Step
from starskel.files.raster_writing import png_of
from starskel.polygon import Polygon
from tests.app.driver import Driver

SQUARE = Polygon([(0, 0), (60, 0), (60, 60), (0, 60)])
LONG = Polygon([(0, 0), (90, 0), (90, 40), (0, 40)])


def picture(colour: tuple[int, int, int], size: tuple[float, float]) -> Picture:
    pixels = np.full((30, 30, 4), (*colour, 255), dtype=np.uint8)
    return Picture(png_of(pixels), (size[0] / 2, size[1] / 2), size)


def project(*pictures: Picture | None, methods: tuple[str, ...] = ("stitched",)) -> Project:
    shapes = [
        replace(KeyShape.of(ring), picture=own) for ring, own in zip((SQUARE, LONG), pictures, strict=True)
    ]
    return Project("p", tuple(shapes), (Step.of(),), methods)


RED, BLUE = picture((255, 0, 0), (60, 60)), picture((0, 0, 255), (90, 40))


@pytest.fixture
def pictured(driver: Driver) -> Driver:
    driver.session.show_project(project(RED, BLUE, methods=("stitched", "vertex")))
    driver.wait_for_blends()
    return driver


def view_of(driver: Driver, method: str) -> FrameView:
    return driver.window.panels.panel(method).view


def seen(driver: Driver, method: str) -> QColor:
    """Give the colour in the middle of what both shapes cover."""
    view = view_of(driver, method)
    image: QImage = view.grab().toImage()
    x, y = view.camera.to_screen(np.array([30.0, 20.0])) * view.devicePixelRatioF()
    return image.pixelColor(round(x), round(y))


def wait_for_colour(driver: Driver, method: str, red: int, blue: int) -> None:
    def is_there() -> bool:
        colour = seen(driver, method)
        return abs(colour.red() - red) <= 3 and abs(colour.blue() - blue) <= 3 and colour.green() <= 3

    driver.wait(is_there)


@pytest.mark.parametrize("method", ["stitched", "vertex"])
def test_the_pictures_fade_into_each_other_in_every_panel(pictured: Driver, method: str) -> None:
    player = pictured.window.player
    for t, red, blue in ((0.0, 255, 0), (0.5, 128, 128), (1.0, 0, 255)):
        player.stop_at(t)
        wait_for_colour(pictured, method, red, blue)


def test_the_switch_puts_the_plain_frames_back(pictured: Driver) -> None:
    pictured.window.player.stop_at(0)
    wait_for_colour(pictured, "stitched", 255, 0)
    pictured.window.actions_table["pictures"].trigger()
    assert seen(pictured, "stitched").green() > 100
    pictured.window.actions_table["pictures"].trigger()
    wait_for_colour(pictured, "stitched", 255, 0)


def test_frames_without_pictures_are_plain(pictured: Driver) -> None:
    pictured.session.show_project(project(None, None))
    pictured.wait_for_blends()
    pictured.window.player.stop_at(0)
    assert seen(pictured, "stitched").green() > 100


def test_a_picture_taken_away_leaves_the_other_one_alone(pictured: Driver) -> None:
    document = pictured.document.put_picture("source", None)
    pictured.session.store(document, "Remove picture")
    pictured.window.player.stop_at(0)
    wait_for_colour(pictured, "stitched", 0, 255)
    pictured.session.undo()
    wait_for_colour(pictured, "stitched", 255, 0)


def test_while_time_runs_ever_new_frames_come(pictured: Driver) -> None:
    moments: list[float] = []
    pictured.session.morphs.painted.connect(lambda painted: moments.append(painted.request.t))
    pictured.window.player.to_start()
    pictured.window.player.play()
    pictured.wait(lambda: len(set(moments)) > 6)
    pictured.window.player.stop_at(0.5)
    wait_for_colour(pictured, "stitched", 128, 128)
    pictured.wait(lambda: moments[-1] == 0.5)


def test_a_shape_that_is_changed_is_plain_until_its_pictures_are_there(pictured: Driver) -> None:
    pictured.window.player.stop_at(0)
    wait_for_colour(pictured, "stitched", 255, 0)
    pictured.session.store(pictured.document.move("source", [2], (8, 8)), "Move")
    pictured.wait_for_blends()
    wait_for_colour(pictured, "stitched", 255, 0)
    wait_for_colour(pictured, "vertex", 255, 0)


def test_a_picture_that_cannot_be_read_leaves_frames_plain(driver: Driver) -> None:
    broken = Picture(b"no picture", (30, 30), (60, 60))
    told: list[object] = []
    driver.session.morphs.painted.connect(told.append)
    driver.session.show_project(project(broken, None))
    driver.wait(lambda: bool(told))
    assert seen(driver, "stitched").green() > 100
