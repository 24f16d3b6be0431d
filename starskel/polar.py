"""Vectors that turn: their polar coordinates in the source and in the target, interpolated linearly."""

from dataclasses import dataclass, replace

import numpy as np

from starskel.arrays import Complex, Floats, ReadOnlyArrays
from starskel.predicates import NEAR


def as_complex(points: Floats) -> Complex:
    """Give (..., 2) points as (...) complex numbers."""
    return np.asarray(points[..., 0] + 1j * points[..., 1])


def as_points(numbers: Complex) -> Floats:
    """Give (...) complex numbers as (..., 2) points."""
    return np.stack([numbers.real, numbers.imag], axis=-1)


def turn_of(factor: complex) -> float:
    """Give the angle of a rotation, in [-pi, pi]; half a turn always goes counter-clockwise."""
    turn = float(np.angle(factor))
    return turn + 2 * np.pi if turn < NEAR - np.pi else turn


@dataclass(frozen=True, eq=False)
class PolarVectors(ReadOnlyArrays):
    """Vectors by length and angle; each angle is one number that no multiple of 2 pi can be added to.

    Attributes
    ----------
    source_lengths, target_lengths : (m,) arrays
    angles : (m,) array
        The directions in the source.
    rotations : (m,) array
        By how much each vector turns on the way to the target, whole turns included.
    """

    source_lengths: Floats
    target_lengths: Floats
    angles: Floats
    rotations: Floats

    @classmethod
    def between(
        cls,
        source: Complex,
        target: Complex,
        rotations: Floats,
        lengths: tuple[Floats, Floats] | None = None,
        left: bool = True,
    ) -> "PolarVectors":
        """Give the vectors that turn by about these rotations.

        The rotations are corrected so that the vectors end in their exact directions; needless whole turns,
        those of the mean weighted by length, are taken away from all of them.

        Parameters
        ----------
        source, target : (m,) arrays
            The vectors, or only their directions.
        rotations : (m,) array
            By how much each turns, up to less than half a turn.
        lengths : two (m,) arrays, optional
            The lengths, where they are not those of the vectors given.
        left : bool
            Whether they go counter-clockwise where that mean is half a turn, which could be either way.
        """
        angles = np.angle(source)
        exact = np.angle(target) - angles
        turned = exact + 2 * np.pi * np.round((rotations - exact) / (2 * np.pi))
        start, end = (np.abs(source), np.abs(target)) if lengths is None else lengths
        weights = start / start.sum() + end / end.sum()
        mean = (weights @ turned) / weights.sum() / (2 * np.pi)
        turns = np.round(mean - NEAR if left else mean + NEAR)
        return cls(start, end, angles, turned - 2 * np.pi * turns)

    def turned(self, turns: int) -> "PolarVectors":
        """Let all vectors make so many whole turns more, counter-clockwise."""
        return replace(self, rotations=self.rotations + 2 * np.pi * turns)

    def directions(self, ts: Floats) -> Complex:
        """Give the unit vectors at each t, (k, m)."""
        return np.asarray(np.exp(1j * (self.angles + ts[:, None] * self.rotations)))

    def lengths(self, ts: Floats) -> Floats:
        """Give the lengths at each t, (k, m)."""
        t = ts[:, None]
        return np.asarray((1 - t) * self.source_lengths + t * self.target_lengths)

    def at(self, ts: Floats) -> Complex:
        """Give the vectors at each t, (k, m)."""
        return self.lengths(ts) * self.directions(ts)
