"""What a complete correspondence is."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from starskel.arguments import instance
from starskel.arrays import Floats, Indices, ReadOnlyArrays, read_only
from starskel.errors import StarskelError


@dataclass(frozen=True, eq=False)
class Correspondence(ReadOnlyArrays):
    """Two polygons with equally many vertices, row i of the one corresponding to row i of the other.

    Attributes
    ----------
    source, target : (n, 2) arrays
        The rings, counter-clockwise, with the inserted vertices; row 0 of the source is its vertex 0.
    marks : tuple of (int, int)
        The marks as given: a vertex of the source polygon, a vertex of the target polygon.
    source_vertices, target_vertices : (n,) arrays of int
        For each row the vertex of the polygon, or -1 where the row was inserted.
    starts : tuple of int
        The rows at which rings begin: one ring for a polygon; for a region with holes the outline, and behind
        it the holes, clockwise.
    marked_rows : tuple of int
        The rows that bear the marks, in the marks' order.

    Examples
    --------
    >>> import starskel
    >>> square, triangle = [(0, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), (2, 0), (1, 2)]
    >>> pair = starskel.match(square, triangle, marks=[(0, 0)])
    >>> len(pair), pair.marks
    (4, ((0, 0),))
    >>> pair.source[list(pair.marked_rows)].tolist()
    [[0.0, 0.0]]
    """

    source: Floats
    target: Floats
    marks: tuple[tuple[int, int], ...]
    source_vertices: Indices
    target_vertices: Indices
    starts: tuple[int, ...] = (0,)
    marked_rows: tuple[int, ...] = ()

    @property
    def ring_pairs(self) -> "tuple[Correspondence, ...]":
        """For each ring of a frame its own correspondence: of polygons this one alone."""
        return (self,)

    @property
    def outer(self) -> tuple[int, ...]:
        """For each ring of a frame the ring that it is a hole of: of polygons -1, for none."""
        return (-1,)

    @cached_property
    def following(self) -> Indices:
        """For each row the one after it on its ring, (n,)."""
        rows = np.arange(1, len(self) + 1)
        rows[[*(start - 1 for start in self.starts[1:]), -1]] = self.starts
        return read_only(rows)

    @property
    def exchanged(self) -> "Correspondence":
        """The same pair, with the target as the source."""
        return Correspondence(
            source=self.target,
            target=self.source,
            marks=tuple((j, i) for i, j in self.marks),
            source_vertices=self.target_vertices,
            target_vertices=self.source_vertices,
            starts=self.starts,
            marked_rows=self.marked_rows,
        )

    def __len__(self) -> int:
        return len(self.source)


def checked_pair(given: object) -> Correspondence:
    """Give a pair of polygons.

    Raises
    ------
    StarskelError
        If it is none, or one of regions with holes.
    """
    mend = "give what match returns for two polygons"
    pair = instance(given, Correspondence, "a pair of polygons", mend)
    if len(pair.starts) > 1:
        raise StarskelError("the pair is of regions with holes", mend)
    return pair
