"""The certified blend of shapes: no ring touches itself or another one, for any t.

Parts without holes move by their own certified blends, parts with holes by stitched ones, all joined by the
meta-skeleton. Keyframes of that are taken so densely that all even motions between them are proven, for all
rings together: then outlines and holes stay simple, holes inside and apart, and parts apart. Two excuses:
rings of parts that meet in the source or the target may meet on the way; and a ring that grows from a point
or shrinks to one is, next to that point, a copy of itself that grows evenly. Nothing is repaired here: where
rings do meet, there is no such blend.
"""

from collections.abc import Callable, Iterator
from itertools import combinations

import numpy as np
import shapely
from numpy.typing import NDArray

from starskel.blending.certified.keys import between
from starskel.certificate import safe_rings
from starskel.errors import StarskelError
from starskel.outline import cross_themselves
from starskel.predicates import Floats, Indices
from starskel.shapes.body import Body
from starskel.shapes.correspondence import ShapeCorrespondence
from starskel.shapes.meta_skeleton import Tree
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Task

LINKS = 64
"""So many links are looked at first."""

BISECTIONS = 8
"""How often a link that is not safe is halved before it counts as rings that meet."""


class CertifiedShapeBlend(ShapeBlend):
    """Keyframes that every vertex moves evenly between, each such motion proven.

    Attributes
    ----------
    key_times : (k,) array
        When the keyframes are, from 0 to 1.
    meeting_parts : tuple of (int, int)
        The bodies that meet in the source or the target, and so may on the way.

    Raises
    ------
    StarskelError
        Where rings meet on the way.
    """

    def __init__(
        self, pair: ShapeCorrespondence, bodies: tuple[Body, ...], tree: Tree | None, task: Task
    ) -> None:
        super().__init__(pair, "certified", bodies, tree)
        self._keys: tuple[Floats, Floats] | None = None
        self._stops = np.cumsum([len(body.part.pair) for body in bodies])[:-1]
        self.meeting_parts = tuple(_meeting(bodies))
        links = _Links(self._all_rows, _Rings(bodies, self.meeting_parts), task)
        times = np.linspace(0, 1, LINKS + 1)
        frames = self._all_rows(times)
        frames[[0, -1]] = np.concatenate([body.part.ends for body in bodies], axis=1)  # to the bit
        known = [(0.0, frames[0])]
        for number in range(LINKS):
            task.reach(number / LINKS)
            after = float(times[number + 1]), frames[number + 1]
            known += links.between(known[-1], after, BISECTIONS)
        self.key_times = np.array([t for t, _ in known])
        self._keys = self.key_times, np.stack([frame for _, frame in known])

    def _all_rows(self, ts: Floats) -> Floats:
        return np.concatenate(self._exact_rows(ts), axis=1)

    def _exact_rows(self, ts: Floats) -> list[Floats]:
        if self._keys is None:
            return super()._exact_rows(ts)
        return np.split(between(*self._keys, ts), self._stops, axis=1)


_Key = tuple[float, Floats]
"""A time and the rows then."""


class _Rings:
    """All rings of all bodies as rows, and which of them may touch."""

    def __init__(self, bodies: tuple[Body, ...], meeting: tuple[tuple[int, int], ...]) -> None:
        firsts = np.cumsum([0, *(len(body.part.pair) for body in bodies)])
        self.following = np.concatenate(
            [body.part.pair.following + first for body, first in zip(bodies, firsts, strict=False)]
        )
        self.starts = [
            int(first) + start
            for body, first in zip(bodies, firsts, strict=False)
            for start in body.part.pair.starts
        ]
        self._body_of = np.repeat(np.arange(len(bodies)), np.diff(firsts))
        self._ring_of = np.repeat(np.arange(len(self.starts)), np.diff([*self.starts, firsts[-1]]))
        self._may_touch = np.zeros((firsts[-1], firsts[-1]), dtype=np.bool_)
        for one, two in meeting:
            both = np.outer(self._body_of == one, self._body_of == two)
            self._may_touch |= both | both.T

    def safe(self, before: Floats, after: Floats) -> bool:
        """Tell whether the even motion from one frame to another is proven."""
        excused = self._may_touch
        for frame, other in ((before, after), (after, before)):
            for ring in self._points(frame):
                rows = self._ring_of == ring
                if not self._is_simple(other[rows]):
                    return False
                excused = excused | np.outer(rows, rows)
        return safe_rings(before, after, self.following, excused)

    def _points(self, frame: Floats) -> Indices:
        """Give the rings that are a point."""
        low, high = (ufunc.reduceat(frame, self.starts, axis=0) for ufunc in (np.minimum, np.maximum))
        return np.flatnonzero((low == high).all(axis=1))

    @staticmethod
    def _is_simple(ring: Floats) -> bool:
        both: NDArray[np.bool_] = cross_themselves(np.stack([ring, ring[::-1]]))
        return not both.all()


class _Links:
    """Halves links until they are proven."""

    def __init__(self, rows_at: Callable[[Floats], Floats], rings: _Rings, task: Task) -> None:
        self._rows_at, self._rings, self._task = rows_at, rings, task

    def between(self, before: _Key, after: _Key, bisections: int) -> list[_Key]:
        """Give the keys from one, left out, to another.

        Raises
        ------
        StarskelError
            Where no more halving helps.
        """
        self._task.quiet.reach(0)
        if self._rings.safe(before[1], after[1]):
            return [after]
        if not bisections:
            raise StarskelError(
                f"rings of the shapes meet on the way, near t = {before[0]:.3f}",
                "choose another method, as stitched, or add marks",
            )
        t = (before[0] + after[0]) / 2
        middle = t, self._rows_at(np.array([t]))[0]
        return [
            *self.between(before, middle, bisections - 1),
            *self.between(middle, after, bisections - 1),
        ]


def _meeting(bodies: tuple[Body, ...]) -> Iterator[tuple[int, int]]:
    """Give the bodies whose rings meet in the source or the target."""
    ends = [[_drawn(body.part.rings(rows)) for rows in body.part.ends] for body in bodies]
    for one, two in combinations(range(len(bodies)), 2):
        if shapely.intersects(ends[one], ends[two]).any():
            yield one, two


def _drawn(rings: list[Floats]) -> shapely.Geometry:
    return shapely.union_all(
        [shapely.LinearRing(ring) if np.ptp(ring, axis=0).any() else shapely.Point(ring[0]) for ring in rings]
    )
