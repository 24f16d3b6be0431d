"""What is measured of a blend: does it cross itself, how far do area, lengths and angles drift."""

from dataclasses import dataclass

import numpy as np
import shapely

from starskel.blending.frames import Blend
from starskel.errors import StarskelError
from starskel.outline import Flags, cross_themselves, edge_lengths, signed_areas, turning_angles
from starskel.polygon import crossing_edges
from starskel.predicates import Floats


@dataclass(frozen=True, eq=False)
class Report:
    """How good a blend is, at k times evenly spread over [0, 1].

    Attributes
    ----------
    times : (k,) array
    crossings : (k,) array of bool
        Whether the frame crosses or touches itself.
    areas, perimeters : (k,) arrays
        In units of the shapes; the area is negative where a frame is turned inside out.
    area_deviations : (k,) array
        The area over the linear blend of the two areas, less 1.
    area_deviation : float
        The largest of their magnitudes.
    length_deviation : float
        The mean over the frames of how much edge lengths differ in sum from the linear blend of the
        lengths, as a part of the sum of these.
    angle_deviation : float
        The mean over the frames of how much turning angles differ from the linear blend of the angles, in
        radians, weighted by the adjacent edges' lengths.
    negative_lengths : tuple of int
        The frames in which the method had to give some edge a negative length.
    crossing_place : tuple of float or None
        Where the first crossing frame crosses itself.
    """

    times: Floats
    crossings: Flags
    areas: Floats
    perimeters: Floats
    area_deviations: Floats
    area_deviation: float
    length_deviation: float
    angle_deviation: float
    negative_lengths: tuple[int, ...]
    crossing_place: tuple[float, float] | None

    @property
    def simple(self) -> bool:
        """Whether no frame crosses itself."""
        return not self.crossings.any()

    @property
    def crossing_frames(self) -> tuple[int, ...]:
        """The frames that cross themselves, as indices into `times`."""
        return tuple(np.flatnonzero(self.crossings).tolist())

    @property
    def crossing_times(self) -> tuple[float, ...]:
        """The times of the frames that cross themselves."""
        return tuple(self.times[self.crossings].tolist())


def measure(blend: Blend, frames: int = 101) -> Report:
    """Measure a blend at evenly spread times, both ends included.

    Parameters
    ----------
    blend : Blend
    frames : int
        How many times, 2 or more.

    Raises
    ------
    StarskelError
        If there are fewer.
    """
    if frames < 2:
        raise StarskelError(f"{frames} frames cannot show a blend", "give at least 2")
    times = np.linspace(0, 1, frames)
    rings = blend.frames(times)
    crossings = cross_themselves(rings)
    areas, lengths = signed_areas(rings), edge_lengths(rings)
    expected_areas, expected_lengths = (
        linear(areas[0], areas[-1], times),
        linear(lengths[0], lengths[-1], times),
    )
    deviations = areas / expected_areas - 1
    return Report(
        times=times,
        crossings=crossings,
        areas=areas,
        perimeters=lengths.sum(axis=1),
        area_deviations=deviations,
        area_deviation=float(np.abs(deviations).max()),
        length_deviation=_length_deviation(lengths, expected_lengths),
        angle_deviation=_angle_deviation(turning_angles(rings), expected_lengths, times),
        negative_lengths=tuple(np.flatnonzero(blend.negative_lengths(times)).tolist()),
        crossing_place=_crossing_place(rings[crossings.argmax()]) if crossings.any() else None,
    )


def linear(start: Floats, end: Floats, times: Floats) -> Floats:
    """Blend values linearly: for start and end of shape (...) give (k, ...)."""
    t = times.reshape(-1, *[1] * np.ndim(start))
    return np.asarray((1 - t) * start + t * end)


def _length_deviation(lengths: Floats, expected: Floats) -> float:
    return float((np.abs(lengths - expected).sum(axis=1) / expected.sum(axis=1)).mean())


def _angle_deviation(angles: Floats, expected_lengths: Floats, times: Floats) -> float:
    differences = np.angle(np.exp(1j * (angles - linear(angles[0], angles[-1], times))))
    weights = expected_lengths + np.roll(expected_lengths, 1, axis=1)
    return float(((weights * np.abs(differences)).sum(axis=1) / weights.sum(axis=1)).mean())


def _crossing_place(ring: Floats) -> tuple[float, float] | None:
    """Give a point that two edges share which should not; None where that takes more than floats can tell."""
    pairs = crossing_edges(ring)
    if not len(pairs):
        return None
    edges = shapely.linestrings(np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)[pairs[0]])
    shared = shapely.get_coordinates(shapely.intersection(*edges))
    place = shared.mean(axis=0) if len(shared) else ring[pairs[0, 1]]
    return float(place[0]), float(place[1])
