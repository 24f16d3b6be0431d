"""What a report says, in a few words and in many, and where over t its blend crosses itself."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from starskel.quality import Report
from starskel.sheet.words import crossing_words, percent, spans

translate = QCoreApplication.translate


def summary(report: Report) -> str:
    """Give the verdict in one line that fits above a frame."""
    area = percent(report.area_deviation)
    if report.simple:
        return translate("Verdict", "simple, area {area}").format(area=area)
    first = f"{report.crossing_times[0]:.2f}".removeprefix("0")
    if report.natural:
        return translate("Verdict", "natural crossing at {t}, area {area}").format(t=first, area=area)
    return translate("Verdict", "crosses at t = {t}, area {area}").format(t=first, area=area)


def details(report: Report) -> str:
    """Give all figures, a line each."""
    times = report.times.tolist()
    lines = [
        *_crossings(report),
        translate("Verdict", "Area drifts by up to {p}.").format(p=percent(report.area_deviation)),
        translate("Verdict", "Edge lengths drift by {p} on average.").format(
            p=percent(report.length_deviation)
        ),
        translate("Verdict", "Turning angles drift by {a} degrees on average.").format(
            a=f"{np.degrees(report.angle_deviation):.1f}"
        ),
    ]
    if report.negative_lengths:
        negative = spans(times, report.negative_lengths)
        lines.append(
            translate("Verdict", "Some edge has a negative length at t = {times}.").format(times=negative)
        )
    return "\n".join(lines)


def _crossings(report: Report) -> list[str]:
    if report.simple:
        if report.proven:
            return [translate("Verdict", "Never crosses itself: proven for every t.")]
        return [translate("Verdict", "No frame crosses itself.")]
    lines = [translate("Verdict", "Crosses itself at t = {times}.").format(times=crossing_words(report))]
    if report.natural:
        lines.append(translate("Verdict", "That is natural: the shape lies over itself in layers."))
    elif report.natural_frames:
        text = translate("Verdict", "Natural in {n} of {all} frames: the shape lies over itself in layers.")
        lines.append(text.format(n=len(report.natural_frames), all=len(report.crossing_frames)))
    return lines


def crosses_at(report: Report, t: float) -> bool:
    """Tell whether the frame that was measured nearest to t crosses itself."""
    return bool(report.crosses[round(t * (len(report.times) - 1))])


def crossing_spans(report: Report) -> list[tuple[float, float]]:
    """Give the stretches of t from the first to the last crossing frame in a row."""
    edges = np.diff(np.concatenate([[0], report.crosses.astype(np.int8), [0]]))
    starts, stops = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1
    spans = [(float(report.times[a]), float(report.times[b])) for a, b in zip(starts, stops, strict=True)]
    return spans or [(t, t) for t in report.crossing_times]
