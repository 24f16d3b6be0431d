"""PDF out: a page for each drawing.

ReportLab makes the document and knows how wide letters are; paths are written here, with more digits than it
gives them. No date goes in: equal drawings give equal files.
"""

import io
from collections.abc import Iterator, Sequence

from PIL import Image as Raster
from reportlab.lib.utils import ImageReader
from reportlab.pdfgen.canvas import Canvas

from starskel.arrays import Floats
from starskel.export.film import Film
from starskel.files.decimals import decimal
from starskel.sheet.drawing import Area, Disc, Drawing, Group, Image, Item, Label, Line, Stroke, channels
from starskel.task import Task

_QUARTER_HANDLE = 0.5522847498307936
"""Handles of this length, for a radius of 1, bend four Bezier curves to a circle within 0.03 %."""


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give all drawings as one file, a page for each."""
    task.reach(0)
    yield pdf_document(tuple(film.drawings(pictured=True)))


def pdf_document(pages: Sequence[Drawing]) -> bytes:
    """Give drawings as a document; every page has the size of its drawing."""
    stream = io.BytesIO()
    canvas = Canvas(stream, invariant=1, pageCompression=1)
    canvas.setTitle(pages[0].title)
    canvas.setCreator("starskel")
    for page in pages:
        canvas.setPageSize((page.width, page.height))
        canvas.addLiteral("1 j 1 J")
        _draw(canvas, page.items)
        canvas.showPage()
    canvas.save()
    return stream.getvalue()


def _draw(canvas: Canvas, items: Sequence[Item]) -> None:
    for item in items:
        match item:
            case Group(_, inner):
                _draw(canvas, inner)
            case Area(ring, fill, stroke, holes):
                path = [f"{_path(points)} h" for points in (ring, *holes)]
                canvas.addLiteral("\n".join([*_paint(fill, stroke), *path, _painted(fill, stroke, holes)]))
            case Line(points, stroke):
                canvas.addLiteral("\n".join([*_paint(None, stroke), _path(points), "S"]))
            case Disc((x, y), radius, fill, stroke):
                circle = _circle(x, y, radius)
                canvas.addLiteral("\n".join([*_paint(fill, stroke), circle, _painted(fill, stroke, ())]))
            case Label():
                _label(canvas, item)
            case Image(box):
                (left, bottom), (width, height) = box[0].tolist(), (box[1] - box[0]).tolist()
                picture = ImageReader(Raster.fromarray(item.pixels))
                canvas.drawImage(picture, left, bottom, width, height, mask="auto")


def _path(points: Floats) -> str:
    places = [f"{decimal(x)} {decimal(y)}" for x, y in points.tolist()]
    return f"{places[0]} m\n" + "\n".join(f"{place} l" for place in places[1:])


def _circle(x: float, y: float, radius: float) -> str:
    points = [complex(x, y) + radius * 1j**k for k in range(5)]
    tangents = [_QUARTER_HANDLE * radius * 1j ** (k + 1) for k in range(5)]
    curves = [(points[k] + tangents[k], points[k + 1] - tangents[k + 1], points[k + 1]) for k in range(4)]
    lines = [" ".join(f"{decimal(p.real)} {decimal(p.imag)}" for p in curve) + " c" for curve in curves]
    return "\n".join([f"{decimal(x + radius)} {decimal(y)} m", *lines, "h"])


def _paint(fill: str | None, stroke: Stroke | None) -> Iterator[str]:
    if fill is not None:
        yield f"{_colour(fill)} rg"
    if stroke is not None:
        yield f"{_colour(stroke.colour)} RG {decimal(stroke.width)} w"


def _painted(fill: str | None, stroke: Stroke | None, holes: Sequence[Floats]) -> str:
    if fill is None:
        return "n" if stroke is None else "S"
    return ("f" if stroke is None else "B") + ("*" if holes else "")


def _label(canvas: Canvas, label: Label) -> None:
    canvas.setFillColorRGB(*(channel / 255 for channel in channels(label.colour)))
    canvas.setFont("Helvetica-Bold" if label.bold else "Helvetica", label.size)
    draw = {"start": canvas.drawString, "middle": canvas.drawCentredString, "end": canvas.drawRightString}
    draw[label.anchor](*label.place, _printable(label.text))


def _printable(text: str) -> str:
    """Give what the standard faces have letters for; question marks stand for others."""
    known = "".join(letter if letter.isprintable() else " " for letter in text)
    return known.encode("cp1252", "replace").decode("cp1252")


def _colour(colour: str) -> str:
    return " ".join(decimal(channel / 255) for channel in channels(colour))
