"""Cutting a polygon into as many pieces as it has partners, by straight cuts from edge to edge.

The partners are parted in two groups by a line across the direction in which they are spread most; the cut
runs about as that line does. Of all cuts the one is taken that best leaves each group its share of the area,
is short, and slants little. Both groups are cut further so.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
import shapely

from starskel.arrays import Floats, Indices
from starskel.errors import InvalidMarks, InvalidPolygon, told
from starskel.outline import signed_areas
from starskel.polygon import Polygon

TRIED = 49
"""So many parallel lines are tried."""

SLANTS = np.radians(np.arange(-165, 181, 15))
"""How far cuts slant against the line between the groups, counter-clockwise."""

SLANT_PRICE, LENGTH_PRICE = 0.1, 0.5
"""What a slant of one radian costs, and a cut as long as the polygon is large, in parts of the area."""


@dataclass(frozen=True)
class Partner:
    """What a piece is to become: a polygon; and those holes of the whole that have to be in the piece."""

    polygon: Polygon
    holes: tuple[Polygon, ...] = ()


def cut_between(whole: Polygon, holes: Sequence[Polygon], partners: Sequence[Partner]) -> list[Polygon]:
    """Cut a polygon, past its holes, into a piece for each partner, in their order.

    Raises
    ------
    InvalidMarks
        Where no straight cut passes the holes and leaves each where it belongs.
    """
    if len(partners) == 1:
        return [whole]
    areas = np.array([partner.polygon.area for partner in partners])
    middles = shapely.get_coordinates(
        shapely.centroid([shapely.Polygon(partner.polygon.vertices) for partner in partners])
    )
    direction = _spread(middles)
    order = np.argsort((middles @ direction).round(9), kind="stable").tolist()
    near = _nearer_half(areas[order])
    groups = [[partners[k] for k in order[:near]], [partners[k] for k in order[near:]]]
    found: list[Polygon] = []
    for group, piece in zip(groups, _cut(whole, holes, direction, groups), strict=True):
        found += cut_between(piece, [hole for hole in holes if _lies_in(hole, piece.vertices)], group)
    return [found[order.index(k)] for k in range(len(partners))]


def _lies_in(hole: Polygon, ring: Floats) -> bool:
    return bool(shapely.contains_xy(shapely.Polygon(ring), *hole.vertices[0]))


def _spread(middles: Floats) -> Floats:
    """Give the direction in which points are spread most, to the right or upwards."""
    _, _, directions = np.linalg.svd(middles - middles.mean(axis=0), full_matrices=False)
    direction = directions[0]
    return np.asarray(direction if (direction[0], direction[1]) > (0, 0) else -direction)


def _nearer_half(areas: Floats) -> int:
    """Give how many of the partners in order make up about half of the area."""
    shares = np.cumsum(areas)[:-1] / areas.sum()
    return 1 + int(np.abs(shares - 0.5).round(9).argmin())


def _cut(
    whole: Polygon, holes: Sequence[Polygon], direction: Floats, groups: Sequence[Sequence[Partner]]
) -> tuple[Polygon, Polygon]:
    """Give the pieces that the best cut leaves, for the group behind it and the one before it."""
    size = np.sqrt(whole.area)
    areas = [sum(partner.polygon.area for partner in group) for group in groups]
    belong = [[hole for partner in group for hole in partner.holes] for group in groups]
    best: tuple[float, tuple[Polygon, Polygon]] | None = None
    for slant, offset in _lines(whole, direction):
        for length, *rings in _chords(whole, holes, _slanted(direction, slant), offset):
            part = float(signed_areas(rings[0])) / whole.area - areas[0] / sum(areas)
            cost = round(abs(part) + LENGTH_PRICE * length / size + SLANT_PRICE * abs(slant), 9)
            if best is not None and best[0] <= cost:
                continue
            if all(_lies_in(hole, ring) for ring, own in zip(rings, belong, strict=True) for hole in own):
                with suppress(InvalidPolygon):  # a cut so near to a vertex that they are one
                    best = cost, (Polygon(rings[0]), Polygon(rings[1]))
    if best is None:
        raise InvalidMarks(
            told(
                "a part is to become several, but no straight cut leaves its holes whole"
                " and where they belong"
            ),
            told("pair it with one part, and let the others grow from points"),
        )
    return best[1]


def _lines(whole: Polygon, direction: Floats) -> Iterator[tuple[float, float]]:
    """Give the lines that are tried: how much they slant, and where they are along what they then cross."""
    for slant in SLANTS.tolist():
        along = whole.vertices @ _slanted(direction, slant)
        for offset in np.linspace(along.min(), along.max(), TRIED + 2)[1:-1].tolist():
            yield slant, offset


def _slanted(direction: Floats, angle: float) -> Floats:
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin], [sin, cos]]) @ direction


def _chords(
    whole: Polygon, holes: Sequence[Polygon], direction: Floats, offset: float
) -> list[tuple[float, Floats, Floats]]:
    """Give the cuts where a polygon is so far along a direction: length, and the rings behind and before.

    Lines through a vertex are left out.
    """
    ring = whole.vertices
    heights = ring @ direction - offset
    if (heights == 0).any():
        return []
    after = np.roll(heights, -1)
    crossed = np.flatnonzero(heights * after < 0)
    shares = heights[crossed] / (heights[crossed] - after[crossed])
    ends = ring[crossed] + shares[:, None] * (np.roll(ring, -1, axis=0)[crossed] - ring[crossed])
    order = np.argsort(ends @ np.array([-direction[1], direction[0]]), kind="stable")
    found = []
    for a, b in order.reshape(-1, 2).tolist():
        chord = shapely.LineString(ends[[a, b]])
        if not any(shapely.intersects(chord, shapely.Polygon(hole.vertices)) for hole in holes):
            one, two = _between(ring, crossed, ends, a, b), _between(ring, crossed, ends, b, a)
            comes_behind = heights[crossed[a]] > 0  # at a, where the first of these begins
            found.append((float(chord.length), *((one, two) if comes_behind else (two, one))))
    return found


def _between(ring: Floats, crossed: Indices, ends: Floats, start: int, end: int) -> Floats:
    """Give the ring along the outline from one end of a cut to the other."""
    rows = crossed[start] + 1 + np.arange((crossed[end] - crossed[start]) % len(ring))
    return np.concatenate([ends[[start]], ring[rows % len(ring)], ends[[end]]])
