"""starskel measure: figures of every pair and method."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from statistics import median

import msgspec

from starskel.blending import COMPARED
from starskel.command import FAILED
from starskel.command.figures import Figures, ShapeFigures, measured
from starskel.command.opening import Opened, named, opened
from starskel.errors import StarskelError
from starskel.files.documents import document_text
from starskel.quality import Report, ShapeReport
from starskel.sheet.words import crossing_counts, finer_words, overlap_words, percent

FORMAT = "starskel-figures/2"

_LONGEST_NAME = 23
"""Longer names of pairs are cut in the table."""


class _Failure(msgspec.Struct, frozen=True):
    id: str
    error: str


class _Document(msgspec.Struct, frozen=True):
    format: str
    frames: int
    figures: list[Figures | ShapeFigures]
    failures: list[_Failure]


def run(arguments: Namespace) -> int:
    """Measure, and print what was found; pairs that fail are named and the others go on."""
    file = opened(arguments.file, arguments.step)
    ids = _ids(file, arguments.id)
    methods = arguments.method or COMPARED
    table = None if arguments.json else _Table(ids, methods)
    found: list[Figures | ShapeFigures] = []
    failures: list[_Failure] = []
    for pair_id in ids:
        try:
            for figures, report in measured(file.pair(pair_id), methods, arguments.frames):
                found.append(figures)
                if table is not None:
                    table.add(figures, report)
        except StarskelError as error:
            failures.append(_Failure(pair_id, str(error)))
            print(f"starskel: {named(error, pair_id, arguments.file)}", file=sys.stderr)
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


class _Table:
    """A line for each pair and method, printed as soon as it is known; it fits into 100 columns."""

    def __init__(self, ids: Sequence[str], methods: Sequence[str]) -> None:
        self._widths = min(_LONGEST_NAME, max(4, *map(len, ids))), max(6, *map(len, methods))
        self._methods = methods
        self._print("pair", "method", "area", "length", "angle", "stretch", "rough", "verdict")

    def add(self, figures: Figures | ShapeFigures, report: Report | ShapeReport) -> None:
        finer = finer_words(report)
        self._print(
            _shortened(figures.id),
            figures.method,
            percent(figures.area_deviation),
            percent(figures.length_deviation),
            *(finer.angle, finer.stretch, finer.roughness),
            ", ".join((crossing_counts(report), *overlap_words(report))),
        )

    def end(self, found: Sequence[Figures | ShapeFigures]) -> None:
        print()
        for method in self._methods:
            own = [figures for figures in found if figures.method == method]
            simple, proven = (sum(f.simple and f.proven >= known for f in own) for known in (False, True))
            natural = sum(not f.simple and not f.harmful_frames for f in own)
            drift = percent(median(figures.area_deviation for figures in own)) if own else "-"
            print(
                f"{method:{self._widths[1]}}  {simple} of {len(own)} simple ({proven} proven),"
                f" {natural} crossing naturally, median area drift {drift}"
            )

    def _print(self, *cells: str) -> None:
        pair_id, method, area, length, angle, stretch, rough, words = cells
        name, verb = self._widths
        row = f"{pair_id:{name}}  {method:{verb}} {area:>6} {length:>6} {angle:>8} {stretch:>7} {rough:>7}"
        print(f"{row}  {words}", flush=True)


def _shortened(name: str) -> str:
    return name if len(name) <= _LONGEST_NAME else name[: _LONGEST_NAME - 3] + "..."
