"""Frames out as numbers, for programs that draw them themselves.

Polygons have the format starskel-frames/1, shapes starskel-shape-frames/1.
"""

from collections.abc import Sequence
from pathlib import Path

import msgspec

from starskel.files.documents import write_document
from starskel.files.shapes import Row
from starskel.predicates import Floats

FORMAT = "starskel-frames/1"
SHAPE_FORMAT = "starskel-shape-frames/1"


class _Document(msgspec.Struct, frozen=True):
    format: str
    method: str
    times: list[float]
    marks: list[int]
    frames: list[list[Row]]


class _ShapeDocument(msgspec.Struct, frozen=True):
    format: str
    method: str
    times: list[float]
    outer: list[int]
    frames: list[list[list[Row]]]


def write_shape_frames(
    path: Path, method: str, times: Sequence[float], outer: Sequence[int], frames: Sequence[Sequence[Floats]]
) -> None:
    """Write the rings of a blend of shapes, in the user's units, to the last bit.

    Parameters
    ----------
    path : Path
        Where to.
    method : str
        What made them.
    times : k floats
        When they are.
    outer : sequence of int
        For each ring the ring that it is a hole of, -1 for outlines.
    frames : k sequences of (n, 2) arrays
        The rings at each time; row i of a ring is the same vertex in all of them.

    Raises
    ------
    InvalidFile
        If the file cannot be written.
    """
    rings = [[[(x, y) for x, y in ring.tolist()] for ring in frame] for frame in frames]
    write_document(path, _ShapeDocument(SHAPE_FORMAT, method, list(times), list(outer), rings))


def write_frames(
    path: Path, method: str, times: Sequence[float], marks: Sequence[int], frames: Floats
) -> None:
    """Write the polygons of a blend, in the user's units, to the last bit.

    Parameters
    ----------
    path : Path
        Where to.
    method : str
        What made them.
    times : k floats
        When they are.
    marks : sequence of int
        The rows that bear the user's marks, in their order.
    frames : (k, n, 2) array
        The polygons; row i is the same vertex in all of them.

    Raises
    ------
    InvalidFile
        If the file cannot be written.
    """
    rings = [[(x, y) for x, y in ring] for ring in frames.tolist()]
    write_document(path, _Document(FORMAT, method, list(times), list(marks), rings))
