"""Dividing a mesh into small blocks of points by taking few points out of it."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Indices = NDArray[np.intp]

BLOCK = 96
"""The most points of a block; meshes up to twice as large stay whole."""

_HUB = 24
"""Points with more neighbours than this are taken out at once."""


@dataclass(frozen=True, eq=False)
class Dissection:
    """A division of the points of a graph: no edge leads from one block to another.

    Attributes
    ----------
    count : int
        The number of points.
    edges : (e, 2) array
        The graph.
    separator : (s,) array
        The points that separate the blocks.
    blocks : (b, w) array
        The points of each block, filled up by `count`.
    """

    count: int
    edges: Indices
    separator: Indices
    blocks: Indices

    @cached_property
    def places(self) -> tuple[Indices, Indices]:
        """For each point its block, or -1 in the separator; and its place there."""
        block, slot = np.full(self.count + 1, -1, dtype=np.intp), np.zeros(self.count + 1, dtype=np.intp)
        block[self.blocks] = np.arange(len(self.blocks))[:, None]
        slot[self.blocks] = np.arange(self.blocks.shape[1])
        slot[self.separator] = np.arange(len(self.separator))
        return block[:-1], slot[:-1]


def dissect(edges: Indices, count: int) -> Dissection:
    """Divide a connected graph."""
    if count <= 2 * BLOCK:
        return Dissection(count, edges, np.empty(0, dtype=np.intp), np.arange(count)[None])
    graph = _neighbours(edges, count)
    separator = {point for point in range(count) if len(graph[point]) > _HUB}
    waiting = _components(graph, (point for point in range(count) if point not in separator))
    done: list[list[int]] = []
    while waiting:
        part = waiting.pop()
        if len(part) <= BLOCK:
            done.append(part)
            continue
        layer = set(_thin_layer(graph, part))
        separator |= layer
        waiting += _components(graph, (point for point in part if point not in layer))
    return Dissection(count, edges, np.array(sorted(separator), dtype=np.intp), _packed(done, count))


def _neighbours(edges: Indices, count: int) -> list[list[int]]:
    graph: list[list[int]] = [[] for _ in range(count)]
    for i, j in edges.tolist():
        graph[i].append(j)
        graph[j].append(i)
    return graph


def _components(graph: list[list[int]], points: Iterable[int]) -> list[list[int]]:
    """Give the connected parts that these points form without the others."""
    left = dict.fromkeys(points)  # keeps their order, which a set would not
    found = []
    while left:
        part = [left.popitem()[0]]
        for point in part:
            for other in graph[point]:
                if other in left:
                    del left[other]
                    part.append(other)
        found.append(part)
    return found


def _thin_layer(graph: list[list[int]], part: list[int]) -> list[int]:
    """Give the smallest breadth-first layer near the middle of a connected part, seen from an end."""
    end = _layers(graph, part, part[0])[-1][-1]
    layers = _layers(graph, part, end)
    reached = np.cumsum([len(layer) for layer in layers])
    middle = [k for k, seen in enumerate(reached) if len(part) / 4 <= seen <= len(part) * 3 / 4]
    if middle:
        return min((layers[k] for k in middle), key=len)
    return [max(part, key=lambda point: len(graph[point]))]


def _layers(graph: list[list[int]], part: list[int], start: int) -> list[list[int]]:
    left = set(part)
    left.discard(start)
    layers = [[start]]
    while layers[-1]:
        following = []
        for point in layers[-1]:
            for other in graph[point]:
                if other in left:
                    left.discard(other)
                    following.append(other)
        layers.append(following)
    return layers[:-1]


def _packed(parts: list[list[int]], count: int) -> Indices:
    """Put small parts together, as many as fit into a block."""
    blocks: list[list[int]] = []
    for part in sorted(parts, key=len, reverse=True):
        home = next((block for block in blocks if len(block) + len(part) <= BLOCK), None)
        if home is None:
            blocks.append(list(part))
        else:
            home += part
    width = max(map(len, blocks), default=1)
    rows = [block + [count] * (width - len(block)) for block in blocks]
    return np.array(rows, dtype=np.intp).reshape(-1, width)
