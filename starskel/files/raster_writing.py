"""Pictures out: one by one as PNG, or several as one that moves."""

import io
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from PIL import Image

from starskel.errors import InvalidFile, told
from starskel.files.disk import write_bytes, wrong_ending
from starskel.images.placed import Pixels
from starskel.limits import MOVING_PIXELS

MOVING = (".gif", ".apng", ".webp")
"""Endings of files that hold several frames."""

_OPAQUE = 128
"""From this alpha on a pixel of a GIF is opaque: GIF knows nothing between."""


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
        raise wrong_ending(path, MOVING)
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
