"""What is known of a blend of shapes after it was measured, and the measuring."""

from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np
import shapely

from starskel.arrays import Flags, Floats, ReadOnlyArrays
from starskel.outline import cross_themselves, edge_lengths, signed_areas
from starskel.quality.drift import angle_deviation, length_deviations, linear, roughness
from starskel.shapes.certified.blend import CertifiedShapeBlend
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Task

_VANISHED = 1e-9
"""Rings smaller than this part of the largest are a point."""


@dataclass(frozen=True, eq=False)
class ShapeReport(ReadOnlyArrays):
    """How good a blend of shapes is, at k times evenly spread over [0, 1].

    Attributes
    ----------
    times : (k,) array
    crosses : (k, rings) array of bool
        Which rings cross or touch themselves; those that are a point do not.
    strays : (k, rings) array of bool
        Which holes are not wholly inside their outline, or meet another hole of it.
    areas : (k,) array
        The areas of all parts, less their holes.
    area_deviations : (k,) array
        The area over the linear blend of the two areas, less 1.
    length_deviations : (k,) array
        How much edge lengths differ in sum from the linear blend of the lengths, as a part of the sum of
        these.
    angle_deviation : float
        As in `Report`, of all rings together; of a ring that is a point at one end the turning angles should
        stay as they are at the other.
    roughness : float
        As in `Report`, of the worst vertex of all.
    overlaps : (k,) array
        How much of the parts' area lies on other parts, as a part of the mean of the areas at the ends.
    proven : bool
        Whether `simple` is known for every t: of certified blends, and where a crossing was found.
    how : str or None
        How a certified blend came about, as `Way` says it; None for others.

    Examples
    --------
    >>> import starskel
    >>> frame = starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (6, 2), (6, 6), (2, 6)]])
    >>> square = starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)]])
    >>> report = starskel.measure(starskel.blend(frame, square))
    >>> report.simple, report.holes_inside, report.overlap
    (True, True, 0.0)
    """

    of: ClassVar[Literal["shape"]] = "shape"
    """What was blended, two shapes of several parts."""

    times: Floats
    crosses: Flags
    strays: Flags
    areas: Floats
    area_deviations: Floats
    length_deviations: Floats
    angle_deviation: float
    roughness: float
    overlaps: Floats
    proven: bool
    how: str | None = None

    @property
    def simple(self) -> bool:
        """Whether in all frames looked at no ring crosses itself and no hole strays."""
        return not self.crossing_frames

    @property
    def crossing_frames(self) -> tuple[int, ...]:
        """The frames in which a ring crosses itself or a hole strays, as indices into `times`."""
        return tuple(np.flatnonzero((self.crosses | self.strays).any(axis=1)).tolist())

    @property
    def crossing_times(self) -> tuple[float, ...]:
        """The times of these frames."""
        return tuple(self.times[list(self.crossing_frames)].tolist())

    @property
    def holes_inside(self) -> bool:
        """Whether no hole strays in any frame looked at."""
        return not self.strays.any()

    @property
    def area_deviation(self) -> float:
        """The largest magnitude of the area deviations."""
        return float(np.abs(self.area_deviations).max())

    @property
    def length_deviation(self) -> float:
        """The mean of the length deviations."""
        return float(self.length_deviations.mean())

    @property
    def overlap(self) -> float:
        """By how much parts overlap at most, beyond the larger overlap of both ends."""
        return float(max(0.0, self.overlaps.max() - max(self.overlaps[0], self.overlaps[-1])))


def measure_shapes(blend: ShapeBlend, times: Floats, task: Task) -> ShapeReport:
    """Measure a blend of shapes at k times, (k,)."""
    task.reach(0)
    rings = blend.rings(times)
    sizes = np.stack([np.ptp(ring, axis=1).max(axis=1) for ring in rings], axis=1)
    there = sizes > _VANISHED * sizes.max()
    crosses = np.stack([cross_themselves(ring) for ring in rings], axis=1) & there
    signs = np.where(np.array(blend.pair.outer) < 0, 1.0, -1.0)
    areas = np.stack([signed_areas(ring) for ring in rings], axis=1) @ signs
    strays, overlaps = np.zeros_like(crosses), np.zeros(len(times))
    for k in range(len(times)):
        task.reach(k / len(times))
        parts = _parts(blend, [ring[k] for ring in rings], there[k], strays[k])
        overlaps[k] = sum(part.area for part in parts) - shapely.union_all(parts).area
    whole = linear(areas[0], areas[-1], times)
    task.reach(1)
    lengths = length_deviations(np.concatenate([edge_lengths(ring) for ring in rings], axis=1), times)
    return ShapeReport(
        times=times,
        crosses=crosses,
        strays=strays,
        areas=areas,
        area_deviations=areas / whole - 1,
        length_deviations=lengths,
        angle_deviation=angle_deviation(rings, times),
        roughness=roughness(blend.rings, rings),
        overlaps=overlaps / whole.mean(),
        proven=isinstance(blend, CertifiedShapeBlend) or bool((crosses | strays).any()),
        how=blend.how,
    )


def _parts(blend: ShapeBlend, rings: list[Floats], there: Flags, strays: Flags) -> list[shapely.Geometry]:
    """Give the parts with an area as valid geometries, and note holes that are not inside them."""
    parts = []
    for outline, outer in enumerate(blend.pair.outer):
        if outer >= 0 or not there[outline]:
            continue
        left = shapely.make_valid(shapely.Polygon(rings[outline]))
        for hole in (k for k, owner in enumerate(blend.pair.outer) if owner == outline and there[k]):
            area = shapely.make_valid(shapely.Polygon(rings[hole]))
            strays[hole] = not shapely.contains_properly(left, area)
            left = shapely.difference(left, area)
        parts.append(left)
    return parts
