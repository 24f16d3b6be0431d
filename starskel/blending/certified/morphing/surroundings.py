"""Both shapes in one square, inside and outside cut into the same triangles.

What lies between the ring and the square is cut along a passage into two simple polygons, the passage and
the rest. Like the inside they are pairs, and decomposed as such: the fans of all three are the triangles.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from starskel.arrays import Complex, Indices
from starskel.blending.certified.morphing.passage import Passage, passages
from starskel.blending.meshes.fans import Fans, fans_of
from starskel.correspondence import Correspondence
from starskel.decomposition import decompose_quickly
from starskel.decomposition.pieces import Decomposition
from starskel.errors import InvalidPolygon
from starskel.polar import as_complex, as_points
from starskel.polygon import Polygon
from starskel.task import Task

SQUARE = np.array([2 + 2j, -2 + 2j, -2 - 2j, 2 - 2j])
"""The square that both shapes are put into, round the unit circle; the passage ends between the first two."""

_TWIST = 16.0
"""What it costs to turn the shapes against each other by half a turn, in gates of a passage."""


@dataclass(frozen=True)
class SquareMap:
    """How a shape is put into the square: z becomes (z - centre) / scale."""

    centre: complex
    scale: complex

    def put(self, points: Complex) -> Complex:
        """Put (m,) complex points into the square."""
        return np.asarray((points - self.centre) / self.scale)


@dataclass(frozen=True, eq=False)
class Surroundings:
    """Corresponding triangulations of the square, with both rings in it.

    Attributes
    ----------
    source, target : (m,) complex arrays
        The points: the ring, and last the square's corners; between them what else there is.
    triangles : (k, 3) array of int
        Corners, counter-clockwise.
    places : tuple of SquareMap
        How source and target were put into the square.
    turn : float
        By how much the target is turned against the source, whole turns considered.
    """

    source: Complex
    target: Complex
    triangles: Indices
    places: tuple[SquareMap, SquareMap]
    turn: float


def surroundings_of(decomposition: Decomposition, task: Task) -> Surroundings:
    """Triangulate inside and outside of both polygons in the same way.

    Passages are tried in turn, those first that cross few gates and turn the shapes little.

    Raises
    ------
    InvalidPolygon
        If no passage leaves pairs of simple polygons: what all are too narrow for is narrower than rounding.
    """
    pair = decomposition.pair
    for choice in _choices(pair, task):
        task.reach(0)
        try:
            return _triangulated(decomposition, choice, task)
        except InvalidPolygon as error:
            refused = error
    raise refused


class _Choice(NamedTuple):
    """An edge, the passages from it in source and target, and how they turn the shapes against each other."""

    edge: int
    ways: tuple[Passage, Passage]
    turn: float


def _choices(pair: Correspondence, task: Task) -> Iterator[_Choice]:
    """Give what passages there are, the easiest first."""
    source, target = (as_complex(ring) for ring in (pair.source, pair.target))
    best = np.angle(np.vdot(source - source.mean(), target - target.mean()))
    every = list(zip(passages(pair.source, task), passages(pair.target, task), strict=True))
    turns = np.angle([there.outwards(target) / here.outwards(source) for here, there in every])
    twists = np.angle(np.exp(1j * (turns - best)))
    gates = np.array([len(here.gates) + len(there.gates) for here, there in every])
    for edge in np.argsort(gates + _TWIST * np.abs(twists) / np.pi, kind="stable").tolist():
        yield _Choice(edge, every[edge], float(best + twists[edge]))


def _place(ring: Complex, way: Passage) -> SquareMap:
    """Put a ring into the unit circle so that the way out of the lid leads up."""
    centre = ring.mean()
    return SquareMap(complex(centre), way.outwards(ring) / 1j * float(np.abs(ring - centre).max()))


def _triangulated(decomposition: Decomposition, choice: _Choice, task: Task) -> Surroundings:
    edge, ways, turn = choice
    rings = as_complex(decomposition.pair.source), as_complex(decomposition.pair.target)
    n, count = len(rings[0]), max(len(way.gates) for way in ways)
    places = _place(rings[0], ways[0]), _place(rings[1], ways[1])
    both = [
        _outline(place.put(ring), edge, way, count)
        for place, ring, way in zip(places, rings, ways, strict=True)
    ]
    right, left = n + np.arange(count), n + count + np.arange(count)
    corners = n + 2 * count + np.arange(4)
    passage = [(edge + 1) % n, edge, *right, *corners[:2], *left[::-1]]
    rest = [*((edge - np.arange(n)) % n), *left, *corners[1:], corners[0], *right[::-1]]
    parts = [(np.array(part), _fans(both, np.array(part), task)) for part in (passage, rest)]
    inside = fans_of(decomposition, task)
    return joined(both, [(np.arange(n), fans_put(inside, places)), *parts], places, turn)


def _outline(ring: Complex, edge: int, way: Passage, count: int) -> Complex:
    """Give a ring in the square, so many bends on the right and as many on the left, the square."""
    bends = way.bends(ring)
    starts = ring[edge], ring[(edge + 1) % len(ring)]
    sides = []
    for side, start, corner in zip(bends, starts, SQUARE[:2], strict=True):
        last, more = (side[-1] if len(side) else start), count - len(side)
        sides += [side, last + (corner - last) * np.arange(1, more + 1) / (more + 1)]
    return np.concatenate([ring, *sides, SQUARE])


def _fans(both: list[Complex], part: Indices, task: Task) -> Fans:
    """Decompose a part of the outside.

    Raises
    ------
    InvalidPolygon
        If it is not simple, in source or target.
    """
    rings = []
    for points in both:
        task.reach(0)
        rings.append(Polygon(as_points(points[part])).vertices)
    source, target = rings
    own = np.arange(len(part))
    pair = Correspondence(source, target, (), own, own)
    return fans_of(decompose_quickly(pair, task.quiet), task)


def fans_put(fans: Fans, places: tuple[SquareMap, SquareMap]) -> Fans:
    """Put fans into the square."""
    source, target = (
        as_points(place.put(as_complex(side)))
        for place, side in zip(places, (fans.source, fans.target), strict=True)
    )
    return Fans(source, target, fans.triangles, fans.hubs)


def joined(
    both: list[Complex], parts: list[tuple[Indices, Fans]], places: tuple[SquareMap, SquareMap], turn: float
) -> Surroundings:
    """Join parts of the square, each the rows of its rings and its fans.

    Parameters
    ----------
    both : list of two (n,) complex arrays
        The rings' points in source and target, the square's corners behind them.
    parts : list of (rows, Fans)
        Of each part which of these points come first among those of the fans.
    places, turn
        As for `Surroundings`.
    """
    outline = len(both[0]) - len(SQUARE)
    inner = sum(len(fans.source) - len(rows) for rows, fans in parts)
    names = np.concatenate([np.arange(outline), outline + inner + np.arange(len(SQUARE))])
    points = [[side[:outline]] for side in both]
    triangles, count = [], outline
    for rows, fans in parts:
        own = count + np.arange(len(fans.source) - len(rows))
        count += len(own)
        for side, more in zip(points, (fans.source, fans.target), strict=True):
            side.append(as_complex(more[len(rows) :]))
        triangles.append(np.concatenate([names[rows], own])[fans.triangles])
    source, target = (np.concatenate([*side, SQUARE]) for side in points)
    return Surroundings(source, target, np.concatenate(triangles), places, turn)
