"""The similarity that best lays one ring on another, row on row: how a part turns, and where points go."""

from dataclasses import dataclass

import numpy as np

from starskel.blending.frames import row_masses
from starskel.correspondence import Correspondence
from starskel.decomposition.canonical import canonical
from starskel.polar import as_complex, turn_of


@dataclass(frozen=True)
class Similarity:
    """A motion and a scaling of the plane, points as complex numbers.

    Attributes
    ----------
    start, end : complex
        The middle of the source, and that of the target, where it goes.
    factor : complex
        Rotation and scale.
    """

    start: complex
    end: complex
    factor: complex

    def __call__(self, place: complex) -> complex:
        """Move a point."""
        return self.end + self.factor * (place - self.start)


def similarity_of(pair: Correspondence, backwards: bool = False) -> Similarity:
    """Give the best similarity from the source to the target, or the other way, by the edges' masses."""
    weights = row_masses(pair)
    first, second = as_complex(pair.source), as_complex(pair.target)
    if backwards:
        first, second = second, first
    start, end = complex(weights @ first), complex(weights @ second)
    first, second = first - start, second - end
    spread = float(weights @ np.abs(first) ** 2)
    return Similarity(start, end, complex(weights @ (first.conj() * second)) / spread)


def rotation_of(pair: Correspondence) -> float:
    """Give by how much the source turns to lie on the target, in [-pi, pi]; exchanged, it turns back."""
    if canonical(pair).swapped:
        return -turn_of(similarity_of(pair, backwards=True).factor)
    return turn_of(similarity_of(pair).factor)
