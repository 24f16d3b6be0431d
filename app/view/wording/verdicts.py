"""What a report says, in a few words and in many, and where over t its blend crosses itself."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, Union

import numpy as np
from PySide6.QtCore import QCoreApplication

from app.view.wording.words import figure
from starskel.sheet.words import crossing_words, kind_of, percent, spans

if TYPE_CHECKING:
    from starskel.quality import Report, ShapeReport

translate = QCoreApplication.translate

AnyReport: TypeAlias = Union["Report", "ShapeReport"]

HARDLY = 1e-6
"""Moments nearer to each other count as one."""

NOTABLE = 5e-3
"""What parts overlap by more is told above a frame, as a part of their area."""


def summaries(report: "AnyReport") -> tuple[str, ...]:
    """Give the verdict in a line that stands above a frame, and in shorter ones where there is less room."""
    area = figure(percent(report.area_deviation))
    kind = kind_of(report)
    if report.of == "shape" and kind == "simple" and report.overlap > NOTABLE:
        overlap = figure(percent(report.overlap))
        return (
            translate("Verdict", "simple, parts overlap by {p}, area {area}").format(p=overlap, area=area),
            translate("Verdict", "simple, parts overlap by {p}").format(p=overlap),
            translate("Verdict", "parts overlap"),
        )
    if kind == "simple":
        usual = translate("Verdict", "simple, area {area}").format(area=area)
        if not report.proven:
            return usual, translate("Verdict", "simple")
        proven = translate("Verdict", "proven simple, area {area}").format(area=area)
        return proven, usual, translate("Verdict", "proven simple"), translate("Verdict", "proven")
    if kind == "natural":
        return (
            translate("Verdict", "natural crossing, area {area}").format(area=area),
            translate("Verdict", "natural crossing"),
            translate("Verdict", "natural"),
        )
    first = figure(f"{report.crossing_times[0]:.2f}".removeprefix("0"))
    if report.of == "shape" and not report.crosses.any():
        return (
            translate("Verdict", "holes stray at t = {t}, area {area}").format(t=first, area=area),
            translate("Verdict", "holes stray at t = {t}").format(t=first),
            translate("Verdict", "holes stray"),
        )
    return (
        translate("Verdict", "crosses at t = {t}, area {area}").format(t=first, area=area),
        translate("Verdict", "crosses at t = {t}").format(t=first),
        translate("Verdict", "crosses"),
    )


def details(report: "AnyReport") -> str:
    """Give all figures, a line each."""
    drift = figure(percent(report.area_deviation)), figure(percent(report.length_deviation))
    angle = figure(f"{np.degrees(report.angle_deviation):.1f}")
    lines = [
        *(_shape_crossings(report) if report.of == "shape" else _crossings(report)),
        translate("Verdict", "Area drifts by up to {p}.").format(p=drift[0]),
        translate("Verdict", "Edge lengths drift by {p} on average.").format(p=drift[1]),
        translate("Verdict", "Turning angles drift by {a} degrees on average.").format(a=angle),
    ]
    if report.of != "shape" and report.negative_lengths:
        negative = figure(spans(report.times.tolist(), report.negative_lengths))
        lines.append(
            translate("Verdict", "Some edge has a negative length at t = {times}.").format(times=negative)
        )
    return "\n".join(lines)


def _shape_crossings(report: "ShapeReport") -> list[str]:
    times, crossing = report.times.tolist(), np.flatnonzero(report.crosses.any(axis=1)).tolist()
    straying = np.flatnonzero(report.strays.any(axis=1)).tolist()
    lines = [
        text.format(times=figure(spans(times, frames)))
        for text, frames in (
            (translate("Verdict", "Parts cross themselves at t = {times}."), crossing),
            (translate("Verdict", "Holes are not inside their part at t = {times}."), straying),
        )
        if frames
    ]
    if not lines and report.proven:
        lines.append(translate("Verdict", "No ring crosses itself or another one: proven for every t."))
        lines += _origin(report.how)
    elif not lines:
        lines.append(translate("Verdict", "No part crosses itself, and holes stay inside."))
    if report.overlap > HARDLY:
        overlap = figure(percent(report.overlap))
        lines.append(translate("Verdict", "Parts overlap by {p} more than at the ends.").format(p=overlap))
    return lines


def _crossings(report: "Report") -> list[str]:
    if report.simple:
        if report.proven:
            return [translate("Verdict", "Never crosses itself: proven for every t."), *_certificate(report)]
        return [translate("Verdict", "No frame crosses itself.")]
    lines = [
        translate("Verdict", "Crosses itself at t = {times}.").format(times=figure(crossing_words(report)))
    ]
    if report.natural:
        lines.append(translate("Verdict", "That is natural: the shape lies over itself in layers."))
    elif report.natural_frames:
        text = translate("Verdict", "Natural in {n} of {all} frames: the shape lies over itself in layers.")
        lines.append(text.format(n=len(report.natural_frames), all=len(report.crossing_frames)))
    return lines


def _certificate(report: "Report") -> list[str]:
    """Say how a certified blend came about, and how far vertices stay from edges."""
    lines = _origin(report.how)
    if report.clearance is not None:
        text = translate("Verdict", "Vertices stay {d} units or more away from other edges.")
        lines.append(text.format(d=figure(f"{report.clearance:.2g}")))
    return lines


def _origin(how: str | None) -> list[str]:
    """Say how a certified blend came about."""
    ways = {
        "as stitched": translate("Verdict", "These are the frames of the stitched blend."),
        "repaired": translate("Verdict", "Where the stitched blend crosses itself, it is repaired."),
        "convex morph": translate(
            "Verdict", "No near repair was found: a part of the time is a convex morph."
        ),
    }
    return [ways[how]] if how in ways else []


def crossing_rings(report: "AnyReport", t: float) -> frozenset[int]:
    """Give the rings that in the frame measured nearest to t cross themselves, or are holes astray."""
    frame = round(t * (len(report.times) - 1))
    if report.of == "shape":
        return frozenset(np.flatnonzero(report.crosses[frame] | report.strays[frame]).tolist())
    return frozenset([0] if report.crosses[frame] else [])


class Span(NamedTuple):
    """A stretch of t in which a blend crosses itself, from its first to its last such frame in a row."""

    start: float
    stop: float
    natural: bool


def crossing_spans(report: "AnyReport") -> list[Span]:
    """Give the stretches of crossing frames, naturally crossing ones apart from others."""
    if report.of == "shape":
        runs = _runs(report.crossing_frames)
        return [Span(float(report.times[run[0]]), float(report.times[run[-1]]), False) for run in runs]
    spans = [
        Span(float(report.times[run[0]]), float(report.times[run[-1]]), natural)
        for natural, frames in ((True, report.natural_frames), (False, report.harmful_frames))
        for run in _runs(frames)
    ]
    return sorted(spans) or [Span(each.t, each.t, each.natural) for each in report.crossings]


def _runs(frames: Sequence[int]) -> list[list[int]]:
    """Divide numbers into runs without a gap."""
    runs: list[list[int]] = []
    for frame in frames:
        if runs and frame == runs[-1][-1] + 1:
            runs[-1].append(frame)
        else:
            runs.append([frame])
    return runs


def next_crossing(reports: "Iterable[AnyReport]", t: float) -> float | None:
    """Give the next moment after t when one of the blends begins to cross itself, or else the first."""
    starts = sorted({span.start for report in reports for span in crossing_spans(report)})
    later = [start for start in starts if start > t + HARDLY]
    return next(iter([*later, *starts]), None)
