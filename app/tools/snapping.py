"""Snapping: vertices, edges, multiples of 15 degrees and a grid catch the pointer where it comes near."""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from math import atan2, cos, pi, sin

import numpy as np
import shapely

from app.model.document import Document
from app.model.marks import Side
from app.model.point import Point, as_point
from app.tools.pick import distance, nearest_on
from app.tools.refusal import Segment
from app.tools.settings import Snapping
from app.tools.tool import Catch, Pointer, ToolContext
from starskel.arrays import Floats

CATCH_REACH = 2 / 3
"""How near something must come to catch the pointer, as a part of how near counts as on it."""

STEP = pi / 12
"""The angles that edges are caught by are multiples of this one."""


@dataclass(frozen=True)
class SnapLine:
    """A line that may catch the pointer.

    Attributes
    ----------
    anchor : (float, float)
        A point of it.
    direction : (float, float)
        A unit vector.
    kind : str
        What it comes from, as in `Catch`.
    barred : float
        So far from the anchor it catches nothing: there an edge is, and a vertex on it would touch it.
    """

    anchor: Point
    direction: Point
    kind: str
    barred: float = 0.0

    def foot(self, at: Point) -> Point:
        """Give the nearest point of the line."""
        along = self.along(at)
        return self.anchor[0] + along * self.direction[0], self.anchor[1] + along * self.direction[1]

    def along(self, at: Point) -> float:
        """Give how far along the line a place is, from the anchor on."""
        x, y = at[0] - self.anchor[0], at[1] - self.anchor[1]
        return x * self.direction[0] + y * self.direction[1]

    def meets(self, other: "SnapLine") -> Point | None:
        """Give where two lines cross, None where they are parallel."""
        (a, b), (c, d) = self.direction, other.direction
        turn = a * d - b * c
        if abs(turn) < sin(STEP / 2):  # so flat a crossing is far from what the pointer is at
            return None
        x, y = other.anchor[0] - self.anchor[0], other.anchor[1] - self.anchor[1]
        along = (x * d - y * c) / turn
        return self.anchor[0] + along * a, self.anchor[1] + along * b


@dataclass(frozen=True, eq=False)
class SnapTargets:
    """What there is to be caught by.

    Attributes
    ----------
    points : (k, 2) array
        Places that may be met.
    beside : (k, 2) array
        Places whose height or side may be taken, though they may not be met.
    starts, ends : (k, 2) arrays
        Edges that may be met.
    lines : tuple of SnapLine
        Lines that lengthen edges.
    origins : tuple of points
        Where edges come from that may keep to multiples of 15 degrees.
    """

    points: Floats = field(default_factory=lambda: np.empty((0, 2)))
    beside: Floats = field(default_factory=lambda: np.empty((0, 2)))
    starts: Floats = field(default_factory=lambda: np.empty((0, 2)))
    ends: Floats = field(default_factory=lambda: np.empty((0, 2)))
    lines: tuple[SnapLine, ...] = ()
    origins: tuple[Point, ...] = ()


def targets_for_drawing(document: Document, side: Side, path: Sequence[Point] = ()) -> SnapTargets:
    """Give what catches a new vertex: all parts, that to be replaced among them, and the path so far."""
    rings = [document.vertices(side), *_others(document, side)]
    met = _met_by(rings)
    return replace(
        met, beside=np.concatenate([met.points, np.array(path).reshape(-1, 2)]), origins=tuple(path[-1:])
    )


def targets_for_moving(document: Document, side: Side, moving: Collection[int]) -> SnapTargets:
    """Give what catches vertices that are moved: the others, and if it is one, what is straight with it.

    Other parts may be met, but not those inside the part or around it: meeting them makes a part of a hole.
    """
    ring, others = document.vertices(side), _others(document, side)
    rest = np.delete(ring, sorted(moving), axis=0)
    met = _met_by([other for other in others if not _nested(ring, other)])
    targets = replace(met, beside=np.concatenate([rest, *others]))
    if len(moving) != 1 or len(ring) < 4:
        return targets
    (vertex,) = moving
    before2, before, after, after2 = (as_point(ring[(vertex + k) % len(ring)]) for k in (-2, -1, 1, 2))
    lines = (_line(before, after, 0), _line(before, before2), _line(after, after2))
    return replace(targets, lines=tuple(line for line in lines if line), origins=(before, after))


def _others(document: Document, side: Side) -> list[Floats]:
    """Give the rings of the parts that are shown beside the one worked on."""
    own = document.part(side)
    shown = enumerate(document.shape(side).parts)
    return [part.ring.vertices for number, part in shown if part.visible and number != own]


