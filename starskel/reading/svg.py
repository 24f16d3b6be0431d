"""SVG in: every element that has an outline becomes a shape, curves as lines within a tolerance.

svgelements reads shapes, transforms, view boxes, units and style sheets, after defusedxml has refused files
that could swell without end. Elements that are filled give what is filled; those that are only stroked give
the outline of the stroke.
"""

import io
from collections.abc import Iterator
from math import acos, ceil
from xml.etree import ElementTree

import defusedxml
import defusedxml.ElementTree
import numpy as np
import shapely
import svgelements

from starskel.errors import InvalidFile, told
from starskel.predicates import Floats
from starskel.reading.curves import flattened
from starskel.reading.found import Found, Reading, uniquely_named
from starskel.reading.mending import Rule, check_crossings, shape_of_geometry, shape_of_rings
from starskel.reading.svg_limits import check_content, check_tree, tidy_styles
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
    notes = _notes(root)
    try:
        drawing = svgelements.SVG.parse(io.BytesIO(ElementTree.tostring(root)), reify=True)
        elements = [element for element in drawing.elements() if isinstance(element, svgelements.Shape)]
        with np.errstate(over="ignore", invalid="ignore"):  # what lies beyond all numbers is left out
            shapes = [
                found
                for number, element in enumerate(elements, 1)
                for found in _found(element, number, wanted.tolerance)
            ]
    except InvalidFile:
        raise
    except (ValueError, TypeError, AttributeError, LookupError, ArithmeticError, RecursionError) as error:
        raise InvalidFile(
            told("the SVG is damaged: {error}", error=error), told("save it as plain SVG")
        ) from error
    return Reading(uniquely_named(shapes), notes)


def _scanned(content: bytes) -> ElementTree.Element:
    """Give the file's tree without what is not drawn; symbols stand in a definition, where they are found."""
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
    check_tree(root)
    tidy_styles(root)
    definitions = ElementTree.Element(f"{_SPACE}defs")
    for parent in list(root.iter()):
        for child in list(parent):
            name = child.tag.removeprefix(_SPACE) if isinstance(child.tag, str) else ""
            if name in _ASIDE:
                parent.remove(child)
            elif name == "symbol":
                parent.remove(child)
                definitions.append(child)
    root.insert(0, definitions)
    return root


def _notes(root: ElementTree.Element) -> tuple[str, ...]:
    names = {element.tag.removeprefix(_SPACE) for element in root.iter() if isinstance(element.tag, str)}
    left_out = [words for name, words in _LEFT_OUT.items() if name in names]
    return tuple(told("{what} in the file were left out", what=what) for what in left_out)


def _found(element: svgelements.Shape, number: int, tolerance: float) -> Iterator[Found]:
    """Give what an element draws, where it draws anything."""
    filled, stroked = _painted(element.fill), _painted(element.stroke)
    if element.values.get("visibility") == "hidden" or not (filled or stroked):
        return
    path = svgelements.Path(element).reify()
    box = path.bbox()
    if box is None:
        return
    reach = tolerance * max(box[2] - box[0], box[3] - box[1])
    lines = [line for part in path.as_subpaths() if len(line := _line(svgelements.Path(part), reach)) > 1]
    made = _fill(element, lines) if filled else _stroke(element, lines, reach)
    if made is not None:
        tag = str(element.values.get("tag") or "path")
        yield Found(str(element.id or f"{tag} {number}"), *made)


def _fill(element: svgelements.Shape, lines: list[Floats]) -> tuple[Shape, tuple[str, ...]] | None:
    rule: Rule = "evenodd" if element.values.get("fill-rule") == "evenodd" else "nonzero"
    open_ends = any((line[0] != line[-1]).any() for line in lines)
    made = shape_of_rings(lines, rule)
    if made is None or not open_ends:
        return made
    return made[0], (told("an open path was closed"), *made[1])


def _stroke(
    element: svgelements.Shape, lines: list[Floats], reach: float
) -> tuple[Shape, tuple[str, ...]] | None:
    caps, joints = {"round": "round", "square": "square"}, {"round": "round", "bevel": "bevel"}
    width = float(element.stroke_width or 0)
    if not lines or width <= 0:
        return None
    check_crossings(lines)
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
    return shape_of_geometry(shapely.union_all(areas), [told("it is the outline of a stroke")])


def _curve(line: Floats) -> shapely.Geometry:
    closed = len(line) > 3 and bool((line[0] == line[-1]).all())
    return shapely.LinearRing(line) if closed else shapely.LineString(line)


def _quarter(radius: float, reach: float) -> int:
    """Give into how many chords a quarter of a circle is cut so that none leaves it by more than `reach`."""
    return min(_chords(np.pi / 2, radius, reach), _ARCS)


def _chords(angle: float, radius: float, reach: float) -> int:
    if not 0 < reach < radius:
        return max(ceil(angle / (np.pi / 2)), 1)
    return max(ceil(angle / 2 / acos(1 - reach / radius)), 1)


def _painted(paint: svgelements.Color | None) -> bool:
    return paint is not None and paint.value is not None and bool(paint.alpha)


def _line(path: svgelements.Path, reach: float) -> Floats:
    """Give a subpath as points, y up; the last is the first where it is closed."""
    points: list[Floats] = []
    for segment in path:
        if isinstance(segment, svgelements.Move):
            points = [np.array([_place(segment.end)])]
            continue
        if segment.start is None or segment.end is None:
            continue
        if isinstance(segment, svgelements.Close) and segment.start == segment.end:
            continue  # it is no vertex of its own
        is_arc = isinstance(segment, svgelements.Arc)
        points.append(_arc(segment, reach) if is_arc else flattened(_control(segment), reach))
    return np.concatenate(points) if points else np.empty((0, 2))


def _arc(arc: svgelements.Arc, reach: float) -> Floats:
    """Give points on an arc of an ellipse behind its start; a chord over 2 a is off by r (1 - cos a)."""
    radius = max(float(arc.rx), float(arc.ry))
    count = _chords(abs(float(arc.sweep)), radius, reach)
    points = [_place(arc.point(k / count)) for k in range(1, count)]
    return np.array([*points, _place(arc.end)])


def _control(curve: svgelements.PathSegment) -> Floats:
    inner = {
        svgelements.QuadraticBezier: lambda: [curve.control],
        svgelements.CubicBezier: lambda: [curve.control1, curve.control2],
    }.get(type(curve), list)()
    return np.array([_place(point) for point in (curve.start, *inner, curve.end)])


def _place(point: svgelements.Point) -> tuple[float, float]:
    return float(point.x), 0.0 - float(point.y)
