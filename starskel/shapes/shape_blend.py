"""What a blend of two shapes is: all parts on their way, joined by the meta-skeleton."""

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import shapely
from numpy.typing import ArrayLike

from starskel.arrays import Flags, Floats
from starskel.blending.frames import checked_times, with_exact_ends
from starskel.blending.pieces import PieceBlend
from starskel.polar import as_points
from starskel.shapes.correspondence import ShapeCorrespondence
from starskel.shapes.meta_skeleton import MetaSkeleton, Tree, meta_skeleton_of
from starskel.task import Progress, ShouldStop, Task

if TYPE_CHECKING:  # who shows a blend need not load what makes one
    from starskel.shapes.body import Body


class ShapeBlend:
    """A blend of two shapes: for every t the rings of all pairs, in the order of the pairing.

    Attributes
    ----------
    pair : ShapeCorrespondence
    method : str
        One of `starskel.METHODS`.
    bodies : tuple of Body
        The parts that move as one, each with its blend: a part with its holes, or by the method "edge-angle"
        each ring.
    meta_skeleton : MetaSkeleton or None
        What joins them; None where each part is interpolated separately.
    key_times, how, settled
        As for `starskel.Blend`.

    Examples
    --------
    >>> import starskel
    >>> frame = starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (6, 2), (6, 6), (2, 6)]])
    >>> blend = starskel.blend(frame, starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)]]))
    >>> [len(ring) for ring in blend.at(0.5)]
    [4, 4]
    >>> round(blend.shape_at(0.5).area), blend.shape_at(1).area
    (57, 64.0)
    """

    key_times: Floats | None = None
    how: str | None = None

    def __init__(
        self, pair: ShapeCorrespondence, method: str, bodies: "tuple[Body, ...]", tree: Tree | None
    ) -> None:
        self.pair, self.method, self.bodies, self._tree = pair, method, bodies, tree
        self.meta_skeleton: MetaSkeleton | None = None
        if tree is not None:
            roots = np.array([body.root_ends for body in bodies]).T
            self.meta_skeleton = meta_skeleton_of(tree, roots)
        ends = np.array([0.0, 1.0])
        self._errors = [rows - body.part.ends for body, rows in zip(bodies, self._rows(ends), strict=True)]
        self._places = {
            link: (number, ring)
            for number, body in enumerate(bodies)
            for ring, link in enumerate(body.part.links)
        }

    @property
    def settled(self) -> bool:
        """Whether no part has a better blend to come."""
        return all(body.blend.settled for body in self.bodies)

    def improvements(
        self, *, progress: Progress | None = None, should_stop: ShouldStop | None = None
    ) -> Iterator["ShapeBlend"]:
        """Give ever better blends, as `starskel.Blend.improvements` does, improving one part after another.

        Parameters
        ----------
        progress, should_stop : callable, optional
            As there.

        Raises
        ------
        Cancelled
            If ``should_stop`` answered True.
        """
        return self._improvements(Task(progress, should_stop))

    def _improvements(self, task: Task) -> Iterator["ShapeBlend"]:
        bodies = list(self.bodies)
        for number, body in enumerate(self.bodies):
            share = task.part(number / len(bodies), (number + 1) / len(bodies))
            for better in body.blend.improvements(progress=share.reach, should_stop=task.should_stop):
                bodies[number] = replace(body, blend=better)
                yield ShapeBlend(self.pair, self.method, tuple(bodies), self._tree)

    def at(self, t: float) -> list[Floats]:
        """Give the rings at t, counter-clockwise (n, 2) arrays; of rings that are a point all rows are equal.

        Raises
        ------
        StarskelError
            Where t is not a number from 0 to 1.
        """
        return self.frames([t])[0]

    def frames(self, ts: ArrayLike) -> list[list[Floats]]:
        """Give the rings at each of k times, as `at` does.

        Parameters
        ----------
        ts : (k,) array-like
            Numbers from 0 to 1, in any order.

        Raises
        ------
        StarskelError
            Where a time is not a number from 0 to 1.
        """
        times = checked_times(ts)
        rings = self.rings(times)
        return [[ring[k] for ring in rings] for k in range(len(times))]

    def rings(self, ts: ArrayLike) -> list[Floats]:
        """Give each ring at all of k times `ts`, a (k, n, 2) array for each."""
        times = checked_times(ts)
        rows = self._exact_rows(times)
        own = [body.part.rings(part) for body, part in zip(self.bodies, rows, strict=True)]
        return [own[body][ring] for body, ring in (self._places[link] for link in self.pair.pairing)]

    @property
    def pieces(self) -> tuple[PieceBlend | None, ...]:
        """For each body the blend of its star pieces, which go where its frames go, or None."""
        return tuple(body.blend if isinstance(body.blend, PieceBlend) else None for body in self.bodies)

    def negative_lengths(self, ts: ArrayLike) -> Flags:
        """Tell at which of the times `ts` the method had to give some edge a negative length."""
        return np.asarray(np.any([body.blend.negative_lengths(ts) for body in self.bodies], axis=0))

    def shape_at(self, t: float) -> shapely.MultiPolygon:
        """Give the parts at t that have an area, with their holes; not valid where rings meet."""
        rings = self.at(t)
        whole = [len(np.unique(ring, axis=0)) > 2 for ring in rings]
        return shapely.MultiPolygon(
            [
                (ring, [rings[k] for k, outer in enumerate(self.pair.outer) if outer == number and whole[k]])
                for number, ring in enumerate(rings)
                if self.pair.outer[number] < 0 and whole[number]
            ]
        )

    def _exact_rows(self, ts: Floats) -> list[Floats]:
        """Give the rows of each body, at the ends exactly as they are given."""
        rows = zip(self._rows(ts), self._errors, strict=True)
        return [with_exact_ends(own, ts, errors) for own, errors in rows]

    def _rows(self, ts: Floats) -> list[Floats]:
        moved = [body.moved(ts) for body in self.bodies]
        if self.meta_skeleton is None:
            return [as_points(rows + roots[:, None]) for rows, roots in moved]
        places = self.meta_skeleton.places(ts)
        return [as_points(rows + place[:, None]) for (rows, _), place in zip(moved, places.T, strict=True)]
