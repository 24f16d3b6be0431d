"""The salient vertices of an outline, and what tells one from another.

They are what discrete curve evolution leaves (Latecki and Lakaemper 1999, "Convexity Rule for Shape
Decomposition Based on Discrete Contour Evolution"): again and again the vertex goes that contributes least.
"""

import heapq
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.crossings import crossing_edges
from starskel.errors import InvalidPolygon
from starskel.outline import edge_lengths, edge_vectors, turning_angles
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import delaunay

MOST = 48
"""So many vertices of an outline are compared, at most."""

_REACHES = (1 / 64, 1 / 32, 1 / 16, 1 / 8)
"""How far to both sides the outline's bends are seen, as shares of its length, the shorter first."""

_SHORTER = 3
"""So many of the reaches tell tips and notches from what bends at large."""

_SAMPLES = 64
EXACT_DIGITS = 12
"""So many decimals are compared: what differs by rounding alone, as moving and scaling make it, is equal."""

_AT_ONCE = 64
"""So many vertices are removed between two questions whether to stop."""


@dataclass(frozen=True, eq=False)
class Landmarks:
    """The k most salient vertices of a ring, in order.

    Positions are complex numbers, from the outline's centre of mass and in units of its radius of gyration.

    Attributes
    ----------
    vertices : (k,) array of int
        Their indices in the ring.
    saliences : (k,) array
        How much the outline bends there over the shorter reaches, from 0 to 1 where it turns back.
    shares : (k,) array
        How far they lie along the outline of the landmarks alone, in [0, 1).
    turns : (k,) array
        The turning angles of that outline.
    bends : (reaches, k) array
        The turns between the chords to the points some way before and behind.
    positions, directions : (k,) arrays of complex
        Where they lie, and where the outline runs there.
    samples : (k, samples) array of complex
        The outline at equal steps, from each of them on.
    diagonals : (m, 2) array of int
        The landmarks that a triangulation of that outline joins across; none where the outline is not simple.
    """

    vertices: Indices
    saliences: Floats
    shares: Floats
    turns: Floats
    bends: Floats
    positions: Complex
    directions: Complex
    samples: Complex
    diagonals: Indices

    @classmethod
    def of(cls, ring: Floats, task: Task) -> "Landmarks":
        """Find them, and measure the outline from each of them."""
        vertices = _most_salient(ring, task)
        kept = ring[vertices]
        lengths = edge_lengths(kept)
        shares = np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum()
        centred = _normalized(kept, lengths)
        own, reaches = shares[:-1], np.array(_REACHES)[:, None]
        before = centred - points_along(centred, own, own - reaches)
        after = points_along(centred, own, own + reaches) - centred
        bends = np.angle(after * np.conj(before))
        steps = (np.arange(_SAMPLES) + 0.5) / _SAMPLES
        return cls(
            vertices=vertices,
            saliences=np.abs(bends[:_SHORTER]).mean(axis=0) / np.pi,
            shares=own,
            turns=turning_angles(kept),
            bends=bends,
            positions=centred,
            directions=np.exp(1j * np.angle(before[0] + after[0])),
            samples=points_along(centred, own, own[:, None] + steps),
            diagonals=_diagonals(kept),
        )

    def __len__(self) -> int:
        return len(self.vertices)


def points_along(positions: Complex, own: Floats, shares: Floats) -> Complex:
    """Give points at (...) shares of an outline's length, from its (k,) vertices and their own shares."""
    closed, ends = np.append(positions, positions[0]), np.append(own, 1.0)
    parts = (np.interp(shares % 1, ends, part) for part in (closed.real, closed.imag))
    return np.asarray(next(parts) + 1j * next(parts))


def _diagonals(ring: Floats) -> Indices:
    """Give the pairs of vertices that a triangulation of the ring joins, (m, 2)."""
    n = len(ring)
    if len(crossing_edges(ring)):
        return np.empty((0, 2), dtype=np.intp)
    try:
        ground = delaunay(points_of(ring), Rings.of([range(n)]))
    except InvalidPolygon:  # it all but touches itself
        return np.empty((0, 2), dtype=np.intp)
    sides = np.stack([ground.starts, ground.ends], axis=1)
    return np.asarray(sides[(sides[:, 0] < sides[:, 1]) & ((sides[:, 1] - sides[:, 0]) % (n - 1) > 1)])


def _normalized(ring: Floats, lengths: Floats) -> Complex:
    """Put the outline's centre of mass at the origin and make its radius of gyration 1."""
    middles = ring + edge_vectors(ring) / 2
    centre = lengths @ middles / lengths.sum()
    squares = ((middles - centre) ** 2).sum(axis=1) + lengths**2 / 12
    x, y = ((ring - centre) / np.sqrt(lengths @ squares / lengths.sum())).T
    return np.asarray(x + 1j * y)


def _most_salient(ring: Floats, task: Task) -> Indices:
    """Remove the vertex of the least contribution again and again; give the last `MOST`, in order."""
    n = len(ring)
    before, after = [(i - 1) % n for i in range(n)], [(i + 1) % n for i in range(n)]
    points = [complex(x, y) for x, y in (ring - ring[0]) / edge_lengths(ring).sum()]
    current = [_contribution(points[before[i]], points[i], points[after[i]]) for i in range(n)]
    queue = [(value, i) for i, value in enumerate(current)]
    heapq.heapify(queue)
    left = set(range(n))
    while len(left) > MOST:
        value, i = heapq.heappop(queue)
        if value != current[i] or i not in left:
            continue  # it has gone, or a neighbour has since
        if len(left) % _AT_ONCE == 0:
            task.reach(0)
        left.remove(i)
        before[after[i]], after[before[i]] = before[i], after[i]
        for k in (before[i], after[i]):
            current[k] = _contribution(points[before[k]], points[k], points[after[k]])
            heapq.heappush(queue, (current[k], k))
    return np.array(sorted(left), dtype=np.intp)


def _contribution(before: complex, here: complex, after: complex) -> float:
    """Give the turn times the harmonic mean of the two edges' lengths, halved."""
    first, second = here - before, after - here
    product = second * first.conjugate()
    lengths = abs(first) * abs(second) / (abs(first) + abs(second)) if product else 0.0
    return round(float(abs(np.arctan2(product.imag, product.real)) * lengths), EXACT_DIGITS)
