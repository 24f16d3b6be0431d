"""Ways through a triangulated region, none of which crosses those before it.

A way leads over the middles of edges between triangles, the gates, and is the shortest of these. It cuts the
triangles that it crosses; what it runs along is a wall from then on. As long as ways between rings close no
circle, all that is left of the region hangs together: so there is always a way to the next ring.
"""

from collections import defaultdict
from heapq import heappop, heappush
from itertools import count, pairwise

import numpy as np
import shapely

from starskel.arrays import Complex
from starskel.shapes.holes.region import Region

Place = frozenset[int]
"""A vertex, or the gate between two."""


class TriangulatedRegion:
    """A region cut into triangles, and the ways through it so far.

    Parameters
    ----------
    region : Region
    """

    def __init__(self, region: Region) -> None:
        self._points = (region.rows @ [1, 1j]).tolist()
        name = {point: number for number, point in enumerate(self._points)}
        parts = shapely.get_coordinates(shapely.constrained_delaunay_triangles(region.area))
        corners = (parts.reshape(-1, 4, 2)[:, :3] @ [1, 1j]).tolist()
        self._triangles = {frozenset(name[point] for point in own) for own in corners}
        self._walls = {frozenset(edge) for edge in enumerate(region.following.tolist())}

    def draw(self, start: int, end: int) -> Complex | None:
        """Draw the next way between two vertices.

        Returns
        -------
        (k,) array of its points, start and end among them; None if no triangle lies between.
        """
        way = self._shortest(frozenset([start]), frozenset([end]))
        if way is None:
            return None
        names = [self._name(place) for place in way]
        for (here, there), (first, second) in zip(pairwise(way), pairwise(names), strict=True):
            self._walls.add(frozenset([first, second]))
            if len(here | there) == 3:
                self._split(here, there, first, second)
        return np.array([self._points[name] for name in names])

    def _shortest(self, start: Place, end: Place) -> list[Place] | None:
        """Find the shortest way (Dijkstra 1959)."""
        ways = self._ways(start, end)
        before: dict[Place, Place | None] = {}
        number = count()
        waiting: list[tuple[float, int, Place, Place | None]] = [(0.0, next(number), start, None)]
        while waiting and end not in before:
            length, _, place, last = heappop(waiting)
            if place not in before:
                before[place] = last
                for other in ways[place]:
                    step = abs(self._at(other) - self._at(place))
                    heappush(waiting, (length + step, next(number), other, place))
        if end not in before:
            return None
        way = [end]
        while (last := before[way[-1]]) is not None:
            way.append(last)
        return way[::-1]

    def _ways(self, start: Place, end: Place) -> dict[Place, list[Place]]:
        """Give where a way may lead from each place: across triangles, or along an edge to the end."""
        ways: dict[Place, list[Place]] = defaultdict(list)
        for triangle in sorted(map(sorted, self._triangles)):
            edges = [frozenset(triangle) - {corner} for corner in triangle]
            gates = [edge for edge in edges if edge not in self._walls]
            for gate in gates:
                ways[gate] += [other for other in gates if other != gate]
                (corner,) = frozenset(triangle) - gate
                if start == {corner}:
                    ways[start].append(gate)
                if end == {corner}:
                    ways[gate].append(end)
            if start | end in gates:
                ways[start].append(end)
        return ways

    def _at(self, place: Place) -> complex:
        return complex(sum(self._points[name] for name in sorted(place)) / len(place))

    def _name(self, place: Place) -> int:
        """Give the vertex at a place; a gate gets a new one."""
        if len(place) == 1:
            (name,) = place
            return name
        self._points.append(self._at(place))
        return len(self._points) - 1

    def _split(self, here: Place, there: Place, first: int, second: int) -> None:
        """Cut the triangle between two places."""
        self._triangles.remove(here | there)
        if here & there:
            (apex,) = here & there
            (one,), (other,) = here - there, there - here
            parts = [(apex, first, second), (first, one, other), (first, other, second)]
        else:
            corner, middle, gate = (first, second, there) if len(here) == 1 else (second, first, here)
            parts = [(corner, middle, side) for side in sorted(gate)]
        self._triangles |= {frozenset(part) for part in parts}
