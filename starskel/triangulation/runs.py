"""Vertices on straight runs: left out while corners are triangulated, and put back."""

from itertools import pairwise

import numpy as np

from starskel.arrays import Flags, Indices
from starskel.rings import Rings

Triangle = tuple[int, int, int]


def runs_of(corner: Flags, rings: Rings) -> dict[tuple[int, int], list[int]]:
    """Give for each edge between corners the straight vertices on it, in order, if there are any."""
    runs = {}
    for start in np.flatnonzero(corner & ~corner[rings.following]).tolist():
        run = []
        vertex = int(rings.following[start])
        while not corner[vertex]:
            run.append(vertex)
            vertex = int(rings.following[vertex])
        runs[start, vertex] = run
    return runs


def split(triangles: Indices, runs: dict[tuple[int, int], list[int]]) -> Indices:
    """Split triangles at straight vertices into fans from the opposite corner."""
    waiting: list[Triangle] = triangles.tolist()
    done: list[Triangle] = []
    while waiting:
        a, b, c = waiting.pop()
        for p, q, apex in ((a, b, c), (b, c, a), (c, a, b)):
            if (p, q) in runs:
                waiting += [(v, w, apex) for v, w in pairwise([p, *runs.pop((p, q)), q])]
                break
        else:
            done.append((a, b, c))
    return np.array(done)
