"""Settings: what is wanted of an export, whatever format it goes into."""

from dataclasses import dataclass, field

from starskel.arguments import whole_number
from starskel.blending.frames import checked_times
from starskel.errors import StarskelError
from starskel.export import bounds
from starskel.export.layouts import Layout
from starskel.sheet.keyframe import Shown
from starskel.sheet.style import Look


@dataclass(frozen=True)
class Settings:
    """What is wanted of an export.

    Attributes
    ----------
    layout : {"row", "sheet", "frames", "animation", "numbers"}
        All frames in a row, a row for each method with its verdict, a picture or page for each frame, one
        picture that moves, or the coordinates.
    times : tuple of float
        The moments of the frames, as shares of the whole way, in [0, 1]; an animation has all of them.
    eased : bool
        Whether the times run as they are played, with easing; else t itself is meant.
    look : Look
        Colours, outline, margins, size.
    shown : Shown
        What is to be seen on the frames besides.
    duration : float
        Seconds that an animation takes one way.
    returning : bool
        Whether an animation comes back again, the same way.
    rate : float
        Pictures for a second, in formats that are made of pictures.
    pixels : int or None
        The longer side of pictures that are made of pixels; None takes two for a point.
    tolerance : float
        In formats that move vertices straight between keys, how far one may stray from its path, as a part of
        the longer side of the box of all frames.

    Raises
    ------
    StarskelError
        If a number is out of its bounds, or there is no time to draw.

    Examples
    --------
    >>> from starskel.export.settings import Settings, even_times
    >>> from starskel.sheet.style import Look
    >>> Settings("row", even_times(3), look=Look(colours=("#204060",), paper="#ffffff")).times
    (0.0, 0.5, 1.0)
    >>> len(Settings("animation", duration=2, rate=30, returning=True).moments)
    118
    """

    layout: Layout
    times: tuple[float, ...] = field(default_factory=lambda: even_times(6))
    eased: bool = False
    look: Look = field(default_factory=Look)
    shown: Shown = field(default_factory=Shown)
    duration: float = 3.0
    returning: bool = False
    rate: float = 25.0
    pixels: int | None = None
    tolerance: float = 0.001

    def __post_init__(self) -> None:
        if not self.times:
            raise StarskelError("there is no time to draw", "give at least one, from 0 to 1")
        bounds.FRAMES.check(len(self.times))
        checked_times(self.times)
        bounds.DURATION.check(self.duration)
        bounds.RATE.check(self.rate)
        bounds.TOLERANCE.check(self.tolerance)
        if self.pixels is not None:
            bounds.PIXELS.check(self.pixels)
        _check_look(self.look)

    @property
    def moments(self) -> tuple[float, ...]:
        """The times of all pictures of an animation that is made of pictures, as shares of the way."""
        there = even_times(max(2, round(self.duration * self.rate)))
        return (*there, *there[-2:0:-1]) if self.returning else there


def even_times(count: int) -> tuple[float, ...]:
    """Give a `count` of moments from 0 to 1, evenly spread.

    Raises
    ------
    StarskelError
        If it is no whole number, fewer than 2, as both ends are among them, or more than the longest
        animation has.

    Examples
    --------
    >>> from starskel.export.settings import even_times
    >>> even_times(5)
    (0.0, 0.25, 0.5, 0.75, 1.0)
    """
    count = whole_number(count, "the count of moments", 2, int(bounds.DURATION.most * bounds.RATE.most))
    return tuple(k / (count - 1) for k in range(count))


def _check_look(look: Look) -> None:
    bounds.DISTANCE.check(look.gap)
    bounds.DISTANCE.check(look.margin)
    if look.size is not None:
        bounds.SIZE.check(look.size)
    if look.outline is not None:
        bounds.STROKE.check(look.outline.width)
