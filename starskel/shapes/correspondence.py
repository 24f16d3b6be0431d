"""What a complete correspondence of two shapes is: part for part, ring for ring, row for row."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from starskel.arrays import Floats, ReadOnlyArrays
from starskel.correspondence import Correspondence
from starskel.correspondence.marks import Mark
from starskel.shapes.matching.pairing import RingLink
from starskel.shapes.shape import Shape


@dataclass(frozen=True, eq=False)
class PartPair(ReadOnlyArrays):
    """A part of the source and its partner, or a part alone and the point that it grows from or shrinks to.

    Attributes
    ----------
    links : tuple of (int or None, int or None)
        Which rings become which: the outlines, then the holes.
    pair : Correspondence
        The rows of all rings: the outline counter-clockwise, behind it the holes clockwise. Holes without a
        partner have a tiny copy for one; a part without a partner has its place in all rows.
    ends : (2, n, 2) array
        Where the rows are at t = 0 and 1: as in the pair, but holes without a partner are a point.
    """

    links: tuple[RingLink, ...]
    pair: Correspondence
    ends: Floats

    @property
    def alone(self) -> bool:
        """Whether the part has no partner."""
        return None in self.links[0]

    def rings(self, rows: Floats) -> list[Floats]:
        """Give the rings of (..., n, 2) rows, each counter-clockwise."""
        outline, *holes = np.split(rows, self.pair.starts[1:], axis=-2)
        return [outline, *(hole[..., ::-1, :] for hole in holes)]

    def by_rings(self) -> "list[PartPair]":
        """Give each ring as a part by itself, counter-clockwise."""
        sides = [self.rings(rows) for rows in (self.pair.source, self.pair.target, *self.ends)]
        vertices = self.rings(np.stack([self.pair.source_vertices, self.pair.target_vertices], axis=-1))
        return [
            PartPair((link,), Correspondence(first, second, (), *known.T), np.stack(ends))
            for link, first, second, *ends, known in zip(self.links, *sides, vertices, strict=True)
        ]


@dataclass(frozen=True, eq=False)
class ShapeCorrespondence:
    """Two shapes and what becomes of every ring of them.

    Attributes
    ----------
    source, target : Shape
    pairing : tuple of (int or None, int or None)
        Which ring of the source becomes which of the target, in the order in which frames have them. A ring
        that stands in several pairs is cut into as many; one beside None is a point in the other shape.
    parts : tuple of PartPair
        The parts, each with its holes.
    marks : tuple of tuples of (int, int)
        For each ring of the source its marks, as given.

    Examples
    --------
    >>> import starskel
    >>> frame = starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (6, 2), (6, 6), (2, 6)]])
    >>> pair = starskel.match(frame, starskel.Shape([[(0, 0), (4, 0), (4, 4), (0, 4)]]))
    >>> pair.pairing, pair.outer
    (((0, 0), (1, None)), (-1, 0))
    >>> [len(ring) for ring in pair.ring_pairs]
    [4, 4]
    """

    source: Shape
    target: Shape
    pairing: tuple[RingLink, ...]
    parts: tuple[PartPair, ...]
    marks: tuple[tuple[Mark, ...], ...] = ()

    @cached_property
    def ring_pairs(self) -> tuple[Correspondence, ...]:
        """For each pair of rings their correspondence, counter-clockwise, in the order of the pairing."""
        known = {ring.links[0]: ring.pair for part in self.parts for ring in part.by_rings()}
        return tuple(self._marked(known[link], link[0]) for link in self.pairing)

    @cached_property
    def outer(self) -> tuple[int, ...]:
        """For each ring of a frame the ring that it is a hole of, -1 for outlines."""
        number = {link: k for k, link in enumerate(self.pairing)}
        owner = {link: number[part.links[0]] for part in self.parts for link in part.links[1:]}
        return tuple(owner.get(link, -1) for link in self.pairing)

    def _marked(self, pair: Correspondence, ring: int | None) -> Correspondence:
        """Give the correspondence of a ring of the source with its marks."""
        if ring is None or not self.marks:
            return pair
        row_of = {vertex: row for row, vertex in enumerate(pair.source_vertices.tolist())}
        rows = tuple(row_of[self.source.rings[ring].vertex_of(i)] for i, _ in self.marks[ring])
        return replace(pair, marks=self.marks[ring], marked_rows=rows)


def region_pair(rings: Sequence[Correspondence]) -> Correspondence:
    """Give the rows of an outline and of its holes, which are turned round, as one correspondence."""
    outline, *holes = [
        ring if number == 0 else replace(ring, **{name: getattr(ring, name)[::-1] for name in _ARRAYS})
        for number, ring in enumerate(rings)
    ]
    arrays = {name: np.concatenate([getattr(ring, name) for ring in (outline, *holes)]) for name in _ARRAYS}
    starts = tuple(np.cumsum([0, *(len(ring) for ring in rings[:-1])]).tolist())
    return Correspondence(**arrays, marks=outline.marks, starts=starts, marked_rows=outline.marked_rows)


_ARRAYS = ("source", "target", "source_vertices", "target_vertices")
