"""What a report says, in a few words and in many, and where over t its blend crosses itself."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from PySide6.QtCore import QCoreApplication

from app.view.words import figure
from starskel.sheet.words import crossing_words, percent, spans

if TYPE_CHECKING:
    from starskel.quality import Report

translate = QCoreApplication.translate

HARDLY = 1e-6
"""Moments nearer to each other count as one."""


def summaries(report: "Report") -> tuple[str, ...]:
    """Give the verdict in a line that stands above a frame, and in shorter ones where there is less room."""
    area = figure(percent(report.area_deviation))
    if report.simple:
        return (
            translate("Verdict", "simple, area {area}").format(area=area),
            translate("Verdict", "simple"),
        )
    if report.natural:
        return (
            translate("Verdict", "natural crossing, area {area}").format(area=area),
            translate("Verdict", "natural crossing"),
            translate("Verdict", "natural"),
        )
    first = figure(f"{report.crossing_times[0]:.2f}".removeprefix("0"))
    return (
        translate("Verdict", "crosses at t = {t}, area {area}").format(t=first, area=area),
        translate("Verdict", "crosses at t = {t}").format(t=first),
        translate("Verdict", "crosses"),
    )


def details(report: "Report") -> str:
    """Give all figures, a line each."""
    times = report.times.tolist()
    lines = [
        *_crossings(report),
        translate("Verdict", "Area drifts by up to {p}.").format(p=figure(percent(report.area_deviation))),
        translate("Verdict", "Edge lengths drift by {p} on average.").format(
            p=figure(percent(report.length_deviation))
        ),
        translate("Verdict", "Turning angles drift by {a} degrees on average.").format(
            a=figure(f"{np.degrees(report.angle_deviation):.1f}")
        ),
    ]
    if report.negative_lengths:
        negative = figure(spans(times, report.negative_lengths))
        lines.append(
            translate("Verdict", "Some edge has a negative length at t = {times}.").format(times=negative)
        )
    return "\n".join(lines)


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
    ways = {
        "as stitched": translate("Verdict", "These are the frames of the stitched blend."),
        "repaired": translate("Verdict", "Where the stitched blend crosses itself, it is repaired."),
        "convex morph": translate(
            "Verdict", "No near repair was found: a part of the time is a convex morph."
        ),
    }
    lines = [ways[report.how]] if report.how in ways else []
    if report.clearance is not None:
        text = translate("Verdict", "Vertices stay {d} units or more away from other edges.")
        lines.append(text.format(d=figure(f"{report.clearance:.2g}")))
    return lines


def crosses_at(report: "Report", t: float) -> bool:
    """Tell whether the frame that was measured nearest to t crosses itself."""
    return bool(report.crosses[round(t * (len(report.times) - 1))])


class Span(NamedTuple):
    """A stretch of t in which a blend crosses itself, from its first to its last such frame in a row."""

    start: float
    stop: float
    natural: bool


def crossing_spans(report: "Report") -> list[Span]:
    """Give the stretches of crossing frames, naturally crossing ones apart from others."""
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


def next_crossing(reports: "Iterable[Report]", t: float) -> float | None:
    """Give the next moment after t when one of the blends begins to cross itself, or else the first."""
    starts = sorted({span.start for report in reports for span in crossing_spans(report)})
    later = [start for start in starts if start > t + HARDLY]
    return next(iter([*later, *starts]), None)
