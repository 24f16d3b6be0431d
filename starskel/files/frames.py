"""Frames out as numbers, format starskel-frames/1: for programs that draw them themselves."""

from collections.abc import Sequence
from pathlib import Path

import msgspec

from starskel.files.documents import write_document
from starskel.files.shapes import Row
from starskel.predicates import Floats

FORMAT = "starskel-frames/1"


class _Document(msgspec.Struct, frozen=True):
    format: str
    method: str
    times: list[float]
    marks: list[int]
    frames: list[list[Row]]


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
