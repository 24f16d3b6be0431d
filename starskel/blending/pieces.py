"""Blends that carry star pieces and a skeleton along, for those who want to see them."""

from abc import abstractmethod

import numpy as np
from numpy.typing import ArrayLike

from starskel.arrays import Floats
from starskel.blending.frames import Blend, checked_times
from starskel.blending.meshes.frame_mesh import FrameMesh
from starskel.decomposition.pieces import Decomposition
from starskel.skeleton import Skeleton


class PieceBlend(Blend):
    """A blend that moves the vertices, Steiner vertices and star origins of a decomposition.

    Attributes
    ----------
    decomposition : Decomposition
        The star pieces.
    skeleton : Skeleton
        The tree over them, with its arcs and its root.
    """

    decomposition: Decomposition
    skeleton: Skeleton

    def __init__(self, decomposition: Decomposition, skeleton: Skeleton) -> None:
        super().__init__(decomposition.pair)
        self.decomposition = decomposition
        self.skeleton = skeleton

    def points_at(self, t: float) -> Floats:
        """Give the (m, 2) points at t whose rows the pieces name: the frame, then Steiner vertices."""
        points: Floats = self._points(checked_times([t]))[0][0]
        return points

    def inside(self, ts: ArrayLike) -> Floats:
        """Give the points of `points_at` and then the k star origins, at each time: (times, m + k, 2)."""
        return np.concatenate(self._points(checked_times(ts)), axis=1)

    def skeleton_at(self, t: float) -> Floats:
        """Give the (2 k - 1, 2) points of the skeleton at t: k star origins, then k - 1 mid-points."""
        rows, origins = self._points(checked_times([t]))
        return self.skeleton.points(rows[0], origins[0])

    @property
    @abstractmethod
    def mesh(self) -> FrameMesh:
        """The triangles that tile the pieces: fans round their hubs."""

    def mesh_at(self, t: float) -> Floats:
        """Give the (m, 2) nodes of the mesh at t, the frame's rows first."""
        nodes: Floats = self._nodes(checked_times([t]))[0]
        return nodes

    @abstractmethod
    def _nodes(self, ts: Floats) -> Floats:
        """Give the (k, m, 2) nodes of the mesh at checked times."""

    @abstractmethod
    def _points(self, ts: Floats) -> tuple[Floats, Floats]:
        """Give the (k, m, 2) points and (k, pieces, 2) origins at checked times."""

    def _frames(self, ts: Floats) -> Floats:
        return np.ascontiguousarray(self._points(ts)[0][:, : len(self.pair)])
