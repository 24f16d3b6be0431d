"""The stitched blend: every edge of every fan wishes to turn evenly, and all get as near to it as can be."""

from collections.abc import Iterator
from copy import copy

from starskel.blending.fan_blend import FanBlend, Motion
from starskel.blending.fans import Fans
from starskel.blending.stiffening import Graphs, better, plainest
from starskel.decomposition.pieces import Decomposition
from starskel.task import Progress, ShouldStop, Task


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

    def __init__(
        self,
        decomposition: Decomposition,
        root: int | None = None,
        task: Task | None = None,
        *,
        settled: bool = True,
    ) -> None:
        watched = task or Task()
        super().__init__(decomposition, root, watched)
        self.settled = settled
        if settled:
            for motion in self._better_motions(watched.part(0.1, 1)):
                self._move_by(motion)

    def improvements(
        self, *, progress: Progress | None = None, should_stop: ShouldStop | None = None
    ) -> Iterator["StitchedBlend"]:
        """Give blends with ever fewer crossing frames, while stiffening and other balances find some."""
        for motion in self._better_motions(Task(progress, should_stop)):
            improvement = copy(self)
            improvement._move_by(motion)
            yield improvement

    def _better_motions(self, task: Task) -> Iterator[Motion]:
        return (stitch.points for stitch in better(self._graphs, task))

    def _prepared(self, fans: Fans, task: Task) -> Motion:
        self._graphs = Graphs(fans, self.pair.starts, len(self.pair))
        return plainest(self._graphs, task).points
