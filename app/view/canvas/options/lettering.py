"""Text as outlines."""

from collections.abc import Sequence

import numpy as np
import shapely
from PySide6.QtGui import QFont, QPainterPath

from app.tools.settings import Lettering
from starskel.arrays import Floats
from starskel.outline import signed_areas
from starskel.reading.curves import flattened

SIZE = 1000.0
"""Pixels for which the font is asked: so large that nothing is fitted to pixels."""

TOLERANCE = 0.002
"""How far the lines may leave the curves of the letters, as a part of the size of the text."""


def lettering(text: str, family: str) -> Lettering:
    """Give the rings of a text in a font, the largest one first; letters that overlap are one."""
    font = QFont(family)
    font.setPixelSize(round(SIZE))
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    path = QPainterPath()
    path.addText(0, 0, font, text)
    rings = [ring for ring in _rings(path) if len(ring) >= 3]
    whole = _filled(rings)
    parts = [
        part for part in shapely.get_parts(whole) if isinstance(part, shapely.Polygon) and not part.is_empty
    ]
    bounds = [ring for part in parts for ring in (part.exterior, *part.interiors)]
    bounds.sort(key=lambda ring: -shapely.Polygon(ring).area)
    return Lettering(tuple(shapely.get_coordinates(ring)[:-1] for ring in bounds))


def _filled(rings: Sequence[Floats]) -> shapely.Geometry:
    """Give what rings fill that run one way round outlines and the other way round holes, as in fonts."""
    found = shapely.Polygon()
    by_size = sorted(rings, key=lambda ring: -abs(float(signed_areas(ring))))
    for ring in by_size:
        area = shapely.make_valid(shapely.Polygon(ring))
        alike = signed_areas(ring) * signed_areas(by_size[0]) > 0
        found = shapely.union(found, area) if alike else shapely.difference(found, area)
    return found


def _rings(path: QPainterPath) -> list[Floats]:
    """Give the rings of a path as lines, for text of size 1, y up."""
    rings: list[list[Floats]] = []
    k = 0
    while k < path.elementCount():
        kind = path.elementAt(k).type
        if kind == QPainterPath.ElementType.MoveToElement:
            rings.append([_points(path, k, 1)])
        elif kind == QPainterPath.ElementType.LineToElement:
            rings[-1].append(_points(path, k, 1))
        else:
            rings[-1].append(flattened(np.concatenate([rings[-1][-1][-1:], _points(path, k, 3)]), TOLERANCE))
            k += 2
        k += 1
    return [np.concatenate(ring) for ring in rings]


def _points(path: QPainterPath, start: int, count: int) -> Floats:
    elements = [path.elementAt(k) for k in range(start, start + count)]
    return np.array([(element.x, -element.y) for element in elements]) / SIZE
