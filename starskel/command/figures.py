"""Figures: what is measured of a pair, as it is written for machines."""

from collections.abc import Iterator, Sequence

import msgspec

from starskel.command.variants import Variant, Watch, blends_of
from starskel.files.projects.project import AnyPair
from starskel.quality import Distortion, Report, ShapeReport, measure
from starskel.shapes.shape_blend import ShapeBlend


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
    angle_deviation: float
    roughness: float
    overlap: float
    how: str | None
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
            angle_deviation=report.angle_deviation,
            roughness=report.roughness,
            overlap=report.overlap,
            how=report.how,
            areas=report.areas.tolist(),
            area_deviations=report.area_deviations.tolist(),
            length_deviations=report.length_deviations.tolist(),
            overlaps=report.overlaps.tolist(),
        )


def measured(
    pair: AnyPair, methods: Sequence[str], frames: int, watch: Watch | None = None
) -> Iterator[tuple[Figures | ShapeFigures, Report | ShapeReport]]:
    """Measure a pair blended by each of the methods; watched as by `blends_of`.

    Raises
    ------
    StarskelError
        If the pair cannot be matched or blended.
    """
    for method, blend in blends_of(pair, list(map(Variant, methods)), watch):
        if isinstance(blend, ShapeBlend):
            of_shapes = measure(blend, frames)
            yield ShapeFigures.of(pair.id, method, blend, of_shapes), of_shapes
        else:
            report = measure(blend, frames)
            yield Figures.of(pair.id, method, len(blend.pair), report), report
