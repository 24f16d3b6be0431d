"""Paths of SVG files as lines: curves and arcs are cut so finely that no chord leaves them by much."""

from collections.abc import Iterator
from math import acos, atan2, ceil, cos, pi, sin

import numpy as np
import svgelements

from starskel.arrays import Floats
from starskel.errors import told
from starskel.limits import RING_VERTICES, check_limit
from starskel.predicates import LARGEST
from starskel.reading.curves import flattened

_SAMPLES = np.linspace(0, 1, 9)
"""Where curves are looked at for how far they reach."""

_INNER = {svgelements.QuadraticBezier: ("control",), svgelements.CubicBezier: ("control1", "control2")}
"""What curves call the control points between their ends."""


class _Arc:
    """An arc of an ellipse, y up.

    Parameters
    ----------
    arc : svgelements.Arc
        In the file's coordinates, y down.
    """

    def __init__(self, arc: svgelements.Arc) -> None:
        self.start, self.end = _place(arc.start), _place(arc.end)
        self.centre, (x, y) = _place(arc.center), _place(arc.prx)
        self.turn = atan2(y - self.centre[1], x - self.centre[0])
        self.radii = float(arc.rx), float(arc.ry)
        self.sweep = -float(arc.sweep)

    def points(self, shares: Floats) -> Floats:
        """Give where these shares of the way end."""
        (x, y), (a, b) = np.subtract(self.start, self.centre), self.radii
        along, across = x * cos(self.turn) + y * sin(self.turn), y * cos(self.turn) - x * sin(self.turn)
        angles = atan2(across * a, along * b) + self.sweep * shares
        right, up = a * np.cos(angles), b * np.sin(angles)
        turned = [
            right * cos(self.turn) - up * sin(self.turn),
            right * sin(self.turn) + up * cos(self.turn),
        ]
        return np.stack(turned, axis=1) + self.centre

    def flattened(self, reach: float) -> Floats:
        """Give points behind its start; a chord over 2 a is off by r (1 - cos a)."""
        count = chords(abs(self.sweep), max(self.radii), reach)
        return np.concatenate([self.points(np.arange(1, count) / count), [self.end]])


_Segment = Floats | _Arc
"""The control points of a line or a Bezier curve, (2 to 4, 2), or an arc."""


def lines_of(path: svgelements.Path, tolerance: float) -> tuple[list[Floats], float]:
    """Give the subpaths as points, y up, and how far chords may be off; closed ones end where they begin.

    Subpaths beyond all numbers are left out.

    Parameters
    ----------
    path : svgelements.Path
    tolerance : float
        How far a chord may leave a curve, as a part of the longer side of the path's box.

    Raises
    ------
    InvalidFile
        If there are more points than a ring may have.
    """
    subpaths = [subpath for subpath in _subpaths(path) if _is_within_all_numbers(subpath)]
    reach = tolerance * _side([segment for subpath in subpaths for segment in subpath])
    lines = [_line(subpath, reach) for subpath in subpaths]
    check_limit(told("a path"), told("vertices"), sum(map(len, lines)), RING_VERTICES)
    return lines, reach


def chords(angle: float, radius: float, reach: float) -> int:
    """Give into how many chords an arc of a circle is cut so that none leaves it by more than `reach`."""
    if not 0 < reach < radius:
        return max(ceil(angle / (pi / 2)), 1)
    return max(ceil(angle / 2 / acos(1 - reach / radius)), 1)


def _subpaths(path: svgelements.Path) -> Iterator[list[_Segment]]:
    drawn: list[_Segment] = []
    for segment in path:
        if drawn and isinstance(segment, svgelements.Move):
            yield drawn
            drawn = []
        if isinstance(segment, svgelements.Move) or segment.start is None or segment.end is None:
            continue
        closes = isinstance(segment, svgelements.Close)
        if not closes or segment.start != segment.end:  # else it has no vertex of its own
            drawn.append(_segment(segment))
        if drawn and closes:
            yield drawn
            drawn = []
    if drawn:
        yield drawn


def _segment(segment: svgelements.PathSegment) -> _Segment:
    if isinstance(segment, svgelements.Arc) and segment.rx and segment.ry:
        return _Arc(segment)
    inner = (getattr(segment, name) for name in _INNER.get(type(segment), ()))
    return np.array([_place(point) for point in (segment.start, *inner, segment.end)])


def _is_within_all_numbers(segments: list[_Segment]) -> bool:
    arcs = [segment for segment in segments if isinstance(segment, _Arc)]
    places = [segment for segment in segments if not isinstance(segment, _Arc)]
    places += [np.array([arc.start, arc.end, arc.centre, arc.radii, (arc.turn, arc.sweep)]) for arc in arcs]
    return bool((np.abs(np.concatenate(places)) < LARGEST).all())


def _side(segments: list[_Segment]) -> float:
    """Give the longer side of their box."""
    curves = [segment for segment in segments if not isinstance(segment, _Arc)]
    places = [segment.points(_SAMPLES) for segment in segments if isinstance(segment, _Arc)]
    for count in {len(curve) for curve in curves}:
        same = np.stack([curve for curve in curves if len(curve) == count], axis=1)[:, :, None]
        while len(same) > 1:  # de Casteljau
            same = same[:-1] + (same[1:] - same[:-1]) * _SAMPLES[:, None]
        places.append(same.reshape(-1, 2))
    return float(np.ptp(np.concatenate(places), axis=0).max()) if places else 0.0


def _line(segments: list[_Segment], reach: float) -> Floats:
    first = segments[0]
    start = first.start if isinstance(first, _Arc) else first[0]
    rest = [
        segment.flattened(reach) if isinstance(segment, _Arc) else flattened(segment, reach)
        for segment in segments
    ]
    return np.concatenate([[start], *rest])


def _place(point: svgelements.Point) -> tuple[float, float]:
    return float(point.x), 0.0 - float(point.y)
