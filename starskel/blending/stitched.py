"""The stitched blend: every edge of every fan wishes to turn evenly, and all get as near to it as can be."""

from collections.abc import Iterator
from copy import copy

from starskel.blending.fan_blend import FanBlend, Motion
from starskel.blending.fans import Fans
from starskel.blending.stiffening import Graphs, better, plainest
from starskel.decomposition.pieces import Decomposition
from starskel.task import Task


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
        if settled:
            for improvement in self.improvements(watched.part(0.1, 1)):
                self._move_by(improvement._motion)

    def improvements(self, task: Task | None = None) -> Iterator["StitchedBlend"]:
        """Give ever better blends: each has fewer crossing frames than the one made at once and all before.

        The last is what the blend is when it is settled; there is none where nothing better is found.

        Raises
        ------
        Cancelled
            If the task is told to stop.
        """
        for stitch in better(self._graphs, task or Task()):
            improvement = copy(self)
            improvement._move_by(stitch.points)
            yield improvement

    def _prepared(self, fans: Fans, task: Task) -> Motion:
        self._graphs = Graphs(fans, len(self.pair))
        return plainest(self._graphs, task).points
