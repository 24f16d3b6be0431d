"""What was measured of a blend, in words."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal, NamedTuple

if TYPE_CHECKING:  # words do not need what measures
    from starskel.quality import Report, ShapeReport

Kind = Literal["simple", "natural", "harmful"]

_NO_OVERLAP = 0.0005
"""What would be told as 0.0 %."""


def kind_of(report: "Report | ShapeReport") -> Kind:
    """Say in a word how good a blend is; of several parts nobody looks whether crossings are natural."""
    if report.simple:
        return "simple"
    return "natural" if report.of == "polygon" and report.natural else "harmful"


def verdict(report: "Report | ShapeReport") -> str:
    """Say whether the blend is simple, or when it crosses itself or holes stray."""
    if report.simple:
        known = f"proven, {report.how}" if report.how else "simple, proven"
        return known if report.proven else "simple"
    if report.of == "shape":
        times = spans(report.times.tolist(), report.crossing_frames)
        return f"{'crosses' if report.crosses.any() else 'holes stray'} at t = {times}"
    if report.natural:
        return f"natural crossing at t = {crossing_words(report)}"
    natural = f", natural in {counted(len(report.natural_frames), 'frame')}" if report.natural_frames else ""
    return f"crosses at t = {crossing_words(report)}{natural}"


def counted(count: int, name: str) -> str:
    """Give a number with the name of what is counted: "1 frame", "2 frames"."""
    return f"{count} {name}{'' if count == 1 else 's'}"


def crossing_words(report: "Report") -> str:
    """Say when the blend crosses itself."""
    if report.crossing_frames:
        return spans(report.times.tolist(), report.crossing_frames)
    return ", ".join(f"{t:.4g}" for t in report.crossing_times)


def crossing_counts(report: "Report | ShapeReport") -> str:
    """Say in how many frames the blend crosses itself, naturally and otherwise, or that it never does."""
    if report.simple or not report.crossing_frames:
        return verdict(report)
    if report.of == "shape":
        return f"{len(report.crossing_frames)} harmful"
    kinds = ("natural", report.natural_frames), ("harmful", report.harmful_frames)
    return " ".join(f"{len(frames)} {kind}" for kind, frames in kinds if frames)


def figures(report: "Report | ShapeReport") -> tuple[str, ...]:
    """Say how far the blend drifts, and what else is to be known of it, a line each.

    Of polygons that is where some edge has a negative length, of shapes by how much parts come to overlap.
    """
    area = f"area drift {percent(report.area_deviation)}"
    if report.of == "shape":
        return (area, *overlap_words(report))
    lines = [area, f"length drift {percent(report.length_deviation)}"]
    if report.inside is not None:
        lines.append(f"inside stretched {percent(report.inside.stretch - 1)}")
    if report.negative_lengths:
        times = spans(report.times.tolist(), report.negative_lengths)
        lines.append(f"negative lengths at t = {times}")
    return tuple(lines)


class FinerWords(NamedTuple):
    """What else is measured, in words; of the inside "-" where it is not known, as of shapes."""

    angle: str
    stretch: str
    spread: str
    folded: str
    roughness: str


def finer_words(report: "Report | ShapeReport") -> FinerWords:
    """Say how far angles drift, how the inside is distorted, and how uneven the motion is."""
    inside = None if report.of == "shape" else report.inside
    return FinerWords(
        angle=f"{math.degrees(report.angle_deviation):.1f}°",
        stretch="-" if inside is None else percent(inside.stretch - 1),
        spread="-" if inside is None else percent(inside.spread - 1),
        folded="-" if inside is None else percent(inside.folded),
        roughness=f"{100 * report.roughness:.2f} %",
    )


def overlap_words(report: "Report | ShapeReport") -> tuple[str, ...]:
    """Say by how much parts come to overlap, if any do."""
    if report.of == "polygon" or report.overlap <= _NO_OVERLAP:
        return ()
    return (f"parts overlap by {percent(report.overlap)}",)


def spans(times: Sequence[float], frames: Sequence[int]) -> str:
    """Give the times of frames, those that follow each other as "from-until"; the first three such spans."""
    starts = [frame for frame in frames if frame - 1 not in frames]
    ends = [frame for frame in frames if frame + 1 not in frames]
    parts = [
        f"{times[start]:.3g}" if start == end else f"{times[start]:.3g}-{times[end]:.3g}"
        for start, end in zip(starts, ends, strict=True)
    ]
    return ", ".join(parts[:3]) + (", ..." if len(parts) > 3 else "")


def percent(part: float) -> str:
    """Give a part of the whole in percent, with two digits where it is small."""
    return f"{100 * part:.{1 if part < 0.0995 else 0}f} %"
