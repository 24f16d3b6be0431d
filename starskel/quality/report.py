"""What is known of a blend after it was measured."""

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Literal

import numpy as np

from starskel.arrays import Flags, Floats, ReadOnlyArrays
from starskel.quality.inside import Distortion


@dataclass(frozen=True, eq=False)
class Crossing(ReadOnlyArrays):
    """A moment at which the outline crosses or touches itself.

    Attributes
    ----------
    t : float
    frame : int or None
        Which of the frames looked at it is; None for a moment between two of them.
    places : (k, 2) array
        Where edges meet that should not, a row for each two of them; none where the outline is only inside
        out, or meets itself for a single moment between frames.
    natural : bool
        Whether the outline still bounds a sheet, which lies in layers over itself; see
        `starskel.quality.layers`. Other crossings are harmful: something is twisted or inside out.
    """

    t: float
    frame: int | None
    places: Floats
    natural: bool


@dataclass(frozen=True, eq=False)
class Report(ReadOnlyArrays):
    """How good a blend is, at k times evenly spread over [0, 1].

    Attributes
    ----------
    times : (k,) array
    crossings : tuple of Crossing
        The frames that cross or touch themselves, in their order. Where none does, but the motion is even
        between keyframes and is found to cross, the moment between two frames when it begins to.
    proven : bool
        Whether `simple` is known for every t. It is where a crossing was found, and where all vertices move
        evenly between keyframes (`Blend.key_times`): that can be decided without sampling. Otherwise the
        frames at `times` were looked at, no others.
    areas, perimeters : (k,) arrays
        In units of the shapes; the area is negative where a frame is turned inside out.
    area_deviations : (k,) array
        The area over the linear blend of the two areas, less 1.
    length_deviations : (k,) array
        How much edge lengths differ in sum from the linear blend of the lengths, as a part of the sum of
        these.
    angle_deviation : float
        The mean over the frames of how much turning angles differ from the linear blend of the angles, in
        radians, weighted by the adjacent edges' lengths.
    negative_lengths : tuple of int
        The frames in which the method had to give some edge a negative length.
    roughness : float
        How far the worst vertex strays from an even motion within a fiftieth of the time: the largest
        distance between where it is and the middle of where it is 1/50 before and 1/50 after, over the
        longer side of the shapes' boxes. A jump by the whole size gives 0.5; half a turn round the middle
        gives 0.001. The times are fixed, so it does not depend on how many frames are looked at.
    inside : Distortion or None
        How the fans of the star pieces are distorted; None where the method has no pieces.
    how : str or None
        How the blend came about, where the method has several ways.
    clearance : float or None
        Where the blend is proven simple, the distance that every vertex keeps from all edges that it is no
        end of, at all times; a lower bound, short of the true distance by a tenth at most.

    Examples
    --------
    Half a turn by straight ways goes through a point:

    >>> import starskel
    >>> square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    >>> report = starskel.measure(starskel.blend(square, square, marks=[(0, 2)], method="vertex"))
    >>> report.simple, report.crossing_times
    (False, (0.5,))
    >>> report.area_deviation
    1.0
    """

    of: ClassVar[Literal["polygon"]] = "polygon"
    """What was blended, two polygons."""

    times: Floats
    crossings: tuple[Crossing, ...]
    proven: bool
    areas: Floats
    perimeters: Floats
    area_deviations: Floats
    length_deviations: Floats
    angle_deviation: float
    negative_lengths: tuple[int, ...]
    roughness: float
    inside: Distortion | None
    how: str | None = None
    clearance: float | None = None

    @property
    def simple(self) -> bool:
        """Whether the outline never crosses itself: at no t, or at none looked at, as `proven` says."""
        return not self.crossings

    @property
    def natural(self) -> bool:
        """Whether the outline crosses itself, but naturally wherever it was seen to."""
        return not self.simple and all(crossing.natural for crossing in self.crossings)

    @property
    def crossing_frames(self) -> tuple[int, ...]:
        """The frames that cross themselves, as indices into `times`."""
        return tuple(sorted(self.natural_frames + self.harmful_frames))

    @property
    def natural_frames(self) -> tuple[int, ...]:
        """Those of the crossing frames that bound a sheet in layers (paper, figure 11)."""
        return self._frames(natural=True)

    @property
    def harmful_frames(self) -> tuple[int, ...]:
        """The other crossing frames."""
        return self._frames(natural=False)

    @property
    def crossing_times(self) -> tuple[float, ...]:
        """The times of all crossings."""
        return tuple(crossing.t for crossing in self.crossings)

    @cached_property
    def crosses(self) -> Flags:
        """Whether each of the frames crosses itself, as a (k,) array."""
        flags = np.zeros(len(self.times), dtype=np.bool_)
        flags[list(self.crossing_frames)] = True
        return flags

    @property
    def area_deviation(self) -> float:
        """The largest magnitude of the area deviations."""
        return float(np.abs(self.area_deviations).max())

    @property
    def length_deviation(self) -> float:
        """The mean of the length deviations."""
        return float(self.length_deviations.mean())

    def _frames(self, natural: bool) -> tuple[int, ...]:
        return tuple(
            crossing.frame
            for crossing in self.crossings
            if crossing.frame is not None and crossing.natural == natural
        )
