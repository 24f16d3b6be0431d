from dataclasses import replace
from math import degrees
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QColor, QDragEnterEvent, QDropEvent, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDoubleSpinBox, QSlider

from app.model.marks import Side
from app.tools.picture import picture_handles
from app.view.canvas.painters import painter
from app.view.painting.camera import Camera
from app.view.painting.pictures import LARGEST, picture_of
from app.view.painting.theme import theme_of
from app.view.wording import words
from starskel.errors import InvalidFile
from starskel.files.projects.picture import Picture
from tests.app.driver import CONTROL, LEFT, PLAIN, SHIFT, SQUARE, Driver, name_file

CAMERA = Camera(400, 300, 2, (50, 50))


def image_file(width: int, height: int, kind: str = "PNG") -> bytes:
    image = QImage(width, height, QImage.Format.Format_RGB32)
    image.fill(QColor("#20a040"))
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    assert image.save(buffer, kind)
    return bytes(data.data())


def drop(driver: Driver, data: QMimeData, side: Side = "source") -> None:
    """Drop something on a canvas."""
    canvas = driver.window.canvases[side]
    place, action = QPointF(50, 50), Qt.DropAction.CopyAction
    entered = QDragEnterEvent(place.toPoint(), action, data, LEFT, PLAIN)
    QApplication.sendEvent(canvas, entered)
    if entered.isAccepted():
        QApplication.sendEvent(canvas, QDropEvent(place, action, data, LEFT, PLAIN))


def test_a_picture_that_is_dropped_stays_where_it_was(driver: Driver, tmp_path: Path) -> None:
    file = tmp_path / "photo.png"
    file.write_bytes(image_file(40, 20))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(file))])
    offered = Qt.DropAction.CopyAction | Qt.DropAction.MoveAction
    for kind, place in ((QDragEnterEvent, QPoint(50, 50)), (QDropEvent, QPointF(50, 50))):
        event = kind(place, offered, data, LEFT, PLAIN)
        event.setDropAction(Qt.DropAction.MoveAction)
        QApplication.sendEvent(driver.window.canvases["source"], event)
        assert event.isAccepted()
        assert event.dropAction() == Qt.DropAction.CopyAction
    assert driver.document.picture("source") is not None


@pytest.fixture
def pictured(driver: Driver, tmp_path: Path) -> Driver:
    file = tmp_path / "photo.png"
    file.write_bytes(image_file(40, 20))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(file))])
    drop(driver, data)
    return driver


def picture(driver: Driver) -> Picture:
    found = driver.document.picture("source")
    assert found is not None
    return found


def test_words_about_an_empty_canvas_do_not_hide_its_picture(
    pictured: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    invited: list[str] = []
    lines: list[str] = []
    monkeypatch.setattr(painter, "paint_invitation", lambda *given: invited.append(given[3]))
    monkeypatch.setattr(painter, "paint_line", lambda *given: lines.append(given[3]))
    for canvas in pictured.window.canvases.values():
        canvas.grab()
    assert invited == ["Draw the target shape here"]
    assert lines == [words.pictured()]


def test_a_picture_fills_most_of_the_canvas_and_keeps_its_proportions() -> None:
    placed = picture_of(image_file(40, 20), CAMERA)
    assert placed.middle == (50, 50)
    assert placed.size == pytest.approx((160, 80))
    assert placed.content == image_file(40, 20)


def test_a_large_picture_is_stored_smaller() -> None:
    placed = picture_of(image_file(3000, 100), CAMERA)
    stored = QImage.fromData(placed.content)
    assert stored.width() == LARGEST
    assert placed.size[0] / placed.size[1] == pytest.approx(stored.width() / stored.height())


def test_other_kinds_of_image_are_stored_as_what_every_program_reads() -> None:
    assert QImage.fromData(picture_of(image_file(30, 30, "BMP"), CAMERA).content, "JPG").width() == 30


def test_what_is_no_picture_is_refused() -> None:
    with pytest.raises(InvalidFile, match="no picture"):
        picture_of(b"not at all", CAMERA)


def test_a_dropped_picture_is_behind_the_shape_and_undone_as_one_step(pictured: Driver) -> None:
    assert picture(pictured).size[0] == 2 * picture(pictured).size[1]
    assert pictured.session.tool.name == "picture"
    assert pictured.session.undoes == "Place picture"
    grabbed = pictured.window.canvases["source"].grab().toImage()
    middle = grabbed.pixelColor(grabbed.width() // 2, grabbed.height() // 2)
    assert middle.green() > middle.red()
    pictured.key(Qt.Key.Key_Z, CONTROL)
    assert pictured.document.picture("source") is None


def test_a_picture_dropped_on_the_other_canvas_is_the_one_that_commands_are_about(
    pictured: Driver, tmp_path: Path
) -> None:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(tmp_path / "photo.png"))])
    assert pictured.session.selection.side == "source"
    drop(pictured, data, "target")
    assert pictured.window.actions_table["picture-remove"].isEnabled()
    pictured.window.actions_table["picture-remove"].trigger()
    assert pictured.document.picture("target") is None
    assert pictured.document.picture("source") is not None


