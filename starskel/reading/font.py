"""Fonts in: texts as the outlines of their letters, set as programs set them (TrueType, OpenType).

HarfBuzz chooses and places the letters, with kerning and ligatures, and tells their curves.
"""

import numpy as np
import uharfbuzz

from starskel.arrays import Floats
from starskel.errors import InvalidFile, told
from starskel.limits import Tally
from starskel.reading.curves import flattened
from starskel.reading.mending import shape_of_rings
from starskel.reading.named_shape import NamedShape, Reading, uniquely_named
from starskel.reading.wanted import Wanted
from starskel.shapes.shape import Shape

USUAL = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789&?!"
"""The letters that are given where no texts are asked for, as far as the font has them."""

_MOST = 100
"""Of a font that has none of these so many of its letters are given."""


def read(content: bytes, wanted: Wanted) -> Reading:
    """Give each text as a shape, in the font's units, the base line at y = 0.

    Raises
    ------
    InvalidFile
        If it is damaged or no font, or has no outline for a letter.
    """
    face = uharfbuzz.Face(uharfbuzz.Blob(content))
    known = set(face.unicodes) if face.glyph_count else set()
    if not known:
        raise InvalidFile(
            told("the font is damaged, or of a kind that is not known here"),
            told("give a TrueType or OpenType font"),
        )
    font = uharfbuzz.Font(face)
    usual = [letter for letter in USUAL if ord(letter) in known] or list(map(chr, sorted(known)))[:_MOST]
    for text in wanted.texts:
        _check(text, known)
    tally = Tally(told("the file"))
    made = [(text, _shape(font, text, wanted.tolerance, tally)) for text in wanted.texts or usual]
    empty = [text for text, shape in made if shape is None]
    notes = [told('"{text}" has no outline', text=text) for text in empty if wanted.texts]
    shapes = [NamedShape(text, *shape) for text, shape in made if shape is not None]
    return Reading(uniquely_named(shapes), tuple(notes))


def _check(text: str, known: set[int]) -> None:
    missing = next((letter for letter in text if ord(letter) not in known and not letter.isspace()), None)
    if missing is not None:
        raise InvalidFile(
            told('the font has no letter "{letter}"', letter=missing),
            told("leave it out, or take another font"),
        )
    if not text.strip():
        raise InvalidFile(told("a text is empty"), told("give at least one letter"))


def _shape(
    font: uharfbuzz.Font, text: str, tolerance: float, tally: Tally
) -> tuple[Shape, tuple[str, ...]] | None:
    rings = _rings(font, text)
    box = np.concatenate([np.empty((0, 2)), *(np.concatenate(ring) for ring in rings)])
    reach = tolerance * float(np.ptp(box, axis=0).max()) if len(box) else 0.0
    lines = [np.concatenate([flattened(curve, reach) for curve in ring]) for ring in rings]
    return shape_of_rings(lines, "nonzero", tally)


def _rings(font: uharfbuzz.Font, text: str) -> list[list[Floats]]:
    """Give the rings of a text, each as curves by their control points."""
    buffer = uharfbuzz.Buffer()
    buffer.add_str(text)
    buffer.guess_segment_properties()
    uharfbuzz.shape(font, buffer)
    rings: list[list[Floats]] = []
    at = np.zeros(2)
    for letter, place in zip(buffer.glyph_infos, buffer.glyph_positions, strict=True):
        drawn: list[list[Floats]] = []
        font.draw_glyph(letter.codepoint, _PEN, drawn)
        offset = at + np.array([place.x_offset, place.y_offset])
        rings += [[curve + offset for curve in ring[1:]] for ring in drawn if len(ring) > 1]
        at = at + np.array([place.x_advance, place.y_advance])
    return rings


def _begin(x: float, y: float, rings: list[list[Floats]]) -> None:
    rings.append([np.array([(x, y)])])


def _line(x: float, y: float, rings: list[list[Floats]]) -> None:
    _curve((x, y), rings=rings)


def _quadratic(a: float, b: float, x: float, y: float, rings: list[list[Floats]]) -> None:
    _curve((a, b), (x, y), rings=rings)


def _cubic(  # noqa: PLR0913, PLR0917 -- what HarfBuzz gives
    a: float, b: float, c: float, d: float, x: float, y: float, rings: list[list[Floats]]
) -> None:
    _curve((a, b), (c, d), (x, y), rings=rings)


def _curve(*places: tuple[float, float], rings: list[list[Floats]]) -> None:
    rings[-1].append(np.array([rings[-1][-1][-1], *places]))


_PEN = uharfbuzz.DrawFuncs()
_PEN.set_move_to_func(_begin)
_PEN.set_line_to_func(_line)
_PEN.set_quadratic_to_func(_quadratic)
_PEN.set_cubic_to_func(_cubic)
