"""What a tool answers where an edit is not possible: why, and where that is to be seen."""

from dataclasses import dataclass

import numpy as np

from app.model.marks import Marks, Side
from app.model.point import Point, as_point
from starskel.arrays import Floats
from starskel.crossings import crossing_edges, meeting_places
from starskel.errors import InvalidMarks, InvalidPolygon, StarskelError

Segment = tuple[Point, Point]

MANY = 50
"""So many crossings are shown; more would hide the shape."""


@dataclass(frozen=True)
class Refusal:
    """An edit that is not possible, and where to show why.

    Attributes
    ----------
    side : {"source", "target"}
        The canvas on which it was tried.
    error : StarskelError
        What is wrong.
    segments : tuple of segments
        The edges concerned.
    places : tuple of (float, float)
        The very spots.
    marks : tuple of (int, int)
        The marks concerned, to be shown on both canvases.
    """

    side: Side
    error: StarskelError
    segments: tuple[Segment, ...] = ()
    places: tuple[Point, ...] = ()
    marks: Marks = ()


def refused_ring(side: Side, ring: Floats, error: StarskelError) -> Refusal:
    """Point at all faults of a ring that is not a simple polygon, or at marks that it would make cross."""
    if isinstance(error, InvalidMarks):
        return Refusal(side, error, marks=error.marks)
    if not isinstance(error, InvalidPolygon):
        return Refusal(side, error)
    if len(error.vertices) == 4:
        return Refusal(side, error, *_crossings(ring))
    return Refusal(side, error, places=() if error.place is None else (error.place,))


def _crossings(ring: Floats) -> tuple[tuple[Segment, ...], tuple[Point, ...]]:
    """Give the edges that cross or touch, two after two, and where they do."""
    pairs = crossing_edges(ring)[:MANY]
    ends = np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)
    edges = tuple((as_point(start), as_point(end)) for start, end in ends[pairs.ravel()])
    return edges, tuple(map(as_point, meeting_places(ring, pairs)))
