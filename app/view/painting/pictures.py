"""Images as pictures of a project, and pictures as images to be painted."""

from functools import lru_cache

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMimeData, QSize, Qt
from PySide6.QtGui import QImage, QImageReader, QImageWriter

from app.view.painting.camera import Camera
from starskel.errors import InvalidFile, told
from starskel.files.projects.picture import Picture

LARGEST = 2048
"""Pixels of the longer side; larger images are stored smaller, or projects would swell."""

KEPT = (b"png", b"jpeg")
"""Files of these formats are stored as they are."""

FILL = 0.8
"""The part of the canvas that a new picture fills."""


def picture_of(content: bytes, camera: Camera) -> Picture:
    """Give an image file as a picture in the middle of what a camera shows.

    Raises
    ------
    InvalidFile
        If it is no image, or none that is known here.
    """
    data = QByteArray(content)
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.ReadOnly)
    reader = QImageReader(buffer)
    reader.setAutoTransform(True)
    kept = (
        bytes(reader.format().data()) in KEPT
        and reader.transformation() == reader.transformation().TransformationNone
    )
    image = reader.read()
    if image.isNull():
        what = told("this is no picture, or of a kind that is not known here")
        raise InvalidFile(what, told("save it as PNG or JPEG"))
    if max(image.width(), image.height()) > LARGEST:
        image = image.scaled(
            QSize(LARGEST, LARGEST),
            Qt.AspectRatioMode.KeepAspectRatio,
            Qt.TransformationMode.SmoothTransformation,
        )
        kept = False
    return _placed(content if kept else _file_of(image), image, camera)


def image_in(data: QMimeData) -> bytes | None:
    """Give the image file that is dropped or pasted, None where there is none."""
    for url in data.urls():
        if url.isLocalFile() and QImageReader(url.toLocalFile()).canRead():
            with open(url.toLocalFile(), "rb") as file:
                return file.read()
    if data.hasImage():
        image = QImage(data.imageData())
        return None if image.isNull() else _file_of(image)
    return None


@lru_cache(maxsize=16)
def image_of(content: bytes, halvings: int = 0) -> QImage:
    """Give the image to be painted, halved so often; the last few are kept, for painting must not wait."""
    if not halvings:
        return QImage.fromData(content)
    larger = image_of(content, halvings - 1)
    size = QSize(max(larger.width() // 2, 1), max(larger.height() // 2, 1))
    return larger.scaled(size, mode=Qt.TransformationMode.SmoothTransformation)


def _placed(content: bytes, image: QImage, camera: Camera) -> Picture:
    fit = FILL * min(camera.width / image.width(), camera.height / image.height()) / camera.scale
    return Picture(content, camera.centre, (image.width() * fit, image.height() * fit))


def _file_of(image: QImage) -> bytes:
    """Give an image as PNG where it lets something through, else as JPEG, which is smaller."""
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QImageWriter(buffer, b"png" if image.hasAlphaChannel() else b"jpeg")
    writer.setQuality(90)
    writer.write(image)
    return bytes(data.data())
