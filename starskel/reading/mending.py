"""From rings as files have them to shapes: crossing, touching and repeated points are mended, and told."""

import contextlib
from collections.abc import Sequence
from typing import Literal

import numpy as np
import shapely

from starskel.arrays import Floats, Indices
from starskel.crossings import edges_of_rings, near_edges, rings_meet
from starskel.errors import InvalidFile, InvalidPolygon, told
from starskel.files.shapes import check_edges
from starskel.limits import CROSSINGS, DRAWING_RINGS, OVERLAPS, RING_VERTICES, Tally, check_limit
from starskel.outline import signed_areas
from starskel.polygon import Polygon
from starskel.predicates import LARGEST
from starskel.shapes.shape import Shape

Rule = Literal["nonzero", "evenodd"]

_APART = (1e-6, 1e-5, 1e-4)
"""How far rings that touch are moved apart, as a part of the longer side of their box: the first to do."""

_SAME = 1e-7
"""Neighbours nearer than this part of the longer side of their ring's box are one vertex: files round."""

_AT_ONCE = 1_000_000
"""Edges times points that are looked at in one go."""

_BOXES = 1000
"""Boxes of rings for which others that overlap them are looked up in one go."""

_CRUMB = 1e-9
"""Faces smaller than this part of the square over the longer side of the box are left out."""


def shape_of_rings(rings: Sequence[Floats], rule: Rule, tally: Tally) -> tuple[Shape, tuple[str, ...]] | None:
    """Give what rings enclose by a rule for filling, and what was mended; None where that is nothing.

    Parameters
    ----------
    rings : sequence of (n, 2) arrays
        In any order, closed or open; by "nonzero" their direction matters.
    rule : {"nonzero", "evenodd"}
        Which points are inside: those that the rings wind round, or wind round an odd number of times.
    tally : Tally
        Of the file that they are from.

    Raises
    ------
    InvalidFile
        If there is too much in the file, or it cannot be mended.
    """
    repairs: list[str] = []
    kept = [cleaned for ring in rings if (cleaned := _cleaned(ring, repairs)) is not None]
    if not kept:
        return None
    _check_sizes(kept, tally)
    polygons = _polygons(kept)
    if polygons is None or rings_meet(kept):
        check_crossings(kept, tally)
        repairs.append(told("it crossed or touched itself and was cut there"))
        return shape_of_geometry(_filled(kept, rule), tally, repairs)
    if len(polygons) == 1:
        return Shape(polygons), tuple(repairs)
    parts = _parts(kept, rule, _near(kept, tally))
    return (Shape.of_parts(parts), tuple(repairs)) if parts else None


def shape_of_geometry(
    geometry: shapely.Geometry, tally: Tally, repairs: Sequence[str] = ()
) -> tuple[Shape, tuple[str, ...]] | None:
    """Give an area as a shape, and what was mended; None where it has no extent.

    Parameters
    ----------
    geometry : shapely.Geometry
        Of what is in it only polygons count.
    tally : Tally
        Of the file that it is from.
    repairs : sequence of str
        What was mended before.

    Raises
    ------
    InvalidFile
        As by `shape_of_rings`.
    """
    told_already = list(repairs)
    rings = [shapely.get_coordinates(ring)[:-1] for ring in _rings(geometry)]
    _check_sizes(rings, tally)
    if not shapely.is_valid(geometry):
        check_crossings(rings, tally)
        reason = shapely.is_valid_reason(geometry).replace("[", " at (").replace("]", ")")
        told_already.append(told("it was no proper area and was mended: {reason}", reason=reason))
        geometry = shapely.make_valid(geometry, method="structure")
    area = _area(geometry)
    if area.is_empty:
        return None
    low_x, low_y, high_x, high_y = area.bounds
    side = max(high_x - low_x, high_y - low_y)
    for apart in (0.0, *_APART):
        parted = _parted(area, apart * side) if apart else area
        if parted.is_empty:
            return None
        with contextlib.suppress(InvalidPolygon):
            moved = [told("parts of it touched and were moved apart")] if apart else []
            return Shape(parted), (*told_already, *moved)
    raise InvalidFile(told("a shape touches itself in too many places"), told("draw it with clearer gaps"))