def test_a_dropped_text_is_refused_on_the_canvas(driver: Driver, tmp_path: Path) -> None:
    file = tmp_path / "notes.txt"
    file.write_text("nothing to see")
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(file))])
    drop(driver, data)
    assert driver.document.picture("source") is None
    assert driver.session.refusal is not None


def test_it_is_dragged_and_scaled_about_the_opposite_corner(pictured: Driver) -> None:
    before = picture(pictured)
    pictured.drag("source", (50, 50), (55, 52), (53, 48))
    moved = picture(pictured)
    np.testing.assert_allclose(np.subtract(moved.middle, before.middle), (3, -2), atol=1)
    (x, y), (width, height) = moved.middle, moved.size
    corner = (x + width / 2, y + height / 2)
    pictured.drag("source", corner, (x + width / 3, y + height / 3), (x, y))
    scaled = picture(pictured)
    np.testing.assert_allclose(scaled.size, (width / 2, height / 2), atol=1.5)
    fixed = np.subtract(scaled.middle, np.array(scaled.size) / 2)
    np.testing.assert_allclose(fixed, (x - width / 2, y - height / 2))


def handle(driver: Driver, name: str) -> tuple[float, float]:
    """Give where a handle of the picture is, or where it is held in the middle."""
    pixel = 1 / driver.window.canvases["source"].camera.scale
    return {**picture_handles(picture(driver), pixel), "middle": picture(driver).middle}[name]


@pytest.fixture
def small(pictured: Driver) -> Driver:
    """Have a picture of 40 by 20 in the middle of the canvas."""
    set_number(pictured, "width", 40)
    set_number(pictured, "height", 20)
    return pictured


def set_number(driver: Driver, name: str, value: float) -> None:
    field = driver.window.options.pages["picture"].findChild(QDoubleSpinBox, name)
    assert field is not None
    field.setValue(value)


def test_it_is_turned_by_the_round_handle_and_undone_as_one_step(small: Driver) -> None:
    before, (x, y) = picture(small), picture(small).middle
    small.drag("source", handle(small, "turn"), (x - 20, y + 18), (x - 30, y + 0.2))
    turned = picture(small)
    assert degrees(turned.rotation) == pytest.approx(90, abs=0.6)  # half a pixel at this distance
    assert turned == replace(before, rotation=turned.rotation)
    assert small.session.undoes == "Turn picture"
    image = small.window.canvases["source"].grab().toImage()
    pixel = small.window.canvases["source"].camera.to_screen(np.array([x, y + before.size[0] * 0.4]))
    assert image.pixelColor(round(pixel[0]), round(pixel[1])).green() > 150  # where it was not upright
    assert image.pixelColor(round(pixel[0]), round(pixel[1])).red() < 200
    small.key(Qt.Key.Key_Z, CONTROL)
    assert picture(small) == before


def test_turned_its_sides_stretch_it_along_its_own_width(small: Driver) -> None:
    (x, y), (width, height) = picture(small).middle, picture(small).size
    small.drag("source", handle(small, "turn"), (x - 20, y + 18), (x - 30, y + 0.2))
    top = handle(small, "east")
    small.drag("source", top, (top[0], top[1] - 5), (top[0] + 3, top[1] - 12))
    stretched = picture(small)
    np.testing.assert_allclose(stretched.size, (width - 12, height), atol=1)
    assert stretched.size[1] == height


