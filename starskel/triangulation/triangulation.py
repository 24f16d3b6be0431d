"""Triangles side by side that tile rings."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.points import Points
from starskel.rings import Rings


@dataclass(frozen=True, eq=False)
class Triangulation:
    """Triangles without area zero that tile rings, every vertex of the rings among their corners.

    Attributes
    ----------
    points : Points
    rings : Rings
        Of h vertices over the points, each ring counter-clockwise.
    triangles : (h - 2 k, 3) array of int
        Corners as vertices of the rings, counter-clockwise. Half-edge 3 f + s runs from corner s of triangle
        f to the next.
    twins : (3 h - 6 k,) array of int
        For each half-edge the one on its other side, or -1 on the ring.
    """

    points: Points
    rings: Rings
    triangles: Indices
    twins: Indices

    @classmethod
    def of(cls, points: Points, rings: Rings, triangles: Indices) -> "Triangulation":
        """Find which triangles lie side by side."""
        return cls(points, rings, triangles, _twins(triangles))

    @cached_property
    def starts(self) -> Indices:
        """The vertex at which each half-edge starts."""
        return self.triangles.ravel()

    @cached_property
    def ends(self) -> Indices:
        """The vertex at which each half-edge ends."""
        return self.triangles[:, (1, 2, 0)].ravel()

    @cached_property
    def vertices(self) -> Floats:
        """The (h, 2) coordinates of the rings' vertices."""
        vertices: Floats = self.points.coordinates[self.rings.rows]
        return vertices

    @cached_property
    def owner(self) -> Indices:
        """The ring that each triangle belongs to."""
        owner: Indices = self.rings.owner[self.triangles[:, 0]]
        return owner

    @property
    def tiles(self) -> bool:
        """Whether triangles without straight vertices between them do tile the rings, exactly."""
        rings, twins = self.rings, self.twins
        if len(self.triangles) != len(rings.rows) - 2 * len(rings.counts):
            return False
        starts, ends = self.starts, self.ends
        outer, inner = (twins < 0).nonzero()[0], (twins >= 0).nonzero()[0]
        other = twins.take(inner)
        return (
            bool((self.points.orientation(*rings.rows.take(self.triangles.T)) > 0).all())
            and len(outer) == len(rings.rows) == np.count_nonzero(np.bincount(starts.take(outer)))
            and bool((ends.take(outer) == rings.following.take(starts.take(outer))).all())
            and bool((starts.take(other) == ends.take(inner)).all())
            and bool((twins.take(other) == inner).all())  # no edge is there a third time
        )


Grounds = tuple[Triangulation, Triangulation]
"""The same rings triangulated in the source and in the target."""


def _twins(triangles: Indices) -> Indices:
    """Give for each half-edge another one between the same vertices, or -1."""
    starts, ends = triangles.ravel(), triangles[:, (1, 2, 0)].ravel()
    key = np.minimum(starts, ends) * len(starts) + np.maximum(starts, ends)
    order = key.argsort()
    key = key.take(order)
    shared = np.flatnonzero(key[1:] == key[:-1])
    twins = np.full(len(starts), -1)
    one, other = order[shared], order[shared + 1]
    twins[one], twins[other] = other, one
    return twins
