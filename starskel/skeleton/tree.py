"""The tree over the pieces, and its points."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.decomposition.pieces import Decomposition, edges_of
from starskel.errors import StarskelError
from starskel.outline import signed_areas
from starskel.predicates import DIGITS

Edge = tuple[int, int]


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A tree over the pieces of a decomposition (paper, sections 2.2 and 2.4.3).

    Its points are the k star origins, in the order of the pieces, and behind them the k - 1 mid-points.

    Attributes
    ----------
    decomposition : Decomposition
        The pieces.
    root : int
        The piece that the tree hangs on.
    order : tuple of int
        All pieces, each behind its parent: the root first.
    parents : tuple of int
        For each piece the piece nearer to the root, -1 for the root.
    shared_edges : tuple of (int, int)
        For each piece the rows of the edge that it shares with its parent, as the piece has them
        counter-clockwise; (-1, -1) for the root.

    Examples
    --------
    >>> import starskel
    >>> hook = [(0, 0), (6, 0), (6, 5), (3, 5), (3, 4), (5, 4), (5, 1), (0, 1)]
    >>> skeleton = starskel.blend(hook, hook, marks=[(0, 0)], method="star-skeleton").skeleton
    >>> skeleton.root, skeleton.parents
    (1, (1, -1))
    >>> skeleton.arcs.tolist()
    [[1, 2], [2, 0]]
    """

    decomposition: Decomposition
    root: int
    order: tuple[int, ...]
    parents: tuple[int, ...]
    shared_edges: tuple[Edge, ...]

    @property
    def mid_points(self) -> dict[int, int]:
        """For each piece but the root, the index of the mid-point between it and its parent."""
        return {piece: len(self.order) + k for k, piece in enumerate(self.order[1:])}

    @property
    def arcs(self) -> Indices:
        """The (2 k - 2, 2) indices of the points that are linked, outwards from the root."""
        pairs = [
            arc
            for piece, mid_point in self.mid_points.items()
            for arc in ((self.parents[piece], mid_point), (mid_point, piece))
        ]
        return np.array(pairs, dtype=np.intp).reshape(-1, 2)

    def points(self, rows: Floats, origins: Floats) -> Floats:
        """Give the (2 k - 1, 2) points of the skeleton, from the decomposition's rows and origins."""
        shared_edges = np.array(
            [self.shared_edges[piece] for piece in self.order[1:]], dtype=np.intp
        ).reshape(-1, 2)
        return np.concatenate([origins, rows[shared_edges].mean(axis=1)])


def skeleton_of(decomposition: Decomposition, root: int | None = None) -> Skeleton:
    """Span a tree over the pieces.

    Pieces are reached breadth-first, each through the longest edge that it shares with one reached before.

    Parameters
    ----------
    decomposition : Decomposition
    root : int, optional
        The piece to start from; else the one with the most neighbours, of those the largest.

    Raises
    ------
    StarskelError
        If there is no such piece.
    """
    if root is not None and not 0 <= root < len(decomposition.pieces):
        raise StarskelError(
            f"there is no piece {root} to be the root", f"give one from 0 to {len(decomposition.pieces) - 1}"
        )
    lengths = _lengths(decomposition)
    neighbours = _neighbours(decomposition, lengths)
    if root is None:
        sizes = _sizes(decomposition)
        root = max(range(len(neighbours)), key=lambda piece: (len(neighbours[piece]), sizes[piece]))
    parents, shared_edges = [-1] * len(neighbours), [(-1, -1)] * len(neighbours)
    order, reached = [root], [root]
    while reached:
        widest: dict[int, tuple[int, Edge]] = {}
        for piece in reached:
            for neighbour, (a, b) in neighbours[piece].items():
                if neighbour == root or parents[neighbour] >= 0:
                    continue
                if neighbour not in widest or lengths[b, a] > lengths[widest[neighbour][1]]:
                    widest[neighbour] = piece, (b, a)
        for neighbour, (piece, edge) in widest.items():
            parents[neighbour], shared_edges[neighbour] = piece, edge
        reached = list(widest)
        order += reached
    return Skeleton(decomposition, root, tuple(order), tuple(parents), tuple(shared_edges))


def _neighbours(decomposition: Decomposition, lengths: dict[Edge, float]) -> list[dict[int, Edge]]:
    """Give for each piece its neighbours, counter-clockwise, and the longest edge shared with each."""
    edges = [edges_of(piece) for piece in decomposition.pieces]
    owner = {edge: piece for piece, own in enumerate(edges) for edge in own}
    found: list[dict[int, Edge]] = []
    for own in edges:
        shared: dict[int, Edge] = {}
        for a, b in own:
            other = owner.get((b, a))
            if other is not None and (other not in shared or lengths[a, b] > lengths[shared[other]]):
                shared[other] = (a, b)
        found.append(shared)
    return found


def _sizes(decomposition: Decomposition) -> list[float]:
    """Give each piece's share of the area, source and target together."""
    total = np.zeros(len(decomposition.pieces))
    for points in (decomposition.source, decomposition.target):
        areas = np.array([signed_areas(points[list(piece)]) for piece in decomposition.pieces])
        total += areas / areas.sum()
    return list(total.round(DIGITS).tolist())


def _lengths(decomposition: Decomposition) -> dict[Edge, float]:
    """Give the lengths of the edges of pieces in both polygons together, over how far vertices of each reach.

    That does not depend on how the polygons are turned. An edge has the same length from both its sides.
    """
    edges = [edge for piece in decomposition.pieces for edge in edges_of(piece)]
    total = np.zeros(len(edges))
    for points in (decomposition.source, decomposition.target):
        ends = points[np.array(edges)]
        rows = points[: len(decomposition.pair)]
        reach = np.hypot(*(rows - rows.mean(axis=0)).T).mean()
        total += np.hypot(*(ends[:, 1] - ends[:, 0]).T) / reach
    return dict(zip(edges, total.round(DIGITS).tolist(), strict=True))