def _check_sizes(rings: Sequence[Floats], tally: Tally) -> None:
    check_limit(told("a ring"), told("vertices"), max(map(len, rings), default=0), RING_VERTICES)
    tally.add(told("rings"), len(rings), DRAWING_RINGS)
    check_edges(rings, tally)


def _rings(geometry: shapely.Geometry) -> list[shapely.LinearRing]:
    return list(shapely.get_rings(shapely.get_parts(shapely.get_parts(geometry))))


def _parted(area: shapely.MultiPolygon, apart: float) -> shapely.MultiPolygon:
    """Draw the edge of an area inwards, and lay its vertices on a finer grid, where no two all but meet."""
    return _area(shapely.set_precision(area.buffer(-apart, join_style="mitre"), apart / 8))


def _cleaned(ring: Floats, repairs: list[str]) -> Floats | None:
    """Give a ring without repeated points; None where it encloses nothing."""
    given = np.asarray(ring, dtype=np.float64).reshape(-1, 2)
    if not (np.abs(given) < LARGEST).all():
        repairs.append(told("a part beyond all numbers was left out"))
        return None
    closed = len(given) > 1 and bool((given[0] == given[-1]).all())
    points = _distinct(given[:-1] if closed else given)
    if len(points) > 2 and (given[1:] == given[:-1]).all(axis=1).any():
        told_once = told("repeated vertices were left out")
        repairs += [] if told_once in repairs else [told_once]
    if len(points) < 3 or not np.isfinite(points).all() or not shapely.MultiPoint(points).convex_hull.area:
        repairs.append(told("a part without an area was left out"))
        return None
    return points


def _distinct(points: Floats) -> Floats:
    """Leave out vertices that are where the one before them is."""
    steps = points - np.roll(points, 1, axis=0)
    apart = np.hypot(steps[:, 0], steps[:, 1]) > _SAME * float(np.ptp(points, axis=0).max(initial=0.0))
    return np.asarray(points[apart])


def _polygons(rings: Sequence[Floats]) -> list[Polygon] | None:
    """Give the rings as polygons; None where one is none."""
    try:
        return [Polygon(ring) for ring in rings]
    except InvalidPolygon:
        return None


def _near(rings: Sequence[Floats], tally: Tally) -> Indices:
    """Give the pairs i > j of rings whose boxes overlap, (k, 2)."""
    boxes = shapely.box(*np.array([[*ring.min(axis=0), *ring.max(axis=0)] for ring in rings]).T)
    tree = shapely.STRtree(boxes)
    found = [np.empty((0, 2), dtype=np.intp)]
    for first in range(0, len(boxes), _BOXES):
        i, j = tree.query(boxes[first : first + _BOXES])
        found.append(np.stack([i + first, j], axis=1)[i + first > j])
        tally.add(told("overlapping parts"), len(found[-1]), OVERLAPS)
    pairs: Indices = np.concatenate(found)
    return pairs[np.lexsort(pairs.T[::-1])]