def test_escape_puts_it_back(pictured: Driver) -> None:
    before = picture(pictured)
    pictured.press("source", *handle(pictured, "turn"))
    pictured.hover("source", 20, 20)
    pictured.key(Qt.Key.Key_Escape)
    pictured.release("source", 20, 20)
    assert picture(pictured) == before


def test_keys_move_turn_and_scale_it_each_as_one_step(pictured: Driver) -> None:
    before, alt = picture(pictured), Qt.KeyboardModifier.AltModifier
    for _ in range(3):
        pictured.key(Qt.Key.Key_Left, alt)
    assert degrees(picture(pictured).rotation) == pytest.approx(3)
    pictured.key(Qt.Key.Key_Up, alt | SHIFT)
    np.testing.assert_allclose(picture(pictured).size, np.multiply(before.size, 1.1))
    pictured.key(Qt.Key.Key_Right, SHIFT)
    assert picture(pictured).middle[0] > before.middle[0]
    for _ in range(3):
        pictured.key(Qt.Key.Key_Z, CONTROL)
    assert picture(pictured) == before


def test_numbers_place_it_and_what_is_not_typed_keeps_all_its_digits(pictured: Driver) -> None:
    before = picture(pictured)
    for name, value in (("x", 12.5), ("height", 30.0), ("turn", -45.0)):
        set_number(pictured, name, value)
    placed = picture(pictured)
    assert placed.middle == (12.5, before.middle[1])
    assert placed.size == (before.size[0], 30.0)
    assert degrees(placed.rotation) == pytest.approx(-45)


def test_cropped_it_is_seen_in_the_shape_alone(pictured: Driver) -> None:
    base = QColor(theme_of(pictured.window.palette()).base)
    pictured.draw("source", SQUARE)
    (x, y), (width, _) = picture(pictured).middle, picture(pictured).size
    pictured.window.actions_table["picture-crop"].trigger()
    assert picture(pictured).cropped
    faint = ground(pictured, x + width * 0.48, y)
    pictured.key(Qt.Key.Key_S)
    assert ground(pictured, x + width * 0.48, y) == base
    assert faint != base  # while it is placed, one sees what is cut off
    assert ground(pictured, x + 3, y).green() > ground(pictured, x + 3, y).red()
    pictured.window.actions_table["picture-crop"].trigger()
    assert ground(pictured, x + width * 0.48, y) != base


def ground(driver: Driver, x: float, y: float) -> QColor:
    """Give the colour at a place of the source canvas."""
    canvas = driver.window.canvases["source"]
    column, row = canvas.camera.to_screen(np.array([x, y]))
    return canvas.grab().toImage().pixelColor(round(column), round(row))


def test_locked_it_stays(pictured: Driver) -> None:
    pictured.window.actions_table["picture-lock"].trigger()
    locked = picture(pictured)
    assert locked.locked
    pictured.drag("source", (50, 50), (55, 52), (60, 45))
    assert picture(pictured) == locked
    pictured.window.actions_table["picture-lock"].trigger()
    assert not picture(pictured).locked


def test_its_opacity_is_set_as_one_step(pictured: Driver) -> None:
    slider = pictured.window.options.findChild(QSlider, "opacity")
    assert slider is not None
    slider.setFocus()
    for _ in range(3):
        QTest.keyClick(slider, Qt.Key.Key_PageUp)
    assert picture(pictured).opacity == pytest.approx(0.8)
    pictured.key(Qt.Key.Key_Z, CONTROL)
    assert picture(pictured).opacity == 0.5


def test_delete_removes_it(pictured: Driver) -> None:
    pictured.key(Qt.Key.Key_Delete)
    assert pictured.document.picture("source") is None


def test_a_shape_is_drawn_over_it_and_both_are_saved(pictured: Driver, tmp_path: Path) -> None:
    pictured.draw("source", SQUARE)
    kept = picture(pictured)
    path = tmp_path / "over.json"
    pictured.save(path)
    pictured.session.new()
    pictured.open(path)
    assert picture(pictured) == kept
    assert len(pictured.document.vertices("source")) == 4


def test_it_is_opened_from_the_menu(driver: Driver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "photo.png").write_bytes(image_file(40, 20))
    driver.in_dialog(lambda dialog: name_file(dialog, "photo.png"))
    driver.window.actions_table["picture-open"].trigger()
    assert picture(driver).size[0] == 2 * picture(driver).size[1]
