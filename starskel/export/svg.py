"""SVG out: a drawing as one file, every number a plain coordinate (no transforms, no style sheets)."""

from base64 import b64encode
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from xml.sax.saxutils import escape, quoteattr

from starskel.arrays import Floats
from starskel.export.film import Film
from starskel.files.decimals import decimal
from starskel.files.raster_writing import png_of
from starskel.sheet.drawing import Area, Disc, Drawing, Group, Image, Item, Label, Line, Stroke
from starskel.task import Task

XLINK = "http://www.w3.org/1999/xlink"

FACE = "Helvetica, Arial, 'DejaVu Sans', sans-serif"


@dataclass(frozen=True)
class Element:
    """An element of the file.

    Attributes
    ----------
    tag : str
    attributes : dict of str to str
    text : str
        What it holds.
    inner : tuple of Element
        The elements in it.
    """

    tag: str
    attributes: dict[str, str] = field(default_factory=dict)
    text: str = ""
    inner: tuple["Element", ...] = ()

    def lines(self) -> Iterator[str]:
        """Give it as text, a line for each element."""
        attributes = "".join(f" {name}={_quoted(value)}" for name, value in self.attributes.items())
        if self.inner:
            yield f"<{self.tag}{attributes}>"
            for element in self.inner:
                yield from element.lines()
            if self.text:
                yield _text(self.text)
            yield f"</{self.tag}>"
        elif self.tag == "text" or self.text:
            yield f"<{self.tag}{attributes}>{_text(self.text)}</{self.tag}>"
        elif self.tag == "g":
            yield f"<g{attributes}>"
            yield "</g>"
        else:
            yield f"<{self.tag}{attributes}/>"


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give each drawing as a file."""
    for drawing in film.drawings(pictured=True):
        task.reach(0)
        yield svg_text(drawing).encode()


def svg_text(drawing: Drawing) -> str:
    """Give a drawing as SVG; y runs down there, so y is counted from the sheet's upper edge."""
    return document(drawing, elements(drawing))


def document(drawing: Drawing, inside: Sequence[Element]) -> str:
    """Give a whole file of the size of a drawing."""
    width, height = decimal(drawing.width), decimal(drawing.height)
    return "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}pt" height="{height}pt"'
            f' viewBox="0 0 {width} {height}">',
            f"<title>{_text(drawing.title)}</title>",
            *(line for element in inside for line in element.lines()),
            "</svg>\n",
        ]
    )


def elements(drawing: Drawing) -> tuple[Element, ...]:
    """Give what is drawn."""
    return tuple(_element(item, drawing.height) for item in drawing.items)


def _element(item: Item, height: float) -> Element:
    match item:
        case Group(name, items):
            return Element("g", {"id": name}, inner=tuple(_element(inner, height) for inner in items))
        case Area(ring, fill, stroke, holes):
            path = " ".join(f"{_path(points, height)} Z" for points in (ring, *holes))
            rule = {"fill-rule": "evenodd"} if holes else {}
            return Element("path", {"d": path, **rule, **_paint(fill, stroke)})
        case Line(points, stroke):
            return Element("path", {"d": _path(points, height), **_paint(None, stroke)})
        case Disc((x, y), radius, fill, stroke):
            place = {"cx": decimal(x), "cy": decimal(height - y), "r": decimal(radius)}
            return Element("circle", {**place, **_paint(fill, stroke)})
        case Label():
            return _label(item, height)
        case Image():
            return _image(item, height)


def _image(image: Image, height: float) -> Element:
    (left, bottom), (right, top) = image.box.tolist()
    place = {"x": left, "y": height - top, "width": right - left, "height": top - bottom}
    content = b64encode(png_of(image.pixels)).decode("ascii")
    link = {"xmlns:xlink": XLINK, "xlink:href": f"data:image/png;base64,{content}"}
    numbers = {name: decimal(value) for name, value in place.items()}
    return Element("image", {**numbers, "preserveAspectRatio": "none", **link})


def _path(points: Floats, height: float) -> str:
    places = [f"{decimal(x)} {decimal(height - y)}" for x, y in points.tolist()]
    return "M" + " L".join(places)


def _label(label: Label, height: float) -> Element:
    x, y = label.place
    place = {"x": decimal(x), "y": decimal(height - y), "text-anchor": label.anchor}
    face = {"font-family": FACE, "font-size": decimal(label.size)}
    weight = {"font-weight": "bold"} if label.bold else {}
    return Element("text", {**place, **face, **weight, "fill": label.colour}, label.text)


def _paint(fill: str | None, stroke: Stroke | None) -> dict[str, str]:
    paint = {"fill": fill or "none"}
    if stroke is None:
        return paint
    line = {"stroke": stroke.colour, "stroke-width": decimal(stroke.width)}
    return {**paint, **line, "stroke-linejoin": "round", "stroke-linecap": "round"}


def _quoted(value: str) -> str:
    return quoteattr(value) if any(letter in value for letter in '<>&"\n\t\r') else f'"{value}"'


def _text(text: str) -> str:
    """Give text as XML can hold it: without control characters."""
    return escape("".join(letter if letter.isprintable() else " " for letter in text))
