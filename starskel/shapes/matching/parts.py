"""From what was given to the correspondence of all parts, each with its holes."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import shapely

from starskel.arrays import Floats
from starskel.correspondence import Correspondence, match, suggest_marks
from starskel.correspondence.marks import Mark
from starskel.polar import as_complex, as_points
from starskel.polygon import Polygon
from starskel.shapes.correspondence import PartPair, ShapeCorrespondence, region_pair
from starskel.shapes.matching.given import Given
from starskel.shapes.matching.pairing import RingLink, turn_between
from starskel.shapes.matching.points import beside, carried, place_among, room_for, tiny_copy
from starskel.shapes.similarity import Similarity, similarity_of
from starskel.task import Task


def matched_shapes(given: Given, task: Task) -> ShapeCorrespondence:
    """Match part by part.

    Raises
    ------
    InvalidMarks
        Where marks, pairs or places contradict the shapes or each other.
    Cancelled
        If the task is told to stop.
    """
    parts: dict[RingLink, PartPair] = {}
    matching = _RingMatching(turn_between(*given.shapes, given.links), task)
    for link, (source, target) in given.outlines.items():
        if source is not None and target is not None:
            outline = matching(source, target, given.marks_of(link))
            parts[link] = _with_holes(given, link, outline, (source, target), matching)
    paired = list(parts.values())
    for link in sorted((link for link in given.outlines if link not in parts), key=_by_size(given)):
        parts[link] = _alone(given, link, paired, list(parts.values()))
    own = tuple(parts[link] for link in given.outlines)
    return ShapeCorrespondence(*given.shapes, given.links, own, given.marks)


def _with_holes(
    given: Given,
    link: RingLink,
    outline: Correspondence,
    pieces: tuple[Polygon, Polygon],
    matching: "_RingMatching",
) -> PartPair:
    holes = {hole: given.rings_of(hole) for hole in given.holes[link]}
    regions = [
        shapely.Polygon(
            piece.vertices, [ring.vertices for pair in holes.values() if (ring := pair[side]) is not None]
        )
        for side, piece in enumerate(pieces)
    ]
    rings, ends = [outline], [outline]
    for hole, (one, two) in holes.items():
        if one is not None and two is not None:
            rings.append(matching(one, two, given.marks_of(hole)))
            ends.append(rings[-1])
        elif (ring := one or two) is not None:
            side = 0 if one is None else 1  # where it is a point
            way = similarity_of(outline, backwards=side == 0)
            wished = carried(ring.vertices, way)
            place = room_for(given.places.get(hole), wished, regions[side], f"ring {hole[1 - side]}")
            copy = tiny_copy(ring.vertices, place, regions[side], way.factor)
            regions[side] = regions[side].difference(shapely.box(*_around(copy)))
            rings.append(beside(ring.vertices, copy, grows=side == 0))
            ends.append(beside(ring.vertices, np.array([place]), grows=side == 0))
    return _part((link, *holes), rings, ends)


@dataclass(frozen=True)
class _RingMatching:
    """Matches rings of shapes that turn as a whole: where a ring fits at several angles, that one counts."""

    turn: float
    task: Task

    def __call__(self, source: Polygon, target: Polygon, marks: tuple[Mark, ...]) -> Correspondence:
        if not marks and self.turn:
            back = np.exp(-1j * self.turn)
            turned = Polygon(as_points(as_complex(target.vertices) * back))
            found = suggest_marks(source, turned, should_stop=self.task.should_stop)
            marks = tuple((i, target.vertex_of(j)) for i, j in found)
        return match(source, target, marks, should_stop=self.task.should_stop)


def _part(links: tuple[RingLink, ...], rings: list[Correspondence], ends: list[Correspondence]) -> PartPair:
    true = region_pair(ends)
    return PartPair(links, region_pair(rings), np.stack([true.source, true.target]))


def _around(copy: Floats) -> list[float]:
    """Give the box of a copy, widened by its own size."""
    low, high = copy.min(axis=0), copy.max(axis=0)
    return [*(2 * low - high).tolist(), *(2 * high - low).tolist()]


def _by_size(given: Given) -> Callable[[RingLink], float]:
    """Tell large parts without a partner from small ones, which may lie in them."""
    return lambda link: -max(ring.area for ring in given.rings_of(link) if ring is not None)


def _alone(given: Given, link: RingLink, paired: list[PartPair], placed: list[PartPair]) -> PartPair:
    """Let a part shrink to a point, or grow from one, with all its holes, among parts already placed."""
    side = 0 if link[0] is None else 1  # where it is a point
    links = link, *given.holes[link]
    rings = [ring.vertices for own in links for ring in given.rings_of(own) if ring is not None]
    place = given.places.get(link)
    if place is None:
        wished = carried(rings[0], _way(rings[0], 1 - side, paired))
        place = place_among(rings[0], wished, [_moved(part, 1 - side) for part in placed])
    points = [beside(ring, np.array([place]), grows=side == 0) for ring in rings]
    return _part(links, points, points)


def _moved(part: PartPair, side: int) -> list[tuple[Floats, Floats]]:
    """Give the rings of a part at one end, and at the other."""
    return list(zip(part.rings(part.ends[side]), part.rings(part.ends[1 - side]), strict=True))


def _way(ring: Floats, side: int, paired: list[PartPair]) -> Similarity:
    """Give how the nearest part that has a partner moves; where there is none, nothing does."""
    if not paired:
        return Similarity(0j, 0j, 1 + 0j)
    own = shapely.Polygon(ring)

    def apart(part: PartPair) -> tuple[float, float]:
        other = shapely.Polygon(part.rings(part.ends[side])[0])
        return round(shapely.distance(own, other), 9), round(
            shapely.distance(own.centroid, other.centroid), 9
        )

    return similarity_of(min(paired, key=apart).pair, backwards=side == 1)