def _met_by(rings: Sequence[Floats]) -> SnapTargets:
    points = np.concatenate([np.empty((0, 2)), *rings])
    ends = [np.roll(ring, -1, axis=0) for ring in rings]
    return SnapTargets(points, starts=points, ends=np.concatenate([np.empty((0, 2)), *ends]))


def _nested(ring: Floats, other: Floats) -> bool:
    pairs = ((ring, other), (other, ring))
    return any(bool(shapely.contains_xy(shapely.Polygon(outer), *inner[0])) for inner, outer in pairs)


def begun_at(context: ToolContext, pointer: Pointer) -> Catch:
    """Give where a new shape would be begun; Shift means nothing yet."""
    targets = targets_for_drawing(context.document, pointer.side)
    return caught(replace(pointer, shift=False), context.settings.snapping, targets)


def caught(pointer: Pointer, snapping: Snapping, targets: SnapTargets) -> Catch:
    """Give the place that the pointer is caught by, or its own.

    With Shift it keeps to a multiple of 15 degrees, however far; suspended, nothing catches it.
    """
    if pointer.free:
        return Catch(pointer.at)
    if pointer.shift and targets.origins:
        ray = _ray(targets.origins[0], pointer.at)
        return _on((ray,), ray.foot(pointer.at))
    reach = pointer.radius * CATCH_REACH
    met = _met(pointer.at, snapping, targets, reach) or _on_lines(pointer.at, snapping, targets, reach)
    if met is None and snapping.grid:
        return Catch(_on_grid(pointer.at, snapping.spacing), "grid")
    return met or Catch(pointer.at)


def _met(at: Point, snapping: Snapping, targets: SnapTargets, reach: float) -> Catch | None:
    if not snapping.vertices or not len(targets.points):
        return None
    near = _nearest(targets.points, at)
    return Catch(near, "vertex") if distance(near, at) <= reach else None


def _on_lines(at: Point, snapping: Snapping, targets: SnapTargets, reach: float) -> Catch | None:
    """Give the nearest crossing of lines that are near, or else the nearest place on one of them."""
    lines = [line for line in _lines(at, snapping, targets) if _catches(line, at, reach)]
    crossings = [(pair, place) for pair in combinations(lines, 2) if (place := pair[0].meets(pair[1]))]
    within = [_on(*each) for each in crossings if distance(each[1], at) <= 1.5 * reach]
    within = within or [_on((line,), line.foot(at)) for line in lines]
    return min(within, key=lambda catch: distance(catch.at, at), default=None)


def _lines(at: Point, snapping: Snapping, targets: SnapTargets) -> Iterable[SnapLine]:
    if snapping.vertices and len(targets.beside):
        yield SnapLine(_nearest(targets.beside, at, (1, 0)), (0, 1), "aligned")
        yield SnapLine(_nearest(targets.beside, at, (0, 1)), (1, 0), "aligned")
    if snapping.edges and len(targets.starts):
        places = nearest_on(targets.starts, targets.ends, np.array(at))
        edge = int(np.hypot(*(places - at).T).argmin())
        line = _line(as_point(targets.starts[edge]), as_point(targets.ends[edge]), 0)
        if line is not None and 0 <= line.along(at) <= distance(line.anchor, as_point(targets.ends[edge])):
            yield line
    if snapping.edges:
        yield from targets.lines
    if snapping.angles:
        yield from (_ray(origin, at) for origin in targets.origins)


def _catches(line: SnapLine, at: Point, reach: float) -> bool:
    return distance(line.foot(at), at) <= reach and not 0 <= line.along(at) <= line.barred


def _on(lines: Sequence[SnapLine], place: Point) -> Catch:
    guides: tuple[Segment, ...] = tuple((line.anchor, place) for line in lines)
    return Catch(place, lines[0].kind, guides)


def _line(start: Point, end: Point, barred: float | None = None) -> SnapLine | None:
    """Give the line through two points; it catches beyond the start alone, unless told what is barred."""
    length = distance(start, end)
    if not length > 0:
        return None
    direction = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    return SnapLine(start, direction, "edge", length if barred is None else barred)


def _ray(origin: Point, at: Point) -> SnapLine:
    """Give the line from an origin at the multiple of 15 degrees next to a place."""
    angle = STEP * round(atan2(at[1] - origin[1], at[0] - origin[0]) / STEP)
    return SnapLine(origin, (cos(angle), sin(angle)), "angle")


def _nearest(points: Floats, at: Point, weights: Point = (1, 1)) -> Point:
    """Give the nearest point; where the weights leave several, the one of them that is nearest at all."""
    away = np.abs(points - at)
    first = np.hypot(*(away * weights).T)
    return as_point(points[np.lexsort((np.hypot(*away.T), first))[0]])


def _on_grid(at: Point, spacing: float) -> Point:
    return spacing * round(at[0] / spacing), spacing * round(at[1] / spacing)
