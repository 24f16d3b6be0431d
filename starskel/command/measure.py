"""starskel measure: figures of every pair and method."""

import math
import sys
from argparse import Namespace
from collections.abc import Iterator, Sequence
from statistics import median

import msgspec

from starskel.blending import COMPARED
from starskel.command import FAILED
from starskel.command.opening import Opened, named, opened
from starskel.command.shapes import Watch, Way, blends_of
from starskel.errors import StarskelError
from starskel.files.documents import document_text
from starskel.files.project import AnyPair
from starskel.quality import Distortion, Report, ShapeReport, measure
from starskel.shapes.shape_blend import ShapeBlend
from starskel.sheet.words import crossing_counts, overlap_words, percent

FORMAT = "starskel-figures/2"

_LONGEST_NAME = 23
"""Longer names of pairs are cut in the table."""


class Moment(msgspec.Struct, frozen=True):
    """A crossing: when, whether it is natural, and where edges meet that should not."""

    t: float
    frame: int | None
    natural: bool
    places: list[list[float]]


class Figures(msgspec.Struct, frozen=True):
    """What was measured of one pair by one method; series have a number for each frame."""

    id: str
    method: str
    vertices: int
    simple: bool
    proven: bool
    crossing_times: list[float]
    natural_frames: int
    harmful_frames: int
    crossings: list[Moment]
    negative_length_times: list[float]
    area_deviation: float
    length_deviation: float
    angle_deviation: float
    roughness: float
    inside: Distortion | None
    how: str | None
    clearance: float | None
    areas: list[float]
    area_deviations: list[float]
    perimeters: list[float]
    length_deviations: list[float]

    @classmethod
    def of(cls, pair_id: str, method: str, vertices: int, report: Report) -> "Figures":
        """Take over what can be written as numbers."""
        return cls(
            id=pair_id,
            method=method,
            vertices=vertices,
            simple=report.simple,
            proven=report.proven,
            crossing_times=list(report.crossing_times),
            natural_frames=len(report.natural_frames),
            harmful_frames=len(report.harmful_frames),
            crossings=[Moment(c.t, c.frame, c.natural, c.places.tolist()) for c in report.crossings],
            negative_length_times=report.times[list(report.negative_lengths)].tolist(),
            area_deviation=report.area_deviation,
            length_deviation=report.length_deviation,
            angle_deviation=report.angle_deviation,
            roughness=report.roughness,
            inside=report.inside,
            how=report.how,
            clearance=report.clearance,
            areas=report.areas.tolist(),
            area_deviations=report.area_deviations.tolist(),
            perimeters=report.perimeters.tolist(),
            length_deviations=report.length_deviations.tolist(),
        )


class ShapeFigures(msgspec.Struct, frozen=True):
    """What was measured of one pair of shapes by one method; series have a number for each frame."""

    id: str
    method: str
    rings: int
    vertices: int
    simple: bool
    proven: bool
    holes_inside: bool
    crossing_times: list[float]
    harmful_frames: int
    area_deviation: float
    length_deviation: float
    overlap: float
    areas: list[float]
    area_deviations: list[float]
    length_deviations: list[float]
    overlaps: list[float]

    @classmethod
    def of(cls, pair_id: str, method: str, blend: ShapeBlend, report: ShapeReport) -> "ShapeFigures":
        """Take over what can be written as numbers."""
        return cls(
            id=pair_id,
            method=method,
            rings=len(blend.pair.pairing),
            vertices=sum(len(ring) for ring in blend.at(0)),
            simple=report.simple,
            proven=report.proven,
            holes_inside=report.holes_inside,
            crossing_times=list(report.crossing_times),
            harmful_frames=len(report.crossing_frames),
            area_deviation=report.area_deviation,
            length_deviation=report.length_deviation,
            overlap=report.overlap,
            areas=report.areas.tolist(),
            area_deviations=report.area_deviations.tolist(),
            length_deviations=report.length_deviations.tolist(),
            overlaps=report.overlaps.tolist(),
        )


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


def measured(
    pair: AnyPair, methods: Sequence[str], frames: int, watch: Watch | None = None
) -> Iterator[tuple[Figures | ShapeFigures, Report | ShapeReport]]:
    """Measure a pair blended by each of the methods; watched as by `blends_of`.

    Raises
    ------
    StarskelError
        If the pair cannot be matched or blended.
    """
    for method, blend in blends_of(pair, [Way(method, method) for method in methods], watch):
        if isinstance(blend, ShapeBlend):
            of_shapes = measure(blend, frames)
            yield ShapeFigures.of(pair.id, method, blend, of_shapes), of_shapes
        else:
            report = measure(blend, frames)
            yield Figures.of(pair.id, method, len(blend.pair), report), report


class _Table:
    """A line for each pair and method, printed as soon as it is known; it fits into 100 columns."""

    def __init__(self, ids: Sequence[str], methods: Sequence[str]) -> None:
        self._widths = min(_LONGEST_NAME, max(4, *map(len, ids))), max(6, *map(len, methods))
        self._methods = methods
        self._print("pair", "method", "area", "length", "angle", "stretch", "rough", "verdict")

    def add(self, figures: Figures | ShapeFigures, report: Report | ShapeReport) -> None:
        self._print(
            _shortened(figures.id),
            figures.method,
            percent(figures.area_deviation),
            percent(figures.length_deviation),
            *_of_polygons_only(report),
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


def _of_polygons_only(report: Report | ShapeReport) -> tuple[str, str, str]:
    """Give angle, stretch and roughness."""
    if report.of == "shape":
        return "-", "-", "-"
    return (
        f"{math.degrees(report.angle_deviation):.1f} deg",
        percent(report.inside.stretch - 1) if report.inside else "-",
        f"{100 * report.roughness:.2f} %",
    )


def _shortened(name: str) -> str:
    return name if len(name) <= _LONGEST_NAME else name[: _LONGEST_NAME - 3] + "..."
