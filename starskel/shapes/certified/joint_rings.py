"""All rings of a blend of shapes together: which of them may touch, and whether they do on the way.

Two excuses: rings of parts that meet in the source or the target may meet on the way; and a ring that grows
from a point or shrinks to one is, next to that point, a copy of itself that grows evenly, as are all rings of
its part that come from there.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from itertools import combinations

import numpy as np
import shapely

from starskel.arrays import Flags, Floats, Indices
from starskel.certificate import safe_rings
from starskel.crossings import rings_meet
from starskel.outline import cross_themselves
from starskel.shapes.correspondence import PartPair


class JointRings:
    """All rings of all parts as rows, one part behind the other.

    Parameters
    ----------
    parts : sequence of PartPair

    Attributes
    ----------
    following : (n,) array of int
        For each row the one after it on its ring.
    starts : tuple of int
        The row at which each ring begins.
    part_of : (r,) array of int
        For each ring its part.
    clockwise : (r,) array of bool
        For each ring whether its rows run clockwise, as those of holes do.
    ends : (2, n, 2) array
        The rows in source and target.
    meeting : tuple of (int, int)
        The parts that meet in source or target.
    """

    def __init__(self, parts: Sequence[PartPair]) -> None:
        firsts = np.cumsum([0, *(len(part.pair) for part in parts)]).tolist()
        placed = list(zip(parts, firsts, strict=False))
        self.following = np.concatenate([part.pair.following + first for part, first in placed])
        self.starts = tuple(first + start for part, first in placed for start in part.pair.starts)
        self.part_of = np.repeat(np.arange(len(parts)), [len(part.pair.starts) for part in parts])
        self.clockwise = np.concatenate([np.arange(len(part.pair.starts)) > 0 for part in parts])
        self.ends = np.concatenate([part.ends for part in parts], axis=1)
        self.meeting = tuple(_meeting(parts))
        self._ring_of = np.repeat(np.arange(len(self.starts)), np.diff([*self.starts, firsts[-1]]))

    def rows_of(self, ring: int) -> Indices:
        """Give the rows of a ring, (n,)."""
        return np.flatnonzero(self._ring_of == ring)

    def safe(self, before: Floats, after: Floats) -> bool:
        """Tell whether in the even motion from one (m, 2) frame to another no rings touch; exact."""
        excused = self._may_touch[self._ring_of[:, None], self._ring_of]
        for frame, other in ((before, after), (after, before)):
            for together in self._points_together(frame):
                grown = [other[self.rows_of(ring)] for ring in together]
                if rings_meet(grown) or any(map(_crosses_itself, grown)):
                    return False
                own = np.isin(self._ring_of, together)
                excused = excused | np.outer(own, own)
        return safe_rings(before, after, self.following, excused)

    def sound(self, frame: Floats) -> bool:
        """Tell whether in a frame all rings are simple, and apart and inside each other as at the ends."""
        return not self.crossing(frame) and bool((self.inside(frame) == self.nested).all())

    def crossing(self, frame: Floats) -> list[tuple[int, int]]:
        """Give the rings that cross or touch each other, or themselves, in a frame; excused ones left out."""
        points = set(self.points(frame).tolist())
        split = np.split(frame, self.starts[1:])
        found = [(k, k) for k, ring in enumerate(split) if k not in points and _crosses_itself(ring)]
        drawn = [_drawn(ring) for ring in split]
        first, second = shapely.STRtree(drawn).query(drawn, predicate="intersects").tolist()
        pairs = sorted((i, j) for i, j in zip(first, second, strict=True) if i < j)
        return [*found, *((i, j) for i, j in pairs if not self._may_touch[i, j])]

    def inside(self, frame: Floats) -> Flags:
        """Tell of each ring inside which others it lies, (r, r); of rings of parts that meet, of none."""
        outlines = np.split(frame, self.starts[1:])
        within = np.stack(
            [shapely.contains_xy(shapely.Polygon(ring), *frame[list(self.starts)].T) for ring in outlines],
            axis=1,
        )
        within[self._may_touch | np.eye(len(within), dtype=np.bool_)] = False
        return within

    @cached_property
    def nested(self) -> Flags:
        """What `inside` has to give; what lies in a ring that is a point at one end is known at the other."""
        return np.asarray(self.inside(self.ends[0]) | self.inside(self.ends[1]))

    def misplaced(self, side: int) -> Flags:
        """Tell of each ring inside which others it ought to lie in source (0) or target (1) and does not."""
        frame = self.ends[side]
        missing = self.nested & ~self.inside(frame)
        points = np.isin(np.arange(len(missing)), self.points(frame))
        missing[points[:, None] & points] = False
        return missing

    def points(self, frame: Floats) -> Indices:
        """Give the rings that are a point in a frame."""
        low, high = (ufunc.reduceat(frame, self.starts, axis=0) for ufunc in (np.minimum, np.maximum))
        return np.flatnonzero((low == high).all(axis=1))

    def _points_together(self, frame: Floats) -> Iterable[list[int]]:
        """Give the rings that are a point in a frame, those of one part that are the same one together."""
        found: dict[tuple[float, ...], list[int]] = {}
        for ring in self.points(frame).tolist():
            where = (self.part_of[ring], *frame[self.starts[ring]])
            found.setdefault(where, []).append(ring)
        return found.values()

    @cached_property
    def _may_touch(self) -> Flags:
        """For two rings whether their parts meet at an end."""
        parts = np.zeros((self.part_of[-1] + 1,) * 2, dtype=np.bool_)
        for one, two in self.meeting:
            parts[one, two] = parts[two, one] = True
        return np.asarray(parts[self.part_of[:, None], self.part_of])


def _crosses_itself(ring: Floats) -> bool:
    return bool(cross_themselves(np.stack([ring, ring[::-1]])).all())


def _meeting(parts: Sequence[PartPair]) -> Iterator[tuple[int, int]]:
    """Give the parts whose rings meet in the source or the target."""
    ends = [
        [shapely.union_all([_drawn(ring) for ring in part.rings(rows)]) for rows in part.ends]
        for part in parts
    ]
    for one, two in combinations(range(len(parts)), 2):
        if shapely.intersects(ends[one], ends[two]).any():
            yield one, two


def _drawn(ring: Floats) -> shapely.Geometry:
    return shapely.LinearRing(ring) if np.ptp(ring, axis=0).any() else shapely.Point(ring[0])
