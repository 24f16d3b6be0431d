"""Fans in the frames of methods that know outlines only: vertex, edge-angle and certified.

The star pieces belong to the pair, not to a method: their fans tile source and target whatever moves the
outline. In a frame every inner node, Steiner vertex or hub, is the mean of its neighbours by mean value
coordinates that go evenly from those in the source to those in the target. So it is right at both ends,
turns, moves and stretches with the outline round it, and costs one small sparse solve a frame. Nothing keeps
triangles from folding where the outline does so.
"""

from collections.abc import Callable

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from starskel.arrays import Floats
from starskel.blending.frames import Blend
from starskel.blending.meshes.fans import fans_of
from starskel.blending.meshes.frame_mesh import FrameMesh, MeshBlend
from starskel.blending.meshes.improvement import with_better_hubs
from starskel.blending.meshes.mean_values import mean_values
from starskel.blending.pieces import PieceBlend
from starskel.decomposition import decompose
from starskel.decomposition.pieces import Decomposition
from starskel.polar import as_complex
from starskel.task import UNWATCHED, Task


class InnerMesh:
    """The fans of a pair's star pieces, carried along by outlines.

    Parameters
    ----------
    frame_at : callable
        Gives the (n, 2) rows of the pair at t.
    decomposition : Decomposition
    task : Task, optional
        Watches the preparation.
    """

    def __init__(
        self, frame_at: Callable[[float], Floats], decomposition: Decomposition, task: Task = UNWATCHED
    ) -> None:
        self._frame_at = frame_at
        fans = with_better_hubs(fans_of(decomposition, task), len(decomposition.source), task)
        self.mesh = FrameMesh(fans.source, fans.target, fans.triangles)
        self._weights = [
            mean_values(as_complex(points), fans.triangles)[len(decomposition.pair) :]
            for points in (fans.source, fans.target)
        ]

    def mesh_at(self, t: float) -> Floats:
        """Give the (m, 2) nodes at t, the frame's rows first."""
        frame = self._frame_at(t)
        weights = (1 - t) * self._weights[0] + t * self._weights[1]
        if not weights.shape[0]:
            return frame
        matrix = sparse.eye_array(weights.shape[0]) - weights[:, len(frame) :]
        inner = splu(sparse.csc_array(matrix)).solve(weights[:, : len(frame)] @ frame)
        return np.concatenate([frame, inner])


def mesh_blend(blend: Blend, decomposition: Decomposition | None = None, task: Task = UNWATCHED) -> MeshBlend:
    """Give a blend itself if it moves a mesh, else the fans of the pair's star pieces carried by its frames.

    Parameters
    ----------
    blend : Blend
    decomposition : Decomposition, optional
        That of the blend's pair, where it is known already; else it is computed if it is needed.
    task : Task, optional
        Watches the preparation.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    if isinstance(blend, PieceBlend):
        return blend
    known = decomposition or blend.decomposition
    if known is None:
        part = task.part(0, 0.9)
        known = decompose(blend.pair, progress=part.reach, should_stop=task.should_stop)
    return InnerMesh(blend.at, known, task.part(0.9, 1))
