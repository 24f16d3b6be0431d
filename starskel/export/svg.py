"""SVG out: a drawing as one file, every number a plain coordinate (no transforms, no style sheets)."""

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from starskel.export.film import Film
from starskel.files.numbers import decimal
from starskel.predicates import Floats
from starskel.sheet.drawing import Area, Disc, Drawing, Group, Item, Label, Line, Stroke
from starskel.task import Task

FACE = "Helvetica, Arial, 'DejaVu Sans', sans-serif"


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give each drawing as a file."""
    for drawing in film.drawings():
        task.reach(0)
        yield svg_text(drawing).encode()


def svg_text(drawing: Drawing) -> str:
    """Give a drawing as SVG; y runs down there, so y is counted from the sheet's upper edge."""
    width, height = decimal(drawing.width), decimal(drawing.height)
    writer = _Writer(drawing.height)
    return "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}pt" height="{height}pt"'
            f' viewBox="0 0 {width} {height}">',
            f"<title>{_text(drawing.title)}</title>",
            *(line for item in drawing.items for line in writer.lines(item)),
            "</svg>\n",
        ]
    )


class _Writer:
    def __init__(self, height: float) -> None:
        self._height = height

    def lines(self, item: Item) -> list[str]:
        match item:
            case Group(name, items):
                inside = [line for inner in items for line in self.lines(inner)]
                return [f"<g id={quoteattr(name)}>", *inside, "</g>"]
            case Area(ring, fill, stroke, holes):
                path = " ".join(f"{self._path(points)} Z" for points in (ring, *holes))
                rule = ' fill-rule="evenodd"' if holes else ""
                return [f'<path d="{path}"{rule}{_paint(fill, stroke)}/>']
            case Line(points, stroke):
                return [f'<path d="{self._path(points)}"{_paint(None, stroke)}/>']
            case Disc((x, y), radius, fill, stroke):
                place = f'cx="{decimal(x)}" cy="{self._down(y)}" r="{decimal(radius)}"'
                return [f"<circle {place}{_paint(fill, stroke)}/>"]
            case Label():
                return [self._label(item)]

    def _down(self, y: float) -> str:
        return decimal(self._height - y)

    def _path(self, points: Floats) -> str:
        places = [f"{decimal(x)} {self._down(y)}" for x, y in points.tolist()]
        return "M" + " L".join(places)

    def _label(self, label: Label) -> str:
        x, y = label.place
        weight = ' font-weight="bold"' if label.bold else ""
        face = f'font-family="{FACE}" font-size="{decimal(label.size)}"{weight}'
        place = f'x="{decimal(x)}" y="{self._down(y)}" text-anchor="{label.anchor}"'
        return f'<text {place} {face} fill="{label.colour}">{_text(label.text)}</text>'


def _paint(fill: str | None, stroke: Stroke | None) -> str:
    paint = f' fill="{fill or "none"}"'
    if stroke is not None:
        paint += f' stroke="{stroke.colour}" stroke-width="{decimal(stroke.width)}" stroke-linejoin="round"'
        paint += ' stroke-linecap="round"'
    return paint


def _text(text: str) -> str:
    """Give text as XML can hold it: without control characters."""
    return escape("".join(letter if letter.isprintable() else " " for letter in text))
