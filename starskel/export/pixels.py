"""Drawings as pixels: PDFium draws the page that the PDF out has, with smooth edges and its own faces.

What no colour covers is transparent; alpha is straight.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import reduce
from itertools import groupby
from threading import Lock

import numpy as np
import pypdfium2
from PIL import Image
from pypdfium2 import raw

from starskel.errors import StarskelError, told
from starskel.export.animation import Animation
from starskel.export.film import Film
from starskel.export.pdf import pdf_document
from starskel.images.placed import Pixels
from starskel.limits import DRAWN_PIXELS, PICTURE_SIDE
from starskel.sheet.drawing import Drawing, Group, Item
from starskel.sheet.drawing import Image as DrawnImage
from starskel.task import Task

DOTS = 2.0
"""Pixels for a point where nothing else is wanted."""

_ONE_AT_A_TIME = Lock()
"""PDFium knows no threads."""


def pixels_of(drawing: Drawing, longer_side: int | None = None) -> Pixels:
    """Draw on nothing.

    Parameters
    ----------
    drawing : Drawing
    longer_side : int, optional
        That of the picture, in pixels; by default it has two pixels for a point.

    Returns
    -------
    (h, w, 4) array of uint8
        Red, green, blue and straight alpha, the top row first.

    Raises
    ------
    StarskelError
        If these are too many pixels.
    """
    size = size_of(drawing, longer_side)
    layers = [
        _painted(layer, drawing, size)
        if isinstance(layer, DrawnImage)
        else _page(replace(drawing, items=layer), size)
        for layer in _layers(drawing.items)
    ]
    return reduce(_over, layers) if layers else _page(drawing, size)


def _layers(items: Sequence[Item]) -> Iterator[DrawnImage | tuple[Item, ...]]:
    """Give images, and between them all else together."""
    for is_image, own in groupby(_single(items), lambda item: isinstance(item, DrawnImage)):
        if is_image:
            yield from (item for item in own if isinstance(item, DrawnImage))
        else:
            yield tuple(own)


def _single(items: Sequence[Item]) -> Iterator[Item]:
    for item in items:
        if isinstance(item, Group):
            yield from _single(item.items)
        else:
            yield item


def _painted(image: DrawnImage, drawing: Drawing, size: tuple[int, int]) -> Pixels:
    """Paint a picture into whole pixels, as many as its box meets."""
    scale = np.array(size) / (drawing.width, drawing.height)
    low, high = np.floor(image.box[0] * scale), np.ceil(image.box[1] * scale)
    low, high = np.maximum(low, 0).astype(int), np.minimum(high, size).astype(int)
    pixels = np.zeros((size[1], size[0], 4), dtype=np.uint8)
    if (low < high).all():
        width, height = (high - low).tolist()
        rows, columns = slice(size[1] - high[1], size[1] - low[1]), slice(low[0], high[0])
        pixels[rows, columns] = image.paint(np.array([low, high]) / scale, (width, height))
    return pixels


def _over(behind: Pixels, front: Pixels) -> Pixels:
    images = Image.fromarray(behind), Image.fromarray(front)
    return np.asarray(Image.alpha_composite(*images))


def _page(drawing: Drawing, size: tuple[int, int]) -> Pixels:
    width, height = size
    with _ONE_AT_A_TIME:
        document = pypdfium2.PdfDocument(pdf_document([drawing]))
        bitmap = pypdfium2.PdfBitmap.new_native(width, height, raw.FPDFBitmap_BGRA)
        bitmap.fill_rect((0, 0, 0, 0), 0, 0, width, height)
        place = (0, 0, width, height)
        raw.FPDF_RenderPageBitmap(bitmap, document[0], *place, 0, raw.FPDF_REVERSE_BYTE_ORDER)
        pixels = np.array(bitmap.to_numpy())
        bitmap.close()
        document.close()
    return pixels


def size_of(drawing: Drawing, longer_side: int | None = None) -> tuple[int, int]:
    """Give width and height of the picture of a drawing, in pixels; parameters as for `pixels_of`."""
    scale = DOTS if longer_side is None else longer_side / max(drawing.width, drawing.height)
    width, height = (max(round(side * scale), 1) for side in (drawing.width, drawing.height))
    check_size(width, height)
    return width, height


def check_size(width: int, height: int) -> None:
    """Refuse pictures that are too large.

    Raises
    ------
    StarskelError
        Naming the limits.
    """
    if max(width, height) > PICTURE_SIDE or width * height > DRAWN_PIXELS:
        raise StarskelError(
            told("a picture of {width} × {height} pixels is too large", width=width, height=height),
            told("take fewer: at most {most}, {side} a side", most=DRAWN_PIXELS, side=PICTURE_SIDE),
        )


def moving(film: Film, task: Task) -> Iterator[Pixels]:
    """Give the pictures of an animation one after another, drawn as they are taken."""
    count = len(film.settings.moments)
    for number, drawing in enumerate(Animation(film).pictures()):
        task.reach(number / count)
        yield pixels_of(drawing, film.settings.pixels)


def durations(film: Film) -> Sequence[float]:
    """Give how long each of them is seen, in seconds."""
    return [1 / film.settings.rate] * len(film.settings.moments)
