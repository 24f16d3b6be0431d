"""The stitched blend: every edge of every fan wishes to turn evenly, and all get as near to it as can be."""

from collections.abc import Iterator
from copy import copy

from starskel.blending.fan_blend import FanBlend, Motion
from starskel.blending.laplacian import factors_kept
from starskel.blending.meshes.fans import Fans
from starskel.blending.stiffening import Graphs, better, plainest
from starskel.decomposition.pieces import Decomposition
from starskel.task import UNWATCHED, Task


class StitchedBlend(FanBlend):
    """One least-squares problem over the fans of all pieces, in place of a tree and a mean.

    Parameters
    ----------
    decomposition : Decomposition
    root : int, optional
        The piece that the skeleton hangs on, which is drawn only.
    task : Task, optional
        Watches the preparation.
    settled : bool
        Whether to look for frames that cross and to mend what can be mended: that takes most of the time.
        Else the blend is there at once, and `improvements` gives the better ones.
    """

    method = "stitched"

    @factors_kept()
    def __init__(
        self,
        decomposition: Decomposition,
        root: int | None = None,
        task: Task = UNWATCHED,
        *,
        settled: bool = True,
    ) -> None:
        super().__init__(decomposition, root, task)
        self.settled = settled
        if settled:
            for stitch, _ in better(self._graphs, task.part(0.1, 1)):
                self._move_by(stitch.points)

    def _improvements(self, task: Task) -> Iterator["StitchedBlend"]:
        """Give blends with ever fewer crossing frames, while stiffening and other balances find some."""
        if self.settled:
            return
        best = self
        for stitch, is_simple in better(self._graphs, task):
            best = copy(self)
            best._move_by(stitch.points)
            best.settled = is_simple
            yield best
        if not best.settled:
            best = copy(best)
            best.settled = True
            yield best

    def _prepared(self, fans: Fans, task: Task) -> Motion:
        self._graphs = Graphs(fans, self.pair.starts, len(self.pair))
        return plainest(self._graphs, task).points
