"""Pictures in: read within limits that are checked before memory is taken."""

import contextlib
import io
import re
import struct
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import count
from pathlib import Path

import numpy as np
from PIL import Image, ImageOps, UnidentifiedImageError

from starskel.errors import InvalidFile, either, told
from starskel.files.disk import read_bytes
from starskel.images.placed import Pixels, PlacedImage
from starskel.limits import (
    JPEG_PIXELS,
    PICTURE_BYTES,
    PICTURE_PIXELS,
    PICTURE_SIDE,
    WHOLE_PIXELS,
    check_limit,
)

FORMATS = ("PNG", "JPEG", "GIF", "WEBP", "BMP")
"""What is read."""

_FAULTS = (OSError, ValueError, SyntaxError, EOFError, TypeError, KeyError, IndexError, struct.error)
"""What Pillow raises on damaged files."""

_MOST = {"WEBP": PICTURE_PIXELS, "JPEG": JPEG_PIXELS}
"""Pixels of pictures of other kinds than most: WebP takes 16 bytes for each, JPEG can be decoded smaller."""

_ORIENTATION = 0x0112
"""The number under which files say how the camera was held."""

_ON_ITS_SIDE = (5, 6, 7, 8)

_STRIP = 256
"""Rows that are converted at a time."""


@dataclass(frozen=True, eq=False)
class Decoded:
    """A picture of a file.

    Attributes
    ----------
    pixels : (h, w, 4) array of uint8
        With straight alpha; of pictures of more than `PICTURE_PIXELS` at a half, a third, ... of their size.
    size : (int, int)
        Its width and height in the file, as it is to be seen.
    """

    pixels: Pixels
    size: tuple[int, int]

    @property
    def placed(self) -> PlacedImage:
        """The picture where a pixel of the file is a unit, and its lower left corner the origin."""
        width, height = self.size
        if self.pixels.shape[:2] == (height, width):
            return PlacedImage(self.pixels)
        return PlacedImage.in_box(self.pixels, (width / 2, height / 2), (width, height))


def read_image(path: Path) -> Pixels:
    """Read a picture, (h, w, 4) with straight alpha; of moving ones the first frame; large ones smaller.

    Raises
    ------
    InvalidFile
        If it cannot be read, is no picture of a kind that is known, is damaged, or exceeds a limit.
    """
    return image_of(read_bytes(path, PICTURE_BYTES), str(path))


def image_of(content: bytes, name: str = "the picture") -> Pixels:
    """Give the picture that a file of this content holds, as `read_image` does.

    Parameters
    ----------
    content : bytes
    name : str
        What errors call it.

    Raises
    ------
    InvalidFile
        If it is no picture of a kind that is known, is damaged, or exceeds a limit.
    """
    return decoded(content, name).pixels


def decoded(content: bytes, name: str = "the picture") -> Decoded:
    """Give the picture that a file of this content holds, and how large it is there.

    Parameters
    ----------
    content : bytes
    name : str
        What errors call it.

    Raises
    ------
    InvalidFile
        If it is no picture of a kind that is known, is damaged, or exceeds a limit.
    """
    check_limit(name, told("bytes"), len(content), PICTURE_BYTES)
    try:
        with _quiet():
            image = Image.open(io.BytesIO(content), formats=FORMATS)
    except UnidentifiedImageError:
        raise InvalidFile(
            told("{name} is no picture, or of a kind that is not known here", name=name),
            told("save it as {kinds}", kinds=either(FORMATS)),
        ) from None
    except Image.DecompressionBombError as error:
        raise _too_large(name, _told_size(error)) from None
    except _FAULTS as error:
        raise _damaged(name, error) from error
    _check_size(name, image)
    try:
        with _quiet():
            return _decoded(image)
    except _FAULTS as error:
        raise _damaged(name, error) from error


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Take no warnings of Pillow: sizes are held to limits here, and what is damaged is told or mended."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def _check_size(name: str, image: Image.Image) -> None:
    width, height = image.size
    most = _MOST.get(image.format or "", WHOLE_PIXELS)
    if image.format == "JPEG" and image.info.get("progressive"):
        most = WHOLE_PIXELS
    if width * height > most or max(width, height) > PICTURE_SIDE:
        raise _too_large(name, told("{width} × {height}", width=width, height=height), most)


def _decoded(image: Image.Image) -> Decoded:
    """Decode a picture; a large one is reduced before it is turned, so that fewer copies are large."""
    size, turned = image.size, image.getexif().get(_ORIENTATION, 1)
    parts = next(k for k in count(1) if -(-size[0] // k) * -(-size[1] // k) <= PICTURE_PIXELS)
    image.draft(None, (-(-size[0] // parts), -(-size[1] // parts)))  # JPEG is decoded at this size or twice
    left = next(k for k in count(1) if -(-image.width // k) * -(-image.height // k) <= PICTURE_PIXELS)
    if left > 1:
        image = Image.fromarray(_pixels(image, left))
        image.getexif()[_ORIENTATION] = turned
    ImageOps.exif_transpose(image, in_place=True)
    return Decoded(_pixels(image), size[::-1] if turned in _ON_ITS_SIDE else size)


def _pixels(image: Image.Image, parts: int = 1) -> Pixels:
    """Give the pixels, strip by strip: Pillow takes several copies of what it converts.

    Parameters
    ----------
    image : Image
    parts : int
        So many by so many pixels become one, their mean.
    """
    pixels = np.empty((-(-image.height // parts), -(-image.width // parts), 4), dtype=np.uint8)
    image.load()
    rows = _STRIP * parts
    for top in range(0, image.height, rows):
        strip = _strip(image.crop((0, top, image.width, min(top + rows, image.height))))
        small = strip if parts == 1 else np.asarray(Image.fromarray(strip).reduce(parts))
        pixels[top // parts : top // parts + len(small)] = small
    return pixels


def _strip(image: Image.Image) -> Pixels:
    if image.mode.startswith("I"):  # 16 bits a pixel, which would be cut off at 255
        grey = np.asarray(image, dtype=np.int64).clip(0, 65535)
        image = Image.fromarray((grey // 257).astype(np.uint8))
    return np.asarray(image.convert("RGBA"))


def _too_large(name: str, size: str, most: int = WHOLE_PIXELS) -> InvalidFile:
    return InvalidFile(
        told("{name} has too many pixels: {size}", name=name, size=size),
        told("scale it down to at most {most} pixels, {side} a side", most=most, side=PICTURE_SIDE),
    )


def _told_size(error: Image.DecompressionBombError) -> str:
    """Give the number that Pillow names: of what is this large it tells no width and height."""
    number = re.search(r"\d+", str(error))
    return number[0] if number else told("many more")


def _damaged(name: str, error: BaseException) -> InvalidFile:
    return InvalidFile(
        told("{name} is damaged: {error}", name=name, error=error), told("take an undamaged copy")
    )
