"""Corresponding triangulations of both polygons, and how their edges wish to turn."""

from collections import deque
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Flags, Floats, Indices
from starskel.blending.meshes.fans import Fans
from starskel.polar import PolarVectors, as_complex


@dataclass(frozen=True, eq=False)
class Mesh:
    """Points, triangles and edges.

    Attributes
    ----------
    source, target : (m,) arrays
        The points as complex numbers; the first ones are the rings.
    triangles : (k, 3) array
        Corners, counter-clockwise.
    edges : (e, 2) array
        Ends of each edge, the lower index first.
    sides : (k, 3) array
        The edges of each triangle, side c from corner c to the next.
    on_ring : (e,) array of bool
        Which edges belong to the polygons' outlines.
    wishes : PolarVectors
        The edges, each turning evenly by its own rotation.
    source_areas, target_areas : (k,) arrays
        The triangles' areas.
    """

    source: Complex
    target: Complex
    triangles: Indices
    edges: Indices
    sides: Indices
    on_ring: Flags
    wishes: PolarVectors
    source_areas: Floats
    target_areas: Floats

    @property
    def size(self) -> float:
        """The larger polygon's extent, twice the largest distance from the mean of its points."""
        return float(2 * max(np.abs(z - z.mean()).max() for z in (self.source, self.target)))

    @property
    def lengths(self) -> Floats:
        """For each edge the mean of its two lengths, (e,)."""
        return (self.wishes.source_lengths + self.wishes.target_lengths) / 2


def mesh_of(fans: Fans) -> Mesh:
    """Link the fans of a pair."""
    source, target = as_complex(fans.source), as_complex(fans.target)
    triangles = fans.triangles
    ends = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, sides = np.unique(ends, axis=0, return_inverse=True)
    sides = sides.reshape(-1, 3)
    areas = triangle_areas(source[triangles]), triangle_areas(target[triangles])
    vectors = [z[edges[:, 1]] - z[edges[:, 0]] for z in (source, target)]
    first = int(np.minimum(areas[0] / areas[0].sum(), areas[1] / areas[1].sum()).argmax())
    bends = corner_angles(target[triangles]) - corner_angles(source[triangles])
    rotation = float(np.angle(vectors[1][sides[first, 0]] / vectors[0][sides[first, 0]]))
    return Mesh(
        source=source,
        target=target,
        triangles=triangles,
        edges=edges,
        sides=sides,
        on_ring=np.bincount(sides.ravel()) == 1,
        wishes=PolarVectors.between(
            vectors[0], vectors[1], _unwrapped(sides, bends, first, rotation, len(edges))
        ),
        source_areas=areas[0],
        target_areas=areas[1],
    )


def triangle_areas(corners: Complex) -> Floats:
    """Give the signed areas of triangles with (..., 3) corners."""
    first, second = corners[..., 1] - corners[..., 0], corners[..., 2] - corners[..., 0]
    return np.asarray((first.real * second.imag - first.imag * second.real) / 2)


def corner_angles(corners: Complex) -> Floats:
    """Give the (..., 3) inner angles of triangles that run counter-clockwise but for rounding, in [0, pi]."""
    ahead = np.roll(corners, -1, axis=-1) - corners
    back = np.roll(corners, 1, axis=-1) - corners
    turned = back * ahead.conj()
    return np.asarray(np.arctan2(np.maximum(turned.imag, 0.0), turned.real))


def _unwrapped(sides: Indices, bends: Floats, first: int, rotation: float, count: int) -> Floats:
    """Carry the rotation of a triangle's first side over all edges.

    Round a corner, from the edge ahead to the edge back, the rotation changes by what the angle between
    them gains. Breadth-first, so that rounding adds up over few triangles.
    """
    offsets = np.stack([np.zeros(len(sides)), -bends[:, 1], bends[:, 0]], axis=1).tolist()
    edges = sides.tolist()
    owners: list[list[int]] = [[] for _ in range(count)]
    for triangle, own in enumerate(edges):
        for edge in own:
            owners[edge].append(triangle)
    rotations = [0.0] * count
    rotations[edges[first][0]] = rotation
    waiting, reached = deque([(first, rotation)]), {first}
    while waiting:
        triangle, base = waiting.popleft()
        for edge, offset in zip(edges[triangle], offsets[triangle], strict=True):
            rotations[edge] = base + offset
            for other in owners[edge]:
                if other not in reached:
                    reached.add(other)
                    waiting.append((other, base + offset - offsets[other][edges[other].index(edge)]))
    return np.array(rotations)
