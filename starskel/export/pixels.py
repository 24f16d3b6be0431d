"""Drawings as pixels: PDFium draws the page that the PDF out has, with smooth edges and its own faces.

What no colour covers is transparent; alpha is straight.
"""

from collections.abc import Iterator, Sequence
from threading import Lock

import numpy as np
import pypdfium2
from pypdfium2 import raw

from starskel.errors import StarskelError, told
from starskel.export.film import Film
from starskel.export.pdf import pdf_document
from starskel.files.raster import MOST_PIXELS
from starskel.images.placed import LARGEST_SIDE, Pixels
from starskel.sheet.drawing import Drawing
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
    width, height = size_of(drawing, longer_side)
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
    if max(width, height) > LARGEST_SIDE or width * height > MOST_PIXELS:
        raise StarskelError(
            told("a picture of {width} × {height} pixels is too large", width=width, height=height),
            told("take fewer: at most {most}, {side} a side", most=MOST_PIXELS, side=LARGEST_SIDE),
        )
    return width, height


def moving(film: Film, task: Task) -> Iterator[Pixels]:
    """Give the pictures of an animation one after another, drawn as they are taken."""
    count = len(film.settings.moments)
    for number, drawing in enumerate(film.pictures()):
        task.reach(number / count)
        yield pixels_of(drawing, film.settings.pixels)


def durations(film: Film) -> Sequence[float]:
    """Give how long each of them is seen, in seconds."""
    return [1 / film.settings.rate] * len(film.settings.moments)
