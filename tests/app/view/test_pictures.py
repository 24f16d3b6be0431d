from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QColor, QDragEnterEvent, QDropEvent, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QSlider

from app.view.painting.camera import Camera
from app.view.painting.pictures import LARGEST, picture_of
from starskel.errors import InvalidFile
from starskel.files.picture import Picture
from tests.app.driver import CONTROL, LEFT, PLAIN, SQUARE, Driver, name_file

CAMERA = Camera(400, 300, 2, (50, 50))


def image_file(width: int, height: int, kind: str = "PNG") -> bytes:
    image = QImage(width, height, QImage.Format.Format_RGB32)
    image.fill(QColor("#20a040"))
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    assert image.save(buffer, kind)
    return bytes(data.data())


def drop(driver: Driver, data: QMimeData) -> None:
    """Drop something on the source canvas."""
    canvas = driver.window.canvases["source"]
    place, action = QPointF(50, 50), Qt.DropAction.CopyAction
    entered = QDragEnterEvent(place.toPoint(), action, data, LEFT, PLAIN)
    QApplication.sendEvent(canvas, entered)
    if entered.isAccepted():
        QApplication.sendEvent(canvas, QDropEvent(place, action, data, LEFT, PLAIN))


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
    pictured.session.save(path)
    pictured.session.new()
    pictured.session.open(path)
    assert picture(pictured) == kept
    assert len(pictured.document.vertices("source")) == 4


def test_it_is_opened_from_the_menu(driver: Driver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "photo.png").write_bytes(image_file(40, 20))
    driver.in_dialog(lambda dialog: name_file(dialog, "photo.png"))
    driver.window.actions_table["picture-open"].trigger()
    assert picture(driver).size[0] == 2 * picture(driver).size[1]
