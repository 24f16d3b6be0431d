"""A quick blend of two outlines by their landmarks, to see what an alignment is worth.

The edges of both outlines and the diagonals of both triangulations turn and stretch evenly, each as it would
alone; the points that come nearest to all of them, in least squares, make the frames. It is the stitched
blend on whatever diagonals there are: no decomposition is needed, and none has to fit both shapes.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.correspondence.landmarks import Landmarks, points_along
from starskel.outline import cross_themselves, turning_angles
from starskel.polar import PolarVectors, as_points

_TIMES = np.arange(1, 8) / 8
_OUTLINE = 3.0
"""How much more an edge of the outline insists than a diagonal."""

_SHORTEST_VECTOR = 1e-3
"""Vectors insist on their relative change; those shorter than this, by the radius of gyration, no more."""

_DIGITS = 9
"""So many decimals of the way between two matches tell landmarks apart."""


@dataclass(frozen=True)
class Trial:
    """What the quick blend shows.

    Attributes
    ----------
    strain : float
        The work left in the vectors, which are not what each would be alone: the mean square of the miss, as
        a part of their lengths; 0 where all can have their way.
    crossings : float
        The part of the frames that cross themselves.
    """

    strain: float
    crossings: float

    @classmethod
    def of(cls, first: Landmarks, second: Landmarks, matches: tuple[Indices, Indices]) -> "Trial":
        """Blend two outlines whose landmarks correspond, in the order round both."""
        places, rows = _merged((first, second), matches)
        rings = [_along(outline, own, places) for outline, own in zip((first, second), matches, strict=True)]
        count = len(places)
        outline = np.stack([np.arange(count), (np.arange(count) + 1) % count], axis=1)
        across = [own[side.diagonals] for side, own in zip((first, second), rows, strict=True)]
        links = np.concatenate([outline, *across])
        vectors = _turning(rings, links)
        lengths = (vectors.source_lengths + vectors.target_lengths) / 2
        weights = (
            np.where(np.arange(len(links)) < count, _OUTLINE, 1.0)
            / np.maximum(lengths, _SHORTEST_VECTOR) ** 2
        )
        frames, squares = _fitted(vectors.at(_TIMES), links, weights, count)
        strain = float(squares.max() / (weights @ lengths**2))
        return cls(strain, float(cross_themselves(as_points(frames)).mean()))


def _merged(
    outlines: tuple[Landmarks, Landmarks], matches: tuple[Indices, Indices]
) -> tuple[Floats, tuple[Indices, Indices]]:
    """Give the places of all landmarks on the way from match to match, and the place of each of either's."""
    ways = [
        np.interp(_beyond(outline, own[0]), _ends(outline, own), np.arange(len(own) + 1))
        for outline, own in zip(outlines, matches, strict=True)
    ]
    places, inverse = np.unique(np.concatenate(ways).round(_DIGITS), return_inverse=True)
    return places, (inverse[: len(ways[0])], inverse[len(ways[0]) :])


def _along(outline: Landmarks, own: Indices, places: Floats) -> Complex:
    """Give the outline's points at places counted in matches."""
    beyond = np.interp(places, np.arange(len(own) + 1), _ends(outline, own))
    return points_along(outline.positions, outline.shares, beyond + outline.shares[own[0]])


def _beyond(outline: Landmarks, start: int) -> Floats:
    """Give how far the landmarks lie beyond one of them, as shares of the length."""
    return np.asarray((outline.shares - outline.shares[start]) % 1)


def _ends(outline: Landmarks, own: Indices) -> Floats:
    return np.append(_beyond(outline, own[0])[own], 1.0)


def _turning(rings: list[Complex], links: Indices) -> PolarVectors:
    """Give the links as vectors that turn: edges by the turning angles, diagonals like the edges near by."""
    count = len(rings[0])
    source, target = (ring[links[:, 1]] - ring[links[:, 0]] for ring in rings)
    bends = turning_angles(as_points(rings[1])) - turning_angles(as_points(rings[0]))
    bends[0] = np.angle(target[0] * np.conj(source[0]))
    edges = np.cumsum(bends)
    at_ends = (edges + np.roll(edges, 1)) / 2
    rotations = np.concatenate([edges, at_ends[links[count:]].mean(axis=1)])
    return PolarVectors.between(source, target, rotations)


def _fitted(wishes: Complex, links: Indices, weights: Floats, count: int) -> tuple[Complex, Floats]:
    """Give the points whose links come nearest to the wished vectors, (k, count), and how near, (k,)."""
    incidence = np.zeros((len(links), count))
    incidence[np.arange(len(links)), links[:, 0]] -= 1
    incidence[np.arange(len(links)), links[:, 1]] += 1
    normal = incidence.T @ (weights[:, None] * incidence) + 1.0  # the constant fixes where they lie
    right = (wishes * weights) @ incidence
    parts = np.linalg.solve(normal, np.concatenate([right.real, right.imag]).T).T
    points = parts[: len(wishes)] + 1j * parts[len(wishes) :]
    misses = np.abs(points[:, links[:, 1]] - points[:, links[:, 0]] - wishes) ** 2
    return np.asarray(points), np.asarray(misses @ weights)