def check_crossings(rings: Sequence[Floats], tally: Tally) -> None:
    """Refuse tangles, which have as many crossings as their edges squared."""
    for block, meeting, _ in near_edges(*edges_of_rings(rings), "intersects"):
        others = max(0, len(meeting) - 3 * len(block))  # each meets itself and two neighbours
        tally.add(told("crossings"), others // 2, CROSSINGS)


def _parts(rings: Sequence[Floats], rule: Rule, near: Indices) -> list[tuple[Floats, list[Floats]]]:
    """Give what rings that are apart enclose: outlines, each with its holes."""
    winds = np.array([np.sign(signed_areas(ring)) for ring in rings])
    inside = np.zeros((len(rings), len(rings)), dtype=bool)
    own, other = np.concatenate([near, near[:, ::-1]]).T
    first, areas = np.array([ring[0] for ring in rings]), np.array([shapely.Polygon(ring) for ring in rings])
    inside[own, other] = shapely.contains_xy(areas[other], *first[own].T)
    before = _is_filled(inside @ winds, rule)
    within = _is_filled(inside @ winds + winds, rule)
    outlines = np.flatnonzero(within & ~before).tolist()
    holes = np.flatnonzero(before & ~within).tolist()
    sizes = np.where(within & ~before, shapely.area(areas), np.inf)
    inner: dict[int, list[Floats]] = {outline: [] for outline in outlines}
    for hole in holes:
        inner[int(np.where(inside[hole], sizes, np.inf).argmin())].append(rings[hole])
    return [(rings[outline], inner[outline]) for outline in outlines]


def _is_filled(winding: Floats, rule: Rule) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    return np.asarray(winding % 2 != 0 if rule == "evenodd" else winding != 0)


def _filled(rings: Sequence[Floats], rule: Rule) -> shapely.Geometry:
    """Give what rings that meet enclose: their faces, counting how often they wind round each."""
    lines = shapely.union_all([shapely.LinearRing(ring) for ring in rings])
    faces = np.array(shapely.get_parts(shapely.polygonize(shapely.get_parts(lines).tolist())))
    middles = shapely.get_coordinates(shapely.point_on_surface(faces))
    few = max(1, _AT_ONCE // max(map(len, rings)))
    blocks = np.split(middles, range(few, len(middles), few))
    winding = np.concatenate(
        [np.sum([_winding(ring, places) for ring in rings], axis=0) for places in blocks]
    )
    return shapely.union_all(faces[_is_filled(winding, rule)])


def _winding(ring: Floats, points: Floats) -> Floats:
    """Give how often a ring winds round each point: edges up less edges down across a ray to its right."""
    a, b = ring[:, None], np.roll(ring, -1, axis=0)[:, None]
    up = (a[..., 1] <= points[:, 1]) & (points[:, 1] < b[..., 1])
    down = (b[..., 1] <= points[:, 1]) & (points[:, 1] < a[..., 1])
    across = (b[..., 0] - a[..., 0]) * (points[:, 1] - a[..., 1])
    left = across - (points[:, 0] - a[..., 0]) * (b[..., 1] - a[..., 1])
    return np.asarray(((up & (left > 0)).astype(float) - (down & (left < 0))).sum(axis=0))


def _area(geometry: shapely.Geometry) -> shapely.MultiPolygon:
    """Give the polygons of a geometry, without crumbs that only rounding made."""
    parts = [part for part in shapely.get_parts(shapely.get_parts(geometry)) if part.geom_type == "Polygon"]
    if not parts:
        return shapely.MultiPolygon()
    low, high = np.array([part.bounds for part in parts]).reshape(-1, 2, 2).transpose(1, 0, 2)
    least = _CRUMB * float((high.max(axis=0) - low.min(axis=0)).max()) ** 2
    kept = [_without_crumbs(part, least) for part in parts if part.area > least]
    return shapely.MultiPolygon([part for part in kept if not part.is_empty])


def _without_crumbs(part: shapely.Polygon, least: float) -> shapely.Polygon:
    """Give a part without small holes and repeated vertices; an empty one where nothing is left."""
    holes = [hole for hole in part.interiors if shapely.Polygon(hole).area > least]
    rings = [_distinct(shapely.get_coordinates(ring)[:-1]) for ring in (part.exterior, *holes)]
    outline, *inner = [ring if len(ring) > 2 else None for ring in rings]
    return shapely.Polygon(
        outline, [ring for ring in inner if ring is not None] if outline is not None else None
    )
