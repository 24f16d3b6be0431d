"""starskel convert: shapes from one kind of file into another, or into a project that can be blended."""

import sys
from argparse import Namespace
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path

import msgspec
import numpy as np
import shapely

from starskel.command.holdings import check_texts, holdings, pair_of
from starskel.command.written import written_text
from starskel.errors import InvalidFile
from starskel.export.svg import svg_text
from starskel.files.disk import write_bytes, wrong_ending
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import write_project
from starskel.reading.named_shape import NamedShape
from starskel.sheet.drawing import Area, Drawing, Group

_ONE_UNIT = 1e-9
"""Drawings without any extent get at least this much."""


def run(arguments: Namespace) -> int:
    """Read the shapes, choose among them, and write them; what was mended goes to standard error."""
    ending = arguments.output.suffix.lower()
    if ending not in _WRITERS:
        raise wrong_ending(arguments.output, tuple(_WRITERS))
    check_texts(arguments.files, arguments.text)
    shapes: list[NamedShape] = []
    told: list[str] = []
    for path in arguments.files:
        held = holdings(path, arguments.tolerance, arguments.text)
        shapes += held.shapes
        told += [f"{path}: {named.name}: {repair}" for named in held.shapes for repair in named.repairs]
        told += [f"{path}: {note}" for note in held.notes]
    for sentence in told:
        print(sentence, file=sys.stderr)
    chosen = _chosen(shapes, arguments.shape)
    if ending == ".json" and not arguments.shape:
        chosen = chosen[:2]
    _WRITERS[ending](arguments.output, chosen)
    if arguments.json:
        names = [named.name for named in chosen]
        print(written_text([arguments.output], shapes=names, mended=told), end="")
    return 0


def _chosen(shapes: Sequence[NamedShape], names: Sequence[str] | None) -> list[NamedShape]:
    if names is None:
        return list(shapes)
    known = {named.name: named for named in reversed(shapes)}
    for name in names:
        if name not in known:
            raise InvalidFile(f'there is no shape "{name}"', "choose one of " + ", ".join(reversed(known)))
    return [known[name] for name in names]


def _write_project(path: Path, shapes: Sequence[NamedShape]) -> None:
    """Write a project whose key shapes these are."""
    if len(shapes) < 2:
        raise InvalidFile(f"{path} needs a source and a target, there is one shape", "give another file")
    projects = [Project.of(pair_of(path.stem, one.shape, two.shape)) for one, two in pairwise(shapes)]
    own = (projects[0].shapes[0], *(project.shapes[1] for project in projects))
    write_project(path, Project(path.stem, own, tuple(project.steps[0] for project in projects)))


def _write_svg(path: Path, shapes: Sequence[NamedShape]) -> None:
    """Write each shape as one path in a group of its name, a unit a point, from the lower left corner on."""
    corners = np.concatenate([ring.vertices for named in shapes for ring in named.shape.rings])
    low, size = corners.min(axis=0), np.maximum(np.ptp(corners, axis=0), _ONE_UNIT)

    def areas(named: NamedShape) -> tuple[Area, ...]:
        rings = [ring.vertices - low for ring in named.shape.rings]
        return tuple(
            Area(rings[k], "#000000", None, tuple(rings[hole] for hole in named.shape.holes(k)))
            for k in named.shape.outlines
        )

    groups = tuple(Group(named.name, areas(named)) for named in shapes)
    drawing = Drawing(path.stem, float(size[0]), float(size[1]), groups)
    write_bytes(path, svg_text(drawing).encode())


def _write_geojson(path: Path, shapes: Sequence[NamedShape]) -> None:
    features = [
        {
            "type": "Feature",
            "properties": {"name": named.name},
            "geometry": msgspec.Raw(shapely.to_geojson(named.shape.to_shapely()).encode()),
        }
        for named in shapes
    ]
    content = msgspec.json.encode({"type": "FeatureCollection", "features": features})
    write_bytes(path, content + b"\n")


def _write_wkt(path: Path, shapes: Sequence[NamedShape]) -> None:
    lines = [shapely.to_wkt(named.shape.to_shapely(), rounding_precision=-1) for named in shapes]
    write_bytes(path, "".join(line + "\n" for line in lines).encode())


_WRITERS: dict[str, Callable[[Path, Sequence[NamedShape]], None]] = {
    ".json": _write_project,
    ".svg": _write_svg,
    ".geojson": _write_geojson,
    ".wkt": _write_wkt,
}
