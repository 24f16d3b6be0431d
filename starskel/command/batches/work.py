"""One job: a pair blended by each method and measured, wherever that is done."""

from collections.abc import Sequence
from dataclasses import dataclass
from time import process_time
from typing import Any

import msgspec

from starskel.command.measure import Figures
from starskel.command.methods import blends
from starskel.errors import StarskelError
from starskel.files.multi_pairs import MultiPair
from starskel.files.pairs import ShapePair
from starskel.files.project import AnyPair
from starskel.quality import ShapeReport, measure
from starskel.shapes.blend import blend
from starskel.shapes.match import match


class Outcome(msgspec.Struct, frozen=True, kw_only=True):
    """What came out, a line of the results.

    Attributes
    ----------
    key, digest : str
        Those of the job.
    figures : list of dict
        For each method what was measured.
    error : str
        Why it failed; "" where it did not.
    seconds : float
        The processor time that it took.
    """

    key: str
    digest: str
    figures: list[dict[str, Any]] = []
    error: str = ""
    seconds: float = 0.0


@dataclass(frozen=True)
class Task:
    """A job with its pair, as it is sent to where it is done.

    Attributes
    ----------
    key, digest : str
        Those of the job.
    pair : ShapePair or MultiPair
    methods : tuple of str
    frames : int
        So many frames are looked at.
    """

    key: str
    digest: str
    pair: AnyPair
    methods: tuple[str, ...]
    frames: int


def work(task: Task) -> Outcome:
    """Do a task; what goes wrong is told in the outcome, beside what was measured before."""
    start = process_time()
    figures: list[dict[str, Any]] = []
    error = ""
    try:
        if isinstance(task.pair, MultiPair):
            _measure_shapes(task, task.pair, figures)
        else:
            _measure_polygons(task, task.pair, figures)
    except StarskelError as fault:
        error = str(fault)
    except Exception as fault:  # a defect of the program stops one pair, not the batch
        error = f"{type(fault).__name__}: {fault}"
    return Outcome(
        key=task.key, digest=task.digest, figures=figures, error=error, seconds=process_time() - start
    )


def _measure_polygons(task: Task, pair: ShapePair, figures: list[dict[str, Any]]) -> None:
    for method, made in blends(pair, task.methods, watch=lambda method, fraction: None):
        report = measure(made, task.frames)
        figures.append(msgspec.to_builtins(Figures.of(pair.id, method, len(made.pair), report)))


def _measure_shapes(task: Task, pair: MultiPair, figures: list[dict[str, Any]]) -> None:
    matched = match(pair.source, pair.target, pair.marks, pairing=pair.pairing, places=pair.places)
    holed = any(outer >= 0 for outer in matched.outer)
    for method in _able(task.methods, holed):
        report = measure(blend(matched, method=method, joined=pair.joined, turns=pair.turns), task.frames)
        figures.append({"id": pair.id, "method": method, **_shape_figures(report)})


def _able(methods: Sequence[str], holed: bool) -> list[str]:
    return [method for method in methods if not (holed and method == "certified")]


def _shape_figures(report: ShapeReport) -> dict[str, Any]:
    return {
        "simple": report.simple,
        "natural_frames": 0,
        "harmful_frames": len(report.crossing_frames),
        "crossing_times": report.times[list(report.crossing_frames)].tolist(),
        "area_deviation": report.area_deviation,
        "overlap": report.overlap,
    }
