"""PostScript out, language level 2: one drawing as EPS, several as a document of one page each.

The structure comments follow Adobe's "Document Structuring Conventions Specification" and "Encapsulated
PostScript File Format Specification", both version 3.0. No date goes in: equal drawings give equal files.
"""

import math
import unicodedata
from collections.abc import Iterator, Sequence

from starskel.arrays import Floats
from starskel.export.film import Film
from starskel.files.decimals import decimal
from starskel.sheet.drawing import Area, Disc, Drawing, Group, Item, Label, Line, Stroke, channels
from starskel.task import Task

# The names stand in a dictionary of their own, so that they hide nothing of a page that includes the drawing.
_PROLOG = """\
%%BeginProlog
/starskel 20 dict def
starskel begin
/m /moveto load def
/l /lineto load def
/z /closepath load def
/disc { newpath 0 360 arc closepath } bind def
/filled { setrgbcolor gsave fill grestore } bind def
/eofilled { setrgbcolor gsave eofill grestore } bind def
/stroked { setrgbcolor setlinewidth stroke } bind def
/face { findfont exch scalefont setfont setrgbcolor moveto } bind def
/from-start { show } bind def
/from-middle { dup stringwidth pop -2 div 0 rmoveto show } bind def
/from-end { dup stringwidth pop neg 0 rmoveto show } bind def
/latin {
  findfont dup length dict begin
    { 1 index /FID eq { pop pop } { def } ifelse } forall
    /Encoding ISOLatin1Encoding def
    currentdict
  end definefont pop
} bind def
end
%%EndProlog"""

_SETUP = """\
%%IncludeResource: font Helvetica
%%IncludeResource: font Helvetica-Bold
starskel begin
/Plain /Helvetica latin
/Bold /Helvetica-Bold latin
end"""

_DASHES = dict.fromkeys(range(0x2010, 0x2016), "-")

_BEGIN = "starskel begin 1 setlinejoin 1 setlinecap"


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give all drawings as one file, a page for each."""
    task.reach(0)
    yield postscript_text(tuple(film.drawings())).encode("ascii")


def eps_text(drawing: Drawing) -> str:
    """Give a drawing as EPS."""
    return _join(
        "%!PS-Adobe-3.0 EPSF-3.0",
        *_header(drawing.title, drawing.width, drawing.height),
        "%%EndComments",
        _PROLOG,
        "%%BeginSetup",
        _SETUP,
        "%%EndSetup",
        _BEGIN,
        *_lines(drawing.items),
        "showpage end",
        "%%EOF",
    )


def postscript_text(pages: Sequence[Drawing]) -> str:
    """Give drawings as a document; every page is as large as the largest needs."""
    width, height = (max(getattr(page, side) for page in pages) for side in ("width", "height"))
    size = f"{decimal(width)} {decimal(height)}"
    return _join(
        "%!PS-Adobe-3.0",
        *_header(pages[0].title, width, height),
        f"%%Pages: {len(pages)}",
        "%%PageOrder: Ascend",
        f"%%DocumentMedia: Keyframe {size} 0 () ()",
        "%%EndComments",
        _PROLOG,
        "%%BeginSetup",
        _SETUP,
        f"<< /PageSize [{size}] >> setpagedevice",
        "%%EndSetup",
        *(line for number, page in enumerate(pages, 1) for line in _page(number, page)),
        "%%Trailer",
        "%%EOF",
    )


def _header(title: str, width: float, height: float) -> list[str]:
    return [
        f"%%BoundingBox: 0 0 {math.ceil(width)} {math.ceil(height)}",
        f"%%HiResBoundingBox: 0 0 {decimal(width)} {decimal(height)}",
        "%%Creator: starskel",
        f"%%Title: {_string(title[:60])}",
        "%%LanguageLevel: 2",
        "%%DocumentData: Clean7Bit",
        "%%DocumentNeededResources: font Helvetica",
        "%%+ font Helvetica-Bold",
    ]


def _page(number: int, page: Drawing) -> list[str]:
    return [
        f"%%Page: {number} {number}",
        f"%%PageBoundingBox: 0 0 {math.ceil(page.width)} {math.ceil(page.height)}",
        f"save {_BEGIN}",
        *_lines(page.items),
        "end restore showpage",
    ]


def _lines(items: Sequence[Item]) -> Iterator[str]:
    for item in items:
        match item:
            case Group(name, inner):
                yield f"% {_ascii(name)}"
                yield from _lines(inner)
            case Area(ring, fill, stroke, holes):
                yield "newpath"
                for points in (ring, *holes):
                    yield from _path(points)
                    yield "z"
                yield from _paint(fill, stroke, "eofilled" if holes else "filled")
            case Line(points, stroke):
                yield "newpath"
                yield from _path(points)
                yield from _paint(None, stroke)
            case Disc((x, y), radius, fill, stroke):
                yield f"{decimal(x)} {decimal(y)} {decimal(radius)} disc"
                yield from _paint(fill, stroke)
            case Label():
                yield _label(item)


def _path(points: Floats) -> Iterator[str]:
    for number, (x, y) in enumerate(points.tolist()):
        yield f"{decimal(x)} {decimal(y)} {'l' if number else 'm'}"


def _paint(fill: str | None, stroke: Stroke | None, filled: str = "filled") -> Iterator[str]:
    if fill is not None:
        yield f"{_colour(fill)} {filled}"
    if stroke is not None:
        yield f"{decimal(stroke.width)} {_colour(stroke.colour)} stroked"


def _label(label: Label) -> str:
    x, y = label.place
    face = "/Bold" if label.bold else "/Plain"
    place = f"{decimal(x)} {decimal(y)} {_colour(label.colour)} {decimal(label.size)}"
    return f"{_string(label.text)} {place} {face} face from-{label.anchor}"


def _colour(colour: str) -> str:
    return " ".join(decimal(channel / 255) for channel in channels(colour))


def _string(text: str) -> str:
    """Give a PostScript string; dashes become hyphens, other letters outside of Latin 1 question marks."""
    plain = unicodedata.normalize("NFC", text).translate(_DASHES)
    return "(" + "".join(map(_letter, plain.encode("latin-1", "replace"))) + ")"


def _letter(code: int) -> str:
    if code == ord("-"):
        return "\\255"  # ISOLatin1Encoding has the minus sign, which is wider, in the hyphen's place
    if code in b"()\\":
        return "\\" + chr(code)
    return chr(code) if 32 <= code < 127 else f"\\{code:03o}"


def _ascii(text: str) -> str:
    return "".join(letter if " " <= letter <= "~" else "?" for letter in text)


def _join(*lines: str) -> str:
    return "\n".join(lines) + "\n"
