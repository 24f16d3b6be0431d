"""The star-skeleton as published (paper, section 3): unfold the tree, then the pieces, then take means."""

import numpy as np

from starskel.arrays import Complex, Floats, Indices, read_only
from starskel.blending.frames import checked_times, with_exact_ends
from starskel.blending.meshes.fans import origin_fans
from starskel.blending.meshes.frame_mesh import FrameMesh
from starskel.blending.pieces import PieceBlend
from starskel.decomposition.pieces import Decomposition
from starskel.polar import as_complex, as_points
from starskel.skeleton import skeleton_of
from starskel.skeleton.spokes import spokes_of


class StarSkeletonBlend(PieceBlend):
    """All polar coordinates are interpolated linearly; where pieces disagree about a vertex, the mean counts.

    Parameters
    ----------
    decomposition : Decomposition
    root : int, optional
        The piece whose star origin is the root; else the one with the most neighbours.
    turns : int
        Whole turns of the whole shape, counter-clockwise, besides what it needs to turn.
    """

    method = "star-skeleton"

    def __init__(self, decomposition: Decomposition, root: int | None = None, turns: int = 0) -> None:
        super().__init__(decomposition, skeleton_of(decomposition, root))
        self._spokes = spokes_of(self.skeleton, turns)
        self._roots = (
            as_complex(decomposition.source_origins[self.skeleton.root]),
            as_complex(decomposition.target_origins[self.skeleton.root]),
        )
        self._order, self._firsts, self._counts = self._copies()
        ends = np.array([0.0, 1.0])
        self.errors = read_only(
            self._unfolded(ends)[0] - np.stack([decomposition.source, decomposition.target])
        )

    def skeleton_at(self, t: float) -> Floats:
        """Give the (2 k - 1, 2) points of the unfolded tree at t: k star origins, then k - 1 mid-points."""
        vectors = self._spokes.vectors.at(checked_times([t]))
        origins = self._origins(checked_times([t]), vectors)
        children = list(self.skeleton.order[1:])
        parents = [self.skeleton.parents[piece] for piece in children]
        mid_points = origins[0, parents] + vectors[0, self._spokes.outer[children]]
        return as_points(np.concatenate([origins[0], mid_points]))

    @property
    def mesh(self) -> FrameMesh:
        """A fan round the star origin of each piece, the origins behind the pieces' points."""
        pieces = self.decomposition
        return FrameMesh(
            np.concatenate([pieces.source, pieces.source_origins]),
            np.concatenate([pieces.target, pieces.target_origins]),
            origin_fans(pieces),
        )

    def _nodes(self, ts: Floats) -> Floats:
        return np.concatenate(self._points(ts), axis=1)

    def _points(self, ts: Floats) -> tuple[Floats, Floats]:
        rows, origins = self._unfolded(ts)
        return with_exact_ends(rows, ts, self.errors), origins

    def _unfolded(self, ts: Floats) -> tuple[Floats, Floats]:
        vectors = self._spokes.vectors.at(ts)
        origins = self._origins(ts, vectors)
        copies = (origins[:, self._spokes.pieces] + vectors)[:, self._order]
        sums = np.add.reduceat(copies, self._firsts, axis=1)
        return as_points(np.divide(sums, self._counts, dtype=np.complex128)), as_points(origins)

    def _origins(self, ts: Floats, vectors: Complex) -> Complex:
        """Unfold the tree: each origin lies where two spokes lead from its parent's, over their mid-point."""
        skeleton, spokes = self.skeleton, self._spokes
        origins = np.empty((len(ts), len(skeleton.parents)), dtype=np.complex128)
        origins[:, skeleton.root] = (1 - ts) * self._roots[0] + ts * self._roots[1]
        steps = vectors[:, spokes.outer] - vectors[:, spokes.inner]
        for piece in skeleton.order[1:]:
            origins[:, piece] = origins[:, skeleton.parents[piece]] + steps[:, piece]
        return origins

    def _copies(self) -> tuple[Indices, Indices, Indices]:
        """Give the spokes to vertices, ordered by vertex; where each one's begin; and how many there are."""
        rows = self._spokes.rows
        order = np.argsort(rows, kind="stable")[np.count_nonzero(rows < 0) :]
        _, firsts, counts = np.unique(rows[order], return_index=True, return_counts=True)
        return order, firsts, counts
