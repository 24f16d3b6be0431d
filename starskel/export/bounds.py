"""Bounds: what numbers an export takes. They are far apart, and keep memory and time finite."""

from dataclasses import dataclass

from starskel.errors import StarskelError, told
from starskel.limits import PICTURE_SIDE


@dataclass(frozen=True)
class Bounds:
    """The bounds of a number.

    Attributes
    ----------
    what : str
        What it says.
    least, most : float
        Both are allowed.
    """

    what: str
    least: float
    most: float

    def check(self, value: float) -> None:
        """Refuse a number beyond them.

        Raises
        ------
        StarskelError
            Naming the number and the bounds.
        """
        if not self.least <= value <= self.most:
            raise StarskelError(
                told("{value:g} is no {what}", value=value, what=self.what),
                told("give one from {least:g} to {most:g}", least=self.least, most=self.most),
            )


FRAMES = Bounds(told("number of frames"), 1, 10_000)
DURATION = Bounds(told("number of seconds"), 0.01, 600)
RATE = Bounds(told("number of pictures a second"), 0.1, 120)
PIXELS = Bounds(told("number of pixels a side"), 1, PICTURE_SIDE)
TOLERANCE = Bounds(told("tolerance"), 1e-6, 1)
SIZE = Bounds(told("size in points"), 1, 10_000)
DISTANCE = Bounds(told("distance in points"), 0, 10_000)
STROKE = Bounds(told("width in points"), 0, 1_000)
