"""What a report says, in a few words and in many, and where over t its blend crosses itself."""

import numpy as np
from PySide6.QtCore import QCoreApplication

from starskel.quality import Report
from starskel.sheet.words import percent, spans

translate = QCoreApplication.translate


def summary(report: Report) -> str:
    """Give the verdict in one line that fits above a frame."""
    area = percent(report.area_deviation)
    if report.simple:
        return translate("Verdict", "simple, area {area}").format(area=area)
    first = f"{report.crossing_times[0]:.2f}".removeprefix("0")
    return translate("Verdict", "crosses at t = {t}, area {area}").format(t=first, area=area)


def details(report: Report) -> str:
    """Give all figures, a line each."""
    times = report.times.tolist()
    lines = [
        translate("Verdict", "No frame crosses itself.")
        if report.simple
        else translate("Verdict", "Frames cross themselves at t = {times}.").format(
            times=spans(times, report.crossing_frames)
        ),
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


def crosses_at(report: Report, t: float) -> bool:
    """Tell whether the frame that was measured nearest to t crosses itself."""
    return bool(report.crossings[round(t * (len(report.times) - 1))])


def crossing_spans(report: Report) -> list[tuple[float, float]]:
    """Give the stretches of t from the first to the last crossing frame in a row."""
    edges = np.diff(np.concatenate([[0], report.crossings.astype(np.int8), [0]]))
    starts, stops = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1) - 1
    return [(float(report.times[a]), float(report.times[b])) for a, b in zip(starts, stops, strict=True)]
