"""The stitched blend: every edge of every fan wishes to turn evenly, and all get as near to it as can be."""

from dataclasses import replace

import numpy as np

from starskel.blending.fans import fans_of
from starskel.blending.frames import placed, with_exact_ends
from starskel.blending.mesh import mesh_of
from starskel.blending.pieces import PieceBlend
from starskel.blending.stiffening import stiffened
from starskel.blending.stitch import graph_of
from starskel.decomposition.pieces import Decomposition
from starskel.outline import precedes
from starskel.polar import as_points
from starskel.predicates import Floats
from starskel.skeleton import skeleton_of
from starskel.task import Task


class StitchedBlend(PieceBlend):
    """One least-squares problem over the fans of all pieces, in place of a tree and a mean.

    The outline's centre of mass moves straight. Exchanging source and target gives the same frames backwards.

    Parameters
    ----------
    decomposition : Decomposition
    root : int, optional
        The piece that the skeleton hangs on, which is drawn only.
    task : Task, optional
        Watches the preparation.
    """

    def __init__(
        self, decomposition: Decomposition, root: int | None = None, task: Task | None = None
    ) -> None:
        super().__init__(decomposition, skeleton_of(decomposition, root))
        self._backwards = precedes(decomposition.target, decomposition.source)
        forwards = _exchanged(decomposition) if self._backwards else decomposition
        watched = task or Task()
        fans = fans_of(forwards, watched)
        watched.reach(0.02)
        self._pair = forwards.pair
        self._hubs = fans.hubs
        mesh = mesh_of(fans, len(self.pair))
        watched.reach(0.04)
        graph = graph_of(mesh)
        self._stitch = stiffened(graph, len(self.pair), watched.part(0.1, 1))
        self.errors = self._placed(np.array([0.0, 1.0])) - np.stack([fans.source, fans.target])

    def _points(self, ts: Floats) -> tuple[Floats, Floats]:
        times = 1 - ts if self._backwards else ts
        points = with_exact_ends(self._placed(times), times, self.errors)
        origins = np.stack([points[:, hub].mean(axis=1) for hub in self._hubs], axis=1)
        return points[:, : len(self.decomposition.source)], origins

    def _placed(self, ts: Floats) -> Floats:
        return placed(as_points(self._stitch.points(ts)), ts, self._pair)


def _exchanged(decomposition: Decomposition) -> Decomposition:
    """Call the source target, and the target source."""
    pair = decomposition.pair
    return replace(
        decomposition,
        pair=replace(pair, source=pair.target, target=pair.source),
        source=decomposition.target,
        target=decomposition.source,
        source_origins=decomposition.target_origins,
        target_origins=decomposition.source_origins,
    )
