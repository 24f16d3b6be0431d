"""Move, scale, turn and mirror points; what they are moved about."""

from dataclasses import dataclass

import numpy as np

from app.model.point import Point
from starskel.arrays import Floats


@dataclass(frozen=True)
class Box:
    """An upright box.

    Attributes
    ----------
    low, high : (float, float)
        Its lower left and its upper right corner.
    """

    low: Point
    high: Point

    @property
    def middle(self) -> Point:
        """Where its diagonals meet."""
        return (self.low[0] + self.high[0]) / 2, (self.low[1] + self.high[1]) / 2

    @property
    def size(self) -> Point:
        """Its width and height."""
        return self.high[0] - self.low[0], self.high[1] - self.low[1]

    def at(self, x: float, y: float) -> Point:
        """Give the place at these parts of its width and height: (0, 0) is its lower left corner."""
        width, height = self.size
        return self.low[0] + x * width, self.low[1] + y * height

    def contains(self, point: Point) -> bool:
        return all(a <= p <= b for a, p, b in zip(self.low, point, self.high, strict=True))

    def meets(self, other: "Box") -> bool:
        """Tell whether the boxes have a place in common."""
        ends = zip(self.low, self.high, other.low, other.high, strict=True)
        return all(low <= end and start <= high for low, high, start, end in ends)

    def nearest(self, point: Point) -> Point:
        """Give the place in the box that is nearest to a point."""
        x, y = (min(max(p, a), b) for a, p, b in zip(self.low, point, self.high, strict=True))
        return x, y

    def wider(self, margin: float) -> "Box":
        """Give the box with so much more on each side."""
        (left, low), (right, high) = self.low, self.high
        return Box((left - margin, low - margin), (right + margin, high + margin))


def box_of(points: Floats) -> Box:
    """Give the smallest box around some points, (n, 2) with n > 0."""
    (left, low), (right, high) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return Box((left, low), (right, high))


def moved(points: Floats, offset: Point) -> Floats:
    """Give the points moved by an offset."""
    result: Floats = points + np.array(offset)
    return result


def scaled(points: Floats, about: Point, factors: Point) -> Floats:
    """Give the points scaled along x and y about a place that stays; -1 mirrors."""
    centre = np.array(about)
    result: Floats = centre + (points - centre) * factors
    return result


def turned(points: Floats, about: Point, angle: float) -> Floats:
    """Give the points turned about a place, counter-clockwise, in radians."""
    cosine, sine = np.cos(angle), np.sin(angle)
    centre = np.array(about)
    result: Floats = centre + (points - centre) @ np.array([(cosine, sine), (-sine, cosine)])
    return result
