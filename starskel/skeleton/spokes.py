"""Polar coordinates around the star origins, unwrapped along the skeleton.

A spoke leads from a star origin to a vertex of its piece, or to a mid-point of the skeleton. The paper
leaves open which multiple of 2 pi belongs to an angle (sections 2.2 and 2.4.4). Here none is ever chosen by
the shorter way round:

- Round an origin the spokes come in the same counter-clockwise order in both polygons, with angles in
  [0, pi] from one to the next.
- Across a shared edge, the directions into the mid-point and out of it are measured against the edge's
  normal; both lie in [-pi/2, pi/2].

With coordinates interpolated linearly the reference directions cancel, so that every spoke turns evenly by
its own rotation, and the root is left with one free choice: whole turns of the whole shape.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.decomposition.canonical import canonical
from starskel.polar import PolarVectors, as_complex
from starskel.predicates import ROUNDING
from starskel.skeleton import Skeleton


@dataclass(frozen=True, eq=False)
class Spokes:
    """All spokes of all pieces.

    Attributes
    ----------
    pieces : (m,) array
        The piece of each spoke.
    rows : (m,) array
        The vertex that it leads to, or -1.
    outer, inner : (k,) arrays
        For each piece the spoke that leads to the mid-point between it and its parent, from the parent
        (outer) and from itself (inner); -1 for the root.
    vectors : PolarVectors
        How the spokes move.
    """

    pieces: Indices
    rows: Indices
    outer: Indices
    inner: Indices
    vectors: PolarVectors


def spokes_of(skeleton: Skeleton, turns: int = 0) -> Spokes:
    """Give the spokes of a skeleton's decomposition, unwrapped from the root outwards.

    All of them turn by so many whole turns more than they need, counter-clockwise.
    """
    layout = _layout(skeleton)
    pieces = skeleton.decomposition
    source = _side(layout, pieces.source, pieces.source_origins)
    target = _side(layout, pieces.target, pieces.target_origins)
    rotations = _rotations(skeleton, layout, source, target)
    lengths = source.lengths, target.lengths
    left = not canonical(skeleton.decomposition.pair).swapped
    vectors = PolarVectors.between(source.directions, target.directions, rotations, lengths, left)
    return Spokes(layout.pieces, layout.rows, layout.outer, layout.inner, vectors.turned(turns))


@dataclass(frozen=True, eq=False)
class _Layout:
    """Which spokes there are: piece after piece, counter-clockwise from its first vertex.

    Attributes
    ----------
    ends : (m, 2) array
        The two rows whose mean the spoke leads to: twice the same vertex, or the ends of a shared edge as
        the piece has them counter-clockwise.
    neighbours : (m, 2) array
        For a spoke to a vertex, the vertices before and after it in the piece.
    starts : (k,) array
        The first spoke of each piece.
    """

    pieces: Indices
    rows: Indices
    ends: Indices
    neighbours: Indices
    starts: Indices
    outer: Indices
    inner: Indices

    def after(self) -> Indices:
        """Give for each spoke the next one round its origin, (m,)."""
        following = np.arange(1, len(self.pieces) + 1)
        following[np.append(self.starts[1:], len(self.pieces)) - 1] = self.starts
        return following


def _layout(skeleton: Skeleton) -> _Layout:
    children = {(b, a): piece for piece, (a, b) in enumerate(skeleton.shared_edges) if piece != skeleton.root}
    count = len(skeleton.parents)
    outer, inner = np.full(count, -1, dtype=np.intp), np.full(count, -1, dtype=np.intp)
    spokes: list[tuple[int, ...]] = []
    starts = []
    for piece, rows in enumerate(skeleton.decomposition.pieces):
        starts.append(len(spokes))
        for before, row, after in zip((rows[-1], *rows[:-1]), rows, (*rows[1:], rows[0]), strict=True):
            spokes.append((piece, row, row, row, before, after))
            edge = row, after
            if edge == skeleton.shared_edges[piece]:
                inner[piece] = len(spokes)
            elif edge in children:
                outer[children[edge]] = len(spokes)
            else:
                continue
            spokes.append((piece, -1, *edge, *edge))
    table = np.array(spokes, dtype=np.intp)
    return _Layout(
        table[:, 0], table[:, 1], table[:, 2:4], table[:, 4:], np.array(starts, dtype=np.intp), outer, inner
    )


@dataclass(frozen=True, eq=False)
class _Side:
    """The spokes in one of the two polygons.

    Attributes
    ----------
    lengths : (m,) array
    directions : (m,) array
        Complex numbers of any length but 0, also where the spoke has no length.
    steps : (m,) array
        The angle from each spoke to the next, in [0, pi].
    slants : (m,) array
        The angle of a spoke to a mid-point against the shared edge's outward normal, in [-pi/2, pi/2].
    """

    lengths: Floats
    directions: Complex
    steps: Floats
    slants: Floats


def _side(layout: _Layout, points: Floats, origins: Floats) -> _Side:
    z = as_complex(points)
    spokes = z[layout.ends].mean(axis=1) - as_complex(origins)[layout.pieces]
    lengths = np.abs(spokes)
    normals = -1j * (z[layout.ends[:, 1]] - z[layout.ends[:, 0]])
    vanishing = lengths <= ROUNDING * np.abs(points).max()
    fallback = np.where(layout.rows < 0, normals, _outward(layout, z))
    directions = np.where(vanishing, fallback, spokes)
    steps = np.angle(directions[layout.after()] / directions)
    steps[steps < -np.pi / 2] += 2 * np.pi  # pi, but for rounding: the origin lies on an edge
    slants = np.angle(directions / np.where(layout.rows < 0, normals, directions))
    return _Side(lengths, directions, steps, slants)


def _outward(layout: _Layout, z: Complex) -> Complex:
    """Give for each vertex the direction that halves the angle outside its piece.

    It stands in for the direction of a spoke without length, so that those round it still come in order.
    """
    before, after = (z[layout.neighbours] - z[layout.ends[:, :1]]).T
    inner_angles = np.angle(before / after) % (2 * np.pi)
    return np.asarray(-after * np.exp(0.5j * inner_angles))


def _rotations(skeleton: Skeleton, layout: _Layout, source: _Side, target: _Side) -> Floats:
    """Give by how much each spoke turns, from the root outwards."""
    gains = np.cumsum(target.steps - source.steps)
    gains -= target.steps - source.steps  # up to the spoke, not beyond it
    slants = target.slants - source.slants
    shifts = np.zeros(len(skeleton.parents))
    first = _longest(layout, source, target, skeleton.root)
    shifts[skeleton.root] = np.angle(target.directions[first] / source.directions[first]) - gains[first]
    for piece in skeleton.order[1:]:
        outer, inner = layout.outer[piece], layout.inner[piece]
        rotation = gains[outer] + shifts[skeleton.parents[piece]] - slants[outer] + slants[inner]
        shifts[piece] = rotation - gains[inner]
    return np.asarray(gains + shifts[layout.pieces])


def _longest(layout: _Layout, source: _Side, target: _Side, piece: int) -> int:
    """Give the spoke of a piece that is longest in both polygons."""
    lengths = np.minimum(source.lengths / source.lengths.max(), target.lengths / target.lengths.max())
    return int(np.where(layout.pieces == piece, lengths, -1.0).argmax())
