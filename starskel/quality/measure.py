"""Measuring a blend."""

from collections.abc import Iterator
from typing import overload

import numpy as np

from starskel.arguments import whole_number
from starskel.arrays import Floats
from starskel.blending.frames import Blend
from starskel.blending.pieces import PieceBlend
from starskel.clearance import clearance
from starskel.crossings import crossing_places
from starskel.errors import StarskelError
from starskel.outline import cross_themselves, edge_lengths, signed_areas
from starskel.quality.drift import angle_deviation, length_deviations, linear, roughness
from starskel.quality.inside import Distortion, Triangles
from starskel.quality.layers import in_layers
from starskel.quality.proof import proof
from starskel.quality.report import Crossing, Report
from starskel.quality.shape_report import ShapeReport, measure_shapes
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Progress, ShouldStop, Task

MOST_FRAMES = 100_000
"""So many frames of 100 vertices take a gigabyte while they are measured."""

_AT_ONCE = 1 << 15
"""So many points of frames are computed between two questions whether to stop."""


@overload
def measure(
    blend: Blend,
    frames: int = ...,
    *,
    progress: Progress | None = ...,
    should_stop: ShouldStop | None = ...,
) -> Report: ...


@overload
def measure(
    blend: ShapeBlend,
    frames: int = ...,
    *,
    progress: Progress | None = ...,
    should_stop: ShouldStop | None = ...,
) -> ShapeReport: ...


def measure(
    blend: Blend | ShapeBlend,
    frames: int = 101,
    *,
    progress: Progress | None = None,
    should_stop: ShouldStop | None = None,
) -> Report | ShapeReport:
    """Measure a blend at evenly spread times, both ends included.

    Parameters
    ----------
    blend : Blend or ShapeBlend
    frames : int
        How many times, from 2 to `MOST_FRAMES`.
    progress : callable, optional
        Called with the fraction done.
    should_stop : callable, optional
        Asked often whether to stop.

    Raises
    ------
    StarskelError
        If these are too few frames, too many or no whole number, or the blend is none.
    Cancelled
        If ``should_stop`` answered True.

    Examples
    --------
    >>> import starskel
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> report = starskel.measure(starskel.blend(square, kite, marks=[(0, 0)]))
    >>> report.simple, report.crossing_frames
    (True, ())
    """
    times = np.linspace(0, 1, whole_number(frames, "the number of frames", 2, MOST_FRAMES))
    task = Task(progress, should_stop)
    if isinstance(blend, ShapeBlend):
        return measure_shapes(blend, times, task)
    if not isinstance(blend, Blend):
        raise StarskelError(f"{type(blend).__name__} is no blend", "give what starskel.blend returns")
    return _measured(blend, times, task)


def _measured(blend: Blend, times: Floats, task: Task) -> Report:
    rings, inside = _looked_at(blend, times, task.part(0, 0.4))
    crossings, proven = _decided(blend, rings, times, task.part(0.4, 0.85))
    kept = None
    if proven and not crossings and blend.key_times is not None:
        kept = clearance(blend.frames(blend.key_times), task.part(0.85, 0.9))
    last = task.part(0.9, 1)
    last.reach(0)
    lengths = length_deviations(edge_lengths(rings), times)
    last.reach(0.3)
    angle = angle_deviation([rings], times)
    last.reach(0.7)
    rough = roughness(blend.rings, [rings])
    last.reach(1)
    areas = signed_areas(rings)
    return Report(
        times=times,
        crossings=crossings,
        proven=proven,
        areas=areas,
        perimeters=edge_lengths(rings).sum(axis=1),
        area_deviations=areas / linear(areas[0], areas[-1], times) - 1,
        length_deviations=lengths,
        angle_deviation=angle,
        negative_lengths=tuple(np.flatnonzero(blend.negative_lengths(times)).tolist()),
        roughness=rough,
        inside=inside,
        how=blend.how,
        clearance=kept,
    )


def _decided(blend: Blend, rings: Floats, times: Floats, task: Task) -> tuple[tuple[Crossing, ...], bool]:
    """Give the crossings in frames, or else the first between them, and whether that is known for all t."""
    crossings = _crossings(rings, times, task.part(0, 8 / 9))
    if crossings:
        return crossings, True
    proven, between = proof(blend, task.part(8 / 9, 1))
    return (() if between is None else (between,)), proven


def _looked_at(blend: Blend, times: Floats, task: Task) -> tuple[Floats, Distortion | None]:
    """Compute the frames, and with those of star pieces how the inside is distorted."""
    rings: list[Floats] = []
    logarithms: list[tuple[Floats, Floats]] = []
    triangles: Triangles | None = None
    if isinstance(blend, PieceBlend):
        triangles = Triangles(blend.decomposition, *blend.inside([0, 1]))
    for part in _handfuls(blend, times, task):
        if isinstance(blend, PieceBlend) and triangles is not None:
            points = blend.inside(part)
            logarithms.append(triangles.logarithms(points, part))
            rings.append(points[:, : len(blend.pair)])
        else:
            rings.append(blend.frames(part))
    if triangles is None:
        return np.concatenate(rings), None
    stretches, spreads = (np.concatenate(parts) for parts in zip(*logarithms, strict=True))
    return np.concatenate(rings), triangles.distortion(stretches, spreads)


def _handfuls(blend: Blend, times: Floats, task: Task) -> Iterator[Floats]:
    step = max(1, _AT_ONCE // len(blend.pair))
    for k in range(0, len(times), step):
        task.reach(k / len(times))
        yield times[k : k + step]


def _crossings(rings: Floats, times: Floats, task: Task) -> tuple[Crossing, ...]:
    step = max(1, _AT_ONCE // rings.shape[1])
    found: list[Crossing] = []
    for start in range(0, len(rings), step):
        for k in start + np.flatnonzero(cross_themselves(rings[start : start + step])):
            frame = task.part(k / len(rings), 1)
            frame.reach(0)
            places, natural = crossing_places(rings[k]), in_layers(rings[k], frame)
            found.append(Crossing(float(times[k]), int(k), places, natural))
    return tuple(found)
