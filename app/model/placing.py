"""Move, scale and turn a picture; its handles are at shares of its width and height."""

from dataclasses import replace
from math import cos, remainder, sin, tau

import numpy as np

from app.model.point import Point
from starskel.arrays import Floats
from starskel.files.projects.picture import Picture


def place_on(picture: Picture, x: float, y: float) -> Point:
    """Give where a share of the width and of the height is: (0, 0) is the lower left corner."""
    at = picture.placement @ (x, 1 - y, 1)
    return float(at[0]), float(at[1])


def corners_of(picture: Picture) -> Floats:
    """Give the corners, (4, 2), counter-clockwise from the lower left one on."""
    return np.array([place_on(picture, x, y) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])


def holds(picture: Picture, point: Point) -> bool:
    """Tell whether a place is on a picture."""
    (x, y), (width, height) = _in_its_own(picture, point, picture.middle), picture.size
    return abs(x) <= width / 2 and abs(y) <= height / 2


def moved(picture: Picture, offset: Point) -> Picture:
    """Move a picture."""
    (x, y), (right, up) = picture.middle, offset
    return replace(picture, middle=(x + right, y + up))


def turned(picture: Picture, angle: float) -> Picture:
    """Turn a picture about its middle, counter-clockwise, in radians."""
    return replace(picture, rotation=remainder(picture.rotation + angle, tau))


def scaled(picture: Picture, factors: Point) -> Picture:
    """Scale a picture about its middle, along its own width and height."""
    (width, height), (across, upwards) = picture.size, factors
    return replace(picture, size=(width * across, height * upwards))


def stretched(picture: Picture, handle: Point, to: Point, least: float, *, free: bool = False) -> Picture:
    """Drag a corner or the middle of a side to a place; what is opposite stays.

    Parameters
    ----------
    picture : Picture
    handle : (float, float)
        Which one, as shares of the width and the height.
    to : (float, float)
    least : float
        No side becomes shorter.
    free : bool
        Whether a corner changes the proportions, too.
    """
    shares = np.array(handle)
    fixed, size = place_on(picture, *(1 - shares)), np.array(picture.size)
    ways = 2 * shares - 1  # from the middle on
    wanted = np.array(_in_its_own(picture, to, fixed)) * ways
    sides = ways != 0
    if sides.all() and not free:
        wanted = size * (wanted @ size) / (size @ size)
    grown = np.where(sides, np.maximum(wanted, least), size)
    if sides.all() and not free:
        grown = size * (grown / size).max()
    x, y = ways * grown / 2
    across, up = cos(picture.rotation), sin(picture.rotation)
    middle = fixed[0] + x * across - y * up, fixed[1] + x * up + y * across
    return replace(picture, middle=middle, size=(float(grown[0]), float(grown[1])))


def _in_its_own(picture: Picture, point: Point, origin: Point) -> Point:
    """Give a place along the width and the height of a picture, from an origin on."""
    x, y = point[0] - origin[0], point[1] - origin[1]
    across, up = cos(picture.rotation), sin(picture.rotation)
    return x * across + y * up, y * across - x * up
