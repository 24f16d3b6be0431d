"""Pictures as files: read within limits checked before memory is taken; written one by one or moving."""

import contextlib
import io
import re
import struct
import warnings
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import numpy as np
from PIL import Image, ImageOps, ImageSequence, UnidentifiedImageError

from starskel.errors import InvalidFile, either, told
from starskel.files.disk import read_bytes, write_bytes
from starskel.images.placed import Pixels
from starskel.limits import MOVING_PIXELS, PICTURE_BYTES, PICTURE_PIXELS, PICTURE_SIDE, check_limit

FORMATS = ("PNG", "JPEG", "GIF", "WEBP", "BMP")
"""What is read."""

MOVING = (".gif", ".apng", ".webp")
"""Endings of files that hold several frames."""

_FAULTS = (OSError, ValueError, SyntaxError, EOFError, TypeError, KeyError, IndexError, struct.error)
"""What Pillow raises on damaged files."""

_STRIP = 256
"""Rows that are converted at a time."""

_OPAQUE = 128
"""From this alpha on a pixel of a GIF is opaque: GIF knows nothing between."""


def read_image(path: Path) -> Pixels:
    """Read a picture, (h, w, 4) with straight alpha; of moving ones the first frame.

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
    width, height = image.size
    if width * height > PICTURE_PIXELS or max(width, height) > PICTURE_SIDE:
        raise _too_large(name, told("{width} × {height}", width=width, height=height))
    try:
        with _quiet():
            ImageOps.exif_transpose(image, in_place=True)
            return _pixels(image)
    except _FAULTS as error:
        raise _damaged(name, error) from error


def write_image(path: Path, pixels: Pixels) -> None:
    """Write a picture as PNG, whole or not at all.

    Raises
    ------
    InvalidFile
        If it cannot be written.
    """
    write_bytes(path, png_of(pixels))


def png_of(pixels: Pixels) -> bytes:
    """Give a picture as a PNG file."""
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, "PNG", optimize=True)
    return stream.getvalue()


def write_animation(path: Path, frames: Iterable[Pixels], durations: Sequence[float], loops: int = 0) -> None:
    """Write frames as GIF, APNG or WebP, as the ending says, whole or not at all; as `animation_of` makes it.

    Raises
    ------
    InvalidFile
        If the ending is another one, or the file cannot be written.
    """
    if path.suffix.lower() not in MOVING:
        raise InvalidFile(
            told('{name} ends in "{ending}"', name=path.name, ending=path.suffix),
            told("end it in {endings}", endings=either(MOVING)),
        )
    write_bytes(path, animation_of(path.suffix.lower(), frames, durations, loops))


def animation_of(ending: str, frames: Iterable[Pixels], durations: Sequence[float], loops: int = 0) -> bytes:
    """Give frames as a file that moves.

    Parameters
    ----------
    ending : {".gif", ".apng", ".webp"}
        Which kind of file.
    frames : iterable of (h, w, 4) arrays
        All of one size, as many as durations.
    durations : sequence of float
        How long each is seen, in seconds. GIF counts in hundredths, the others in thousandths.
    loops : int
        How often it is repeated, 0 for ever.

    Raises
    ------
    InvalidFile
        If all frames together have more than `MOVING_PIXELS`.
    """
    images = []
    for frame in frames:
        images.append(_indexed(frame) if ending == ".gif" else Image.fromarray(frame))
        _check_fits(len(durations), images[0])
    first, *others = images
    stream = io.BytesIO()
    times = _whole(durations, 10 if ending == ".gif" else 1)
    common = {"save_all": True, "append_images": others, "duration": times, "loop": loops}
    if ending == ".gif":
        first.save(stream, "GIF", disposal=2, optimize=False, **common)
    elif ending == ".apng":
        first.save(stream, "PNG", **common)
    else:
        first.save(stream, "WEBP", lossless=True, **common)
    return stream.getvalue()


def read_animation(path: Path) -> tuple[list[Pixels], list[float]]:
    """Read all frames of a moving picture, and how long each is seen, in seconds.

    Raises
    ------
    InvalidFile
        As by `read_image`; all frames together are held to the limit of pixels.
    """
    content = read_bytes(path, PICTURE_BYTES)
    image_of(content, str(path))
    try:
        with _quiet(), Image.open(io.BytesIO(content), formats=FORMATS) as image:
            count = getattr(image, "n_frames", 1)
            pictures = [
                (_pixels(frame), frame.info.get("duration", 0) / 1000)
                for frame in _fitting(image, count, path)
            ]
    except InvalidFile:
        raise
    except Image.DecompressionBombError as error:
        raise _too_large(str(path), _told_size(error)) from None
    except _FAULTS as error:
        raise _damaged(str(path), error) from error
    return [frame for frame, _ in pictures], [duration for _, duration in pictures]


def _fitting(image: Image.Image, count: int, path: Path) -> Iterator[Image.Image]:
    """Give the frames; each can be larger than those before it."""
    for frame in ImageSequence.Iterator(image):
        if count * frame.width * frame.height > PICTURE_PIXELS:
            size = told(
                "{count} times {width} × {height}", count=count, width=frame.width, height=frame.height
            )
            raise _too_large(str(path), size)
        yield frame


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Take no warnings of Pillow: sizes are held to limits here, and what is damaged is told or mended."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def _pixels(image: Image.Image) -> Pixels:
    """Give the pixels, strip by strip: Pillow takes several copies of what it converts."""
    pixels = np.empty((image.height, image.width, 4), dtype=np.uint8)
    image.load()
    for top in range(0, image.height, _STRIP):
        bottom = min(top + _STRIP, image.height)
        pixels[top:bottom] = _strip(image.crop((0, top, image.width, bottom)))
    return pixels


def _strip(image: Image.Image) -> Pixels:
    if image.mode.startswith("I"):  # 16 bits a pixel, which would be cut off at 255
        grey = np.asarray(image, dtype=np.int64).clip(0, 65535)
        image = Image.fromarray((grey // 257).astype(np.uint8))
    return np.asarray(image.convert("RGBA"))


def _indexed(pixels: Pixels) -> Image.Image:
    """Give a frame with at most 255 colours of its own, and one that is transparent."""
    image = Image.fromarray(pixels[..., :3]).quantize(255, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    places = np.asarray(image).copy()
    places[pixels[..., 3] < _OPAQUE] = 255
    indexed = Image.fromarray(places, "P")
    palette = (image.getpalette() or [])[: 3 * 255]
    indexed.putpalette(palette + [0] * (3 * 256 - len(palette)))
    indexed.info["transparency"] = 255
    return indexed


def _check_fits(count: int, image: Image.Image) -> None:
    if count * image.width * image.height > MOVING_PIXELS:
        size = told("{count} times {width} × {height}", count=count, width=image.width, height=image.height)
        raise InvalidFile(
            told("an animation has too many pixels: {size}", size=size),
            told("take fewer or smaller pictures, at most {most} pixels, or MP4", most=MOVING_PIXELS),
        )


def _whole(durations: Sequence[float], unit: int) -> list[int]:
    """Give durations in thousandths, whole units each, so that no frame strays from its time by a unit."""
    ends = np.rint(np.cumsum(durations) * 1000 / unit).astype(int) * unit
    return [int(step) for step in np.maximum(np.diff(ends, prepend=0), unit)]


def _too_large(name: str, size: str) -> InvalidFile:
    return InvalidFile(
        told("{name} has too many pixels: {size}", name=name, size=size),
        told("scale it down to at most {most} pixels, {side} a side", most=PICTURE_PIXELS, side=PICTURE_SIDE),
    )


def _told_size(error: Image.DecompressionBombError) -> str:
    """Give the number that Pillow names: of what is this large it tells no width and height."""
    number = re.search(r"\d+", str(error))
    return number[0] if number else told("many more")


def _damaged(name: str, error: BaseException) -> InvalidFile:
    return InvalidFile(
        told("{name} is damaged: {error}", name=name, error=error), told("take an undamaged copy")
    )
