"""Outlines from SVG and to SVG, as they go over the clipboard."""

import re
from collections.abc import Iterator
from xml.etree import ElementTree

import numpy as np

from app.model.curves import flattened
from app.model.svg_path import Curve, PathError, subpaths
from app.model.transforms import box_of
from starskel.errors import InvalidFile, told
from starskel.files.numbers import decimal
from starskel.predicates import Floats

TOLERANCE = 0.0005
"""How far lines may leave the curves of an outline, as a part of the larger side of its box."""

ASIDE = {"defs", "clipPath", "mask", "symbol", "marker", "pattern"}
"""What is in these is not drawn where it stands."""

_CALL = re.compile(r"(\w+)\s*\(([^)]*)\)")


def outline_svg(ring: Floats) -> str:
    """Give a ring as SVG of the same size; y runs down there."""
    box = box_of(ring)
    (width, height), (left, top) = box.size, (box.low[0], -box.high[1])
    places = " L".join(f"{decimal(x)} {decimal(-y)}" for x, y in ring.tolist())
    view = " ".join(map(decimal, (left, top, width, height)))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{decimal(width)}" height="{decimal(height)}"'
        f' viewBox="{view}"><path d="M{places} Z"/></svg>'
    )


def outlines_of(svg: str) -> tuple[Floats, ...]:
    """Give all outlines of a drawing, y up, the largest box first; curves become lines within `TOLERANCE`.

    Raises
    ------
    InvalidFile
        If it is damaged, or declares entities, which could make it swell without end.
    """
    if "<!ENTITY" in svg:
        raise InvalidFile(told("the SVG declares entities"), told("save it as plain SVG"))
    try:
        found = [_lines(path) for path in _paths(ElementTree.fromstring(svg), np.eye(3))]
    except (ElementTree.ParseError, PathError, ValueError) as error:
        raise InvalidFile(told("the SVG is damaged: {error}", error=error), told("copy it again")) from error
    rings = [ring for ring in found if len(ring) >= 3]
    return tuple(sorted(rings, key=lambda ring: -float(np.prod(np.ptp(ring, axis=0)))))


def _paths(element: ElementTree.Element, outer: Floats) -> Iterator[list[Floats]]:
    """Give the subpaths of an element and what is in it, each as curves of two or four points."""
    name = element.tag.rpartition("}")[2]
    if name in ASIDE:
        return
    matrix = outer @ _matrix(element.get("transform", ""))
    for path in subpaths(_data(element, name)):
        yield [_placed(curve, matrix) for curve in path]
    for child in element:
        yield from _paths(child, matrix)


def _data(element: ElementTree.Element, name: str) -> str:
    """Give a basic shape as path data (SVG 1.1, section 9)."""

    def number(key: str) -> float:
        return float(re.sub(r"[a-z%]+$", "", element.get(key, "0")))

    if name == "path":
        return element.get("d", "")
    if name in ("polygon", "polyline"):
        return "M" + element.get("points", "") if element.get("points", "").strip() else ""
    if name == "rect":
        width = number("width")
        return f"M{number('x')},{number('y')} h{width} v{number('height')} h{-width} z"
    if name in ("circle", "ellipse"):
        x, y = (number("r"),) * 2 if name == "circle" else (number("rx"), number("ry"))
        return f"M{number('cx') - x},{number('cy')} a{x},{y} 0 1 0 {2 * x},0 a{x},{y} 0 1 0 {-2 * x},0 z"
    return ""


def _placed(curve: Curve, matrix: Floats) -> Floats:
    points = np.array([(point.real, point.imag, 1.0) for point in curve])
    placed: Floats = (points @ matrix.T)[:, :2] * (1, -1)
    return placed


def _lines(path: list[Floats]) -> Floats:
    """Flatten a subpath to a ring in which no two points in a row are equal."""
    extent = float(np.ptp(np.concatenate(path), axis=0).max())
    if not extent:
        return path[0][:1]
    parts = [flattened(curve, TOLERANCE * extent) if len(curve) == 4 else curve[-1:] for curve in path]
    ring = np.concatenate([path[0][:1], *parts])
    repeated = (ring == np.roll(ring, 1, axis=0)).all(axis=1)
    distinct: Floats = ring[~repeated]
    return distinct


def _matrix(transform: str) -> Floats:
    """Give a list of transforms as one matrix (SVG 1.1, section 7.6)."""
    matrix = np.eye(3)
    for name, inside in _CALL.findall(transform):
        values = [float(value) for value in re.split(r"[\s,]+", inside.strip()) if value]
        matrix = matrix @ _one_matrix(name, values)
    return matrix


def _one_matrix(name: str, values: list[float]) -> Floats:
    result = np.eye(3)
    if name == "matrix":
        result[:2] = np.reshape(values, (3, 2)).T
    elif name == "translate":
        result[:2, 2] = (*values, 0.0)[:2]
    elif name == "scale":
        result[0, 0], result[1, 1] = values[0], values[-1]
    elif name == "rotate":
        angle = np.radians(values[0])
        result[:2, :2] = [(np.cos(angle), -np.sin(angle)), (np.sin(angle), np.cos(angle))]
        about = np.array(values[1:3]) if len(values) == 3 else np.zeros(2)
        result[:2, 2] = about - result[:2, :2] @ about
    elif name in ("skewX", "skewY"):
        result[(0, 1) if name == "skewX" else (1, 0)] = np.tan(np.radians(values[0]))
    else:
        raise ValueError(f"an unknown transform {name}")
    return result
