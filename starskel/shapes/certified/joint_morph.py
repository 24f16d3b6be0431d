"""The last resort for shapes whose rings meet on the way: a morph in which nothing can meet.

Everything is put into a square that stays. Each ring bounds a region, with the rings right inside it for
holes, and so does the square: all these regions are cut along compatible bridges and into fans. Together they
are one triangulation of the square, the same before and after, which a convex combination morph never folds
(`starskel.blending.certified.morphing.convex_combination`): so neither outlines nor holes ever touch.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.blending.certified.keys import Chain, Key, chains_between
from starskel.blending.certified.morphing.convex_combination import convex_combination_of
from starskel.blending.certified.morphing.surroundings import (
    SQUARE,
    SquareMap,
    Surroundings,
    fans_put,
    joined,
)
from starskel.blending.certified.smoothing import retimed
from starskel.blending.meshes.fans import Fans, fans_of
from starskel.correspondence import Correspondence
from starskel.decomposition import decompose_quickly
from starskel.errors import Cancelled, StarskelError
from starskel.polar import as_complex, as_points, turn_of
from starskel.predicates import NEAR
from starskel.shapes.certified.joint_rings import JointRings
from starskel.shapes.holes.bridges import chain_of, halves
from starskel.task import Task

MARGINS = (1 / 32, 1 / 8, 1.0)
"""By how much a gap is widened, in time, before it is bridged; else it is the whole."""

LINKS = (32, 32)
"""How many links a morph has at first, over the whole time."""

_Part = tuple[Indices, Fans]
"""A simple polygon, as the rows of its outline, and its fans."""


@dataclass(frozen=True, eq=False)
class JointMorphing:
    """Bridges from one frame of all rings to another.

    Parts that meet at the ends cannot lie in one triangulation: they are morphed in different layers.

    Attributes
    ----------
    rings : JointRings
    """

    rings: JointRings

    def __call__(self, before: Key, after: Key, task: Task) -> Chain | None:
        """Give a chain of safe links from one key to another; None if there is none to be found."""
        layers = list(_layers(self.rings))
        morphs = []
        for number, layer in enumerate(layers):
            share = task.part(0.6 * number / len(layers), 0.6 * (number + 1) / len(layers))
            rows = np.concatenate([self.rings.rows_of(ring) for ring in layer])
            try:
                around = _surroundings(self.rings, layer, (before.frame, after.frame), share)
            except Cancelled:
                raise
            except StarskelError:
                return None
            morphs.append((rows, convex_combination_of(around, len(rows))))

        def guide(ts: Floats) -> Floats:
            frames = np.empty((len(ts), *before.frame.shape))
            for rows, morph in morphs:
                frames[:, rows] = morph.frames((ts - before.t) / (after.t - before.t), task)
            return frames

        chains = chains_between(
            (before, after), guide, self.rings.safe, task.part(0.6, 1), LINKS, self.rings.sound
        )
        if len(chains) > 1:
            return None
        return retimed([key.frame for key in chains[0]], np.array([key.t for key in chains[0]]))


def _layers(rings: JointRings) -> Iterator[list[int]]:
    """Give the rings by layers, the parts of each of which do not meet."""
    parts = dict.fromkeys(rings.part_of.tolist())
    while parts:
        layer: list[int] = []
        for part in parts:
            if not any((other, part) in rings.meeting for other in layer):
                layer.append(part)
        yield np.flatnonzero(np.isin(rings.part_of, layer)).tolist()
        for part in layer:
            del parts[part]


def _surroundings(
    rings: JointRings, layer: list[int], frames: tuple[Floats, Floats], task: Task
) -> Surroundings:
    """Triangulate the square with the rings of a layer in it, before and after.

    Raises
    ------
    StarskelError
        Where a region is too narrow for floating point.
    Cancelled
        If the task is told to stop.
    """
    rows = np.concatenate([rings.rows_of(ring) for ring in layer])
    points = [as_complex(frame[rows]) for frame in frames]
    turn = _turn(*points)
    along = _lean(points[0])
    places = _place(points[0], along), _place(points[1], along + turn)
    squares = [place.centre + place.scale * SQUARE for place in places]
    regions, parts = list(_regions(rings, layer)), []
    for number, region in enumerate(regions):
        share = task.part(number / len(regions), (number + 1) / len(regions))
        both = [np.concatenate(side) for side in zip(points, squares, strict=True)]
        bends, cut = _cut(both, region, share)
        points = [np.concatenate(side) for side in zip(points, bends, strict=True)]
        parts += [(own, fans_put(fans, places)) for own, fans in cut]
    put = [np.concatenate([place.put(side), SQUARE]) for place, side in zip(places, points, strict=True)]
    return joined(put, parts, places, turn)


def _turn(before: Complex, after: Complex) -> float:
    """Give by how much points turn as a whole."""
    return turn_of(complex(np.vdot(before - before.mean(), after - after.mean())))


def _lean(points: Complex) -> float:
    """Give a direction that turns and is mirrored as points are: in which those far out lie, if in any."""
    around = points - points.mean()
    around /= np.abs(around).max()
    lean = complex((np.abs(around) ** 2 * around).mean())
    return float(np.angle(lean)) if abs(lean) > NEAR else 0.0


def _place(points: Complex, turn: float) -> SquareMap:
    centre = complex(points.mean())
    return SquareMap(centre, float(np.abs(points - centre).max()) * complex(np.exp(1j * turn)))


def _regions(rings: JointRings, layer: list[int]) -> Iterator[list[Indices]]:
    """Give for each region the rows of its outline and, clockwise, of its holes; the square's come last."""
    sizes = [len(rings.rows_of(ring)) for ring in layer]
    own = np.split(np.arange(sum(sizes)), np.cumsum(sizes)[:-1])
    around = [
        rows[::-1] if turned else rows for rows, turned in zip(own, rings.clockwise[layer], strict=True)
    ]
    nested = rings.nested[np.ix_(layer, layer)]
    depth = nested.sum(axis=1)
    for number, outline in enumerate(around):
        within = np.flatnonzero(nested[:, number] & (depth == depth[number] + 1))
        yield [outline, *(around[k][::-1] for k in within.tolist())]
    square = np.arange(-len(SQUARE), 0)  # behind all points, however many there will be
    yield [square, *(around[k][::-1] for k in np.flatnonzero(depth == 0).tolist())]


def _cut(both: list[Complex], region: list[Indices], task: Task) -> tuple[list[Complex], list[_Part]]:
    """Cut a region into simple polygons and these into fans; new points are the bends of bridges."""
    rows = np.concatenate(region)
    source, target = (as_points(side[rows]) for side in both)
    pair = _paired(source, target, [len(ring) for ring in region])
    if len(region) == 1:
        return [np.empty(0, dtype=np.complex128)] * 2, [
            (rows, fans_of(decompose_quickly(pair, task), task.quiet))
        ]
    chain = chain_of(pair, task.quiet)
    names = np.concatenate([rows, len(both[0]) - len(SQUARE) + np.arange(chain.bends.shape[1])])
    first, second = (np.concatenate(side) for side in zip((source, target), chain.bends, strict=True))
    parts = []
    for own in halves(pair, chain):
        half = _paired(first[own], second[own], [len(own)])
        parts.append((names[own], fans_of(decompose_quickly(half, task.quiet), task.quiet)))
    return [as_complex(side) for side in chain.bends], parts


def _paired(source: Floats, target: Floats, sizes: list[int]) -> Correspondence:
    own = np.arange(len(source))
    return Correspondence(source, target, (), own, own, tuple(np.cumsum([0, *sizes[:-1]]).tolist()))
