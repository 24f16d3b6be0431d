"""What was measured of a blend, in words."""

from collections.abc import Sequence

from starskel.quality import Report


def verdict(report: Report) -> str:
    """Say whether the blend is simple, or when it crosses itself."""
    if report.simple:
        return "simple"
    return "crosses at t = " + spans(report.times.tolist(), report.crossing_frames)


def figures(report: Report) -> tuple[str, ...]:
    """Say how far area and lengths drift, and where some edge has a negative length, a line each."""
    lines = [
        f"area drift {percent(report.area_deviation)}",
        f"length drift {percent(report.length_deviation)}",
    ]
    if report.negative_lengths:
        times = spans(report.times.tolist(), report.negative_lengths)
        lines.append(f"negative lengths at t = {times}")
    return tuple(lines)


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
