"""A point of a shape: x right and y up, in the user's units."""

from starskel.arrays import Floats

Point = tuple[float, float]


def as_point(row: Floats) -> Point:
    """Give a row of an array as a point."""
    return float(row[0]), float(row[1])
