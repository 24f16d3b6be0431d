"""Frames out as numbers, for programs that draw them themselves: JSON, in the user's units, to the last bit.

Polygons have the format starskel-frames/1, shapes starskel-shape-frames/1; of a way of several steps
starskel-frame-steps/1 holds one such document for each step that frames fall into.
"""

from collections.abc import Iterator
from typing import Any

import msgspec

from starskel.arrays import Floats
from starskel.export.film import Film, Track
from starskel.files.documents import document_text
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Task

FORMAT = "starskel-frames/1"
SHAPE_FORMAT = "starskel-shape-frames/1"
STEPS_FORMAT = "starskel-frame-steps/1"


class _Document(msgspec.Struct, frozen=True):
    format: str
    method: str
    times: list[float]
    marks: list[int]
    frames: list[Any]


class _ShapeDocument(msgspec.Struct, frozen=True):
    format: str
    method: str
    times: list[float]
    outer: list[int]
    frames: list[Any]


class _Step(msgspec.Struct, frozen=True):
    step: int
    content: _Document | _ShapeDocument


class _Steps(msgspec.Struct, frozen=True):
    format: str
    method: str
    steps: list[_Step]


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give the frames as one document."""
    task.reach(0)
    track, wanted = film.only, film.settings
    places = [track.at(time, wanted.eased) for time in wanted.times]
    steps = [
        _Step(number + 1, _document(track, number, [t for scene, t in places if scene == number]))
        for number in sorted({scene for scene, _ in places})
    ]
    document = steps[0].content if len(track.scenes) == 1 else _Steps(STEPS_FORMAT, track.name, steps)
    yield document_text(document).encode()


def _document(track: Track, number: int, ts: list[float]) -> _Document | _ShapeDocument:
    blend = track.scenes[number].blend
    if isinstance(blend, ShapeBlend):
        frames = [[_rows(ring) for ring in frame] for frame in blend.frames(ts)]
        return _ShapeDocument(SHAPE_FORMAT, track.name, ts, list(blend.pair.outer), frames)
    rings = [_rows(ring) for ring in blend.frames(ts)]
    return _Document(FORMAT, track.name, ts, list(blend.pair.marked_rows), rings)


def _rows(ring: Floats) -> list[Any]:
    rows: list[Any] = ring.tolist()
    return rows
