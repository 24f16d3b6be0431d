"""Blends that move a mesh: the fans of all star pieces, all their points at once."""

from abc import abstractmethod
from collections.abc import Callable

import numpy as np

from starskel.arrays import Complex, Floats, read_only
from starskel.blending.frames import placed, with_exact_ends
from starskel.blending.laplacian import factors_kept
from starskel.blending.meshes.fans import Fans, fans_of
from starskel.blending.meshes.frame_mesh import FrameMesh
from starskel.blending.meshes.improvement import with_better_hubs
from starskel.blending.pieces import PieceBlend
from starskel.decomposition.canonical import canonical
from starskel.decomposition.pieces import Decomposition
from starskel.polar import as_points
from starskel.skeleton import skeleton_of
from starskel.task import UNWATCHED, Task

Motion = Callable[[Floats], Complex]
"""Gives all points of a mesh at each of k times, (k, m), up to a translation."""


class FanBlend(PieceBlend):
    """A blend of the fans of all pieces.

    The outline's centre of mass moves straight. Exchanging source and target gives the same frames backwards.

    Parameters
    ----------
    decomposition : Decomposition
    root : int, optional
        The piece that the skeleton hangs on, which is drawn only.
    task : Task, optional
        Watches the preparation.
    """

    @factors_kept()
    def __init__(self, decomposition: Decomposition, root: int | None = None, task: Task = UNWATCHED) -> None:
        super().__init__(decomposition, skeleton_of(decomposition, root))
        self._backwards = canonical(decomposition.pair).swapped
        forwards = decomposition.exchanged if self._backwards else decomposition
        self._pair = forwards.pair
        self._fans = with_better_hubs(fans_of(forwards, task), len(forwards.source), task)
        task.reach(0.02)
        self._move_by(self._prepared(self._fans, task.part(0.02, 1)))

    @abstractmethod
    def _prepared(self, fans: Fans, task: Task) -> Motion:
        """Give the motion of the points of the fans."""

    def _move_by(self, motion: Motion) -> None:
        self._motion = motion
        ends = np.stack([self._fans.source, self._fans.target])
        self.errors = read_only(self._placed(np.array([0.0, 1.0])) - ends)

    @property
    def mesh(self) -> FrameMesh:
        """The triangles that are moved."""
        ends = self._fans.source, self._fans.target
        source, target = ends[::-1] if self._backwards else ends
        return FrameMesh(source, target, self._fans.triangles)

    @factors_kept()
    def _nodes(self, ts: Floats) -> Floats:
        times = 1 - ts if self._backwards else ts
        return with_exact_ends(self._placed(times), times, self.errors)

    def _points(self, ts: Floats) -> tuple[Floats, Floats]:
        points = self._nodes(ts)
        origins = np.stack([points[:, hub].mean(axis=1) for hub in self._fans.hubs], axis=1)
        return points[:, : len(self.decomposition.source)], origins

    def _placed(self, ts: Floats) -> Floats:
        return placed(as_points(self._motion(ts)), ts, self._pair)
