"""starskel measure: figures of every pair and method."""

import math
import sys
from argparse import Namespace
from collections.abc import Iterator, Sequence
from pathlib import Path
from statistics import median

import msgspec

from starskel.blending import COMPARED
from starskel.command import FAILED
from starskel.command.methods import blends
from starskel.command.opening import Opened, opened
from starskel.errors import StarskelError
from starskel.files.documents import document_text
from starskel.quality import Report, measure
from starskel.sheet.words import percent, verdict

FORMAT = "starskel-figures/1"


class Figures(msgspec.Struct, frozen=True):
    """What was measured of one pair by one method."""

    id: str
    method: str
    vertices: int
    simple: bool
    crossing_times: list[float]
    negative_length_times: list[float]
    area_deviation: float
    length_deviation: float
    angle_deviation: float


class _Failure(msgspec.Struct, frozen=True):
    id: str
    error: str


class _Document(msgspec.Struct, frozen=True):
    format: str
    frames: int
    figures: list[Figures]
    failures: list[_Failure]


def run(arguments: Namespace) -> int:
    """Measure, and print what was found; pairs that fail are named and the others go on."""
    file = opened(arguments.file, arguments.step)
    ids = _ids(file, arguments.id)
    methods = arguments.method or COMPARED
    table = None if arguments.json else _Table(ids, methods)
    found: list[Figures] = []
    failures: list[_Failure] = []
    for pair_id in ids:
        try:
            for figures, report in _measured(file, pair_id, methods, arguments.frames):
                found.append(figures)
                if table is not None:
                    table.add(figures, report)
        except StarskelError as error:
            failures.append(_Failure(pair_id, str(error)))
            print(f"starskel: {_named(error, pair_id, arguments.file)}", file=sys.stderr)
    if table is None:
        print(document_text(_Document(FORMAT, arguments.frames, found, failures)), end="")
    else:
        table.end(found)
    return FAILED if failures else 0


def _ids(file: Opened, asked: Sequence[str] | None) -> Sequence[str]:
    for pair_id in asked or ():
        if pair_id not in file.ids:
            file.pair(pair_id)  # raises, and names near ones
    return asked or file.ids


def _named(error: StarskelError, pair_id: str, path: Path) -> str:
    text = str(error)
    return text if text.startswith(str(path)) else f'{path}: pair "{pair_id}": {text}'


def _measured(
    file: Opened, pair_id: str, methods: Sequence[str], frames: int
) -> Iterator[tuple[Figures, Report]]:
    for method, blend in blends(file.pair(pair_id), methods):
        report = measure(blend, frames)
        figures = Figures(
            pair_id,
            method,
            len(blend.pair),
            report.simple,
            list(report.crossing_times),
            report.times[list(report.negative_lengths)].tolist(),
            report.area_deviation,
            report.length_deviation,
            report.angle_deviation,
        )
        yield figures, report


class _Table:
    """A line for each pair and method, printed as soon as it is known."""

    def __init__(self, ids: Sequence[str], methods: Sequence[str]) -> None:
        self._widths = max(4, *map(len, ids)), max(6, *map(len, methods))
        self._methods = methods
        self._print("pair", "method", "area", "length", "angle", "verdict")

    def add(self, figures: Figures, report: Report) -> None:
        self._print(
            figures.id,
            figures.method,
            percent(figures.area_deviation),
            percent(figures.length_deviation),
            f"{math.degrees(figures.angle_deviation):.1f} deg",
            verdict(report),
        )

    def end(self, found: Sequence[Figures]) -> None:
        print()
        for method in self._methods:
            own = [figures for figures in found if figures.method == method]
            simple = sum(figures.simple for figures in own)
            drift = percent(median(figures.area_deviation for figures in own)) if own else "-"
            print(f"{method:{self._widths[1]}}  {simple} of {len(own)} simple, median area drift {drift}")

    def _print(self, *cells: str) -> None:
        pair_id, method, area, length, angle, words = cells
        name, verb = self._widths
        print(f"{pair_id:{name}}  {method:{verb}}  {area:>7} {length:>7} {angle:>9}  {words}", flush=True)
