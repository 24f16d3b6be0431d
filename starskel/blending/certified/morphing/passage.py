"""Ways out: from an edge of a ring through the pocket that it lies in, between two bends each, to the open.

A pocket lies between the ring and a side of its convex hull, the lid. It is triangulated; the way to the lid
leads over triangles and crosses the edges between them, the gates, at two points each: the bends of the
passage on the right and on the left. Outside the lid the way is free.
"""

from collections import deque
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.points import Points, points_of
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import delaunay

Gate = tuple[int, int]
"""The vertex on the right and the one on the left, for those who leave."""


@dataclass(frozen=True)
class Passage:
    """A way out, from an edge to the lid.

    Attributes
    ----------
    gates : tuple of Gate
        What is crossed in turn, the lid last; none where the edge lies on the hull.
    lid : Gate
    """

    gates: tuple[Gate, ...]
    lid: Gate

    def bends(self, corners: Complex) -> tuple[Complex, Complex]:
        """Give where the passage crosses the gates of a ring, on the right and on the left."""
        gates = np.array(self.gates, dtype=np.intp).reshape(-1, 2)
        right, left = corners[gates[:, 0]], corners[gates[:, 1]]
        return right + (left - right) / 3, left + (right - left) / 3

    def outwards(self, corners: Complex) -> complex:
        """Give the direction out of the lid, of length 1."""
        along = corners[self.lid[1]] - corners[self.lid[0]]
        return complex(-1j * along / abs(along))


def passages(ring: Floats, task: Task) -> list[Passage]:
    """Give the way out from every edge of a simple (n, 2) ring."""
    points = points_of(ring)
    n = len(ring)
    found: dict[int, Passage] = {}
    hull = _hull(points, n, task)
    for first, last in pairwise([*hull, hull[0] + n]):
        task.reach(0)
        lid = first % n, last % n
        if last - first == 1:
            found[first % n] = Passage((), lid)
        else:
            found |= _through_pocket(points, np.arange(last, first - 1, -1) % n, lid)
    return [found[edge] for edge in range(n)]


def _hull(points: Points, n: int, task: Task) -> list[int]:
    """Give the vertices on the boundary of the convex hull, counter-clockwise, those on its sides as well."""
    order = np.lexsort(points.coordinates[:n].T[::-1]).tolist()
    hull = [*_chain(points, order, task)[:-1], *_chain(points, order[::-1], task)[:-1]]
    first = hull.index(min(hull))  # in a simple ring they come in the ring's order
    return hull[first:] + hull[:first]


def _chain(points: Points, order: list[int], task: Task) -> list[int]:
    """Give the vertices that a walk turning left keeps (Andrew 1979)."""
    chain: list[int] = []
    for vertex in order:
        task.reach(0)
        while len(chain) > 1 and points.orientation(*np.array([[*chain[-2:], vertex]]).T)[0] < 0:
            chain.pop()
        chain.append(vertex)
    return chain


def _through_pocket(points: Points, pocket: Indices, lid: Gate) -> dict[int, Passage]:
    """Give the passages of all edges in a pocket, a ring counter-clockwise whose closing edge is the lid."""
    ground = delaunay(points, Rings.of([pocket]))
    starts, ends = ground.starts, ground.ends
    at_lid = int(np.flatnonzero((starts == len(pocket) - 1) & (ends == 0))[0])
    gates: dict[int, tuple[Gate, ...]] = {at_lid // 3: (lid,)}
    waiting = deque(gates)
    found = {}
    while waiting:
        triangle = waiting.popleft()
        for half_edge in range(3 * triangle, 3 * triangle + 3):
            twin = int(ground.twins[half_edge])
            if twin < 0 and half_edge != at_lid:
                found[int(pocket[ends[half_edge]])] = Passage(gates[triangle], lid)
            elif twin >= 0 and twin // 3 not in gates:
                gate = int(pocket[starts[twin]]), int(pocket[ends[twin]])
                gates[twin // 3] = (gate, *gates[triangle])
                waiting.append(twin // 3)
    return found
