"""SVG in: every element that has an outline becomes a shape, curves as lines within a tolerance.

svgelements reads shapes, transforms, view boxes, units and style sheets, after defusedxml has refused files
that could swell without end. Elements that are filled give what is filled; those that are only stroked give
the outline of the stroke.
"""

import io
from collections.abc import Iterator
from xml.etree import ElementTree

import defusedxml
import defusedxml.ElementTree
import numpy as np
import shapely
import svgelements

from starskel.arrays import Floats
from starskel.errors import InvalidFile, told
from starskel.limits import Tally
from starskel.reading.mending import Rule, check_crossings, shape_of_geometry, shape_of_rings
from starskel.reading.named_shape import NamedShape, Reading, uniquely_named
from starskel.reading.svg_limits import check_content, check_tree, tidy_styles, without_idle_attributes
from starskel.reading.svg_lines import chords, lines_of
from starskel.reading.wanted import Wanted
from starskel.shapes.shape import Shape

_SPACE = "{http://www.w3.org/2000/svg}"

_ASIDE = {"clipPath", "mask", "marker", "pattern", "metadata", "foreignObject"}
"""What is in these is not drawn where it stands."""

_LEFT_OUT = {"text": told("texts"), "image": told("pictures")}

_ARCS = 32
"""Parts that a round cap or joint of a stroke has for each quarter."""


def read(content: bytes, wanted: Wanted) -> Reading:
    """Give the shapes of an SVG file, in its pixels (96 an inch), y up.

    Raises
    ------
    InvalidFile
        If it is damaged, or declares entities, which could make it swell without end.
    """
    root = _scanned(content)
    notes, tally = _notes(root), Tally(told("the file"))
    _tidy(root)
    try:
        drawing = svgelements.SVG.parse(io.BytesIO(ElementTree.tostring(root)), reify=True)
        elements = [element for element in drawing.elements() if isinstance(element, svgelements.Shape)]
        with np.errstate(over="ignore", invalid="ignore"):  # what lies beyond all numbers is left out
            shapes = [
                found
                for number, element in enumerate(elements, 1)
                for found in _found(element, number, wanted.tolerance, tally)
            ]
    except InvalidFile:
        raise
    except (ValueError, TypeError, AttributeError, LookupError, ArithmeticError, RecursionError) as error:
        raise InvalidFile(
            told("the SVG is damaged: {error}", error=error), told("save it as plain SVG")
        ) from error
    return Reading(uniquely_named(shapes), notes)


def _scanned(content: bytes) -> ElementTree.Element:
    """Give the file's tree."""
    try:
        check_content(content)
        root: ElementTree.Element = defusedxml.ElementTree.fromstring(content)
    except defusedxml.DefusedXmlException as error:
        raise InvalidFile(told("the SVG declares entities"), told("save it as plain SVG")) from error
    except InvalidFile:
        raise
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise InvalidFile(
            told("the SVG is damaged: {error}", error=error), told("take an undamaged copy")
        ) from error
    if root.tag.removeprefix(_SPACE) != "svg":
        raise InvalidFile(told("the file is no SVG"), told("save it as plain SVG"))
    return root


def _tidy(root: ElementTree.Element) -> None:
    """Leave what is drawn; symbols stand in a definition, where they are found.

    Raises
    ------
    InvalidFile
        If that is too much.
    """
    definitions = ElementTree.Element(f"{_SPACE}defs")
    for parent in list(root.iter()):
        names = [child.tag.removeprefix(_SPACE) if isinstance(child.tag, str) else "" for child in parent]
        definitions.extend(child for child, name in zip(parent, names, strict=True) if name == "symbol")
        parent[:] = [
            child
            for child, name in zip(parent, names, strict=True)
            if name not in {*_ASIDE, *_LEFT_OUT, "symbol"}
        ]
    root.insert(0, definitions)
    without_idle_attributes(root)
    check_tree(root)
    tidy_styles(root)


def _notes(root: ElementTree.Element) -> tuple[str, ...]:
    names = {element.tag.removeprefix(_SPACE) for element in root.iter() if isinstance(element.tag, str)}
    left_out = [words for name, words in _LEFT_OUT.items() if name in names]
    return tuple(told("{what} in the file were left out", what=what) for what in left_out)


def _found(element: svgelements.Shape, number: int, tolerance: float, tally: Tally) -> Iterator[NamedShape]:
    """Give what an element draws, where it draws anything."""
    filled, stroked = _painted(element.fill), _painted(element.stroke)
    if element.values.get("visibility") == "hidden" or not (filled or stroked):
        return
    path = svgelements.Path(element)
    if not path.transform.is_identity():  # of some elements it is left when the file is read
        path.reify()
    lines, reach = lines_of(path, tolerance)
    made = _fill(element, lines, tally) if filled else _stroke(element, lines, reach, tally)
    if made is not None:
        tag = str(element.values.get("tag") or "path")
        yield NamedShape(str(element.id or f"{tag} {number}"), *made)


def _fill(
    element: svgelements.Shape, lines: list[Floats], tally: Tally
) -> tuple[Shape, tuple[str, ...]] | None:
    rule: Rule = "evenodd" if element.values.get("fill-rule") == "evenodd" else "nonzero"
    open_ends = any((line[0] != line[-1]).any() for line in lines)
    made = shape_of_rings(lines, rule, tally)
    if made is None or not open_ends:
        return made
    return made[0], (told("an open path was closed"), *made[1])


def _stroke(
    element: svgelements.Shape, lines: list[Floats], reach: float, tally: Tally
) -> tuple[Shape, tuple[str, ...]] | None:
    caps, joints = {"round": "round", "square": "square"}, {"round": "round", "bevel": "bevel"}
    width = float(element.stroke_width or 0)
    if not lines or width <= 0:
        return None
    check_crossings(lines, tally)
    with np.errstate(divide="ignore", invalid="ignore"):  # GEOS divides by the length of dots
        areas = [
            shapely.buffer(
                _curve(line),
                width / 2,
                quad_segs=_quarter(width / 2, reach),
                cap_style=caps.get(str(element.values.get("stroke-linecap")), "flat"),
                join_style=joints.get(str(element.values.get("stroke-linejoin")), "mitre"),
            )
            for line in lines
        ]
    return shape_of_geometry(shapely.union_all(areas), tally, [told("it is the outline of a stroke")])


def _curve(line: Floats) -> shapely.Geometry:
    closed = len(line) > 3 and bool((line[0] == line[-1]).all())
    return shapely.LinearRing(line) if closed else shapely.LineString(line)


def _quarter(radius: float, reach: float) -> int:
    """Give into how many chords a quarter of a circle is cut so that none leaves it by more than `reach`."""
    return min(chords(np.pi / 2, radius, reach), _ARCS)


def _painted(paint: svgelements.Color | None) -> bool:
    return paint is not None and paint.value is not None and bool(paint.alpha)
