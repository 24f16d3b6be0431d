"""The triangles that star pieces fall into: a fan round a hub that sees the whole piece, in both polygons."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.decomposition.kernels.kernel import star_points, star_vertices
from starskel.decomposition.pieces import Decomposition, edges_of
from starskel.points import Points, points_of
from starskel.rings import Rings
from starskel.task import Task


@dataclass(frozen=True, eq=False)
class Fans:
    """Corresponding triangulations of both polygons.

    Attributes
    ----------
    source, target : (m, 2) arrays
        The points: the vertices of the pair, Steiner vertices, then those hubs that are no vertices.
    triangles : (k, 3) array of int
        Corners, counter-clockwise; a triangle may lack area where vertices lie on a line.
    hubs : tuple of tuples of int
        For each piece the points whose mean stands for its origin: one hub, or the corners of a lone
        triangle.
    """

    source: Floats
    target: Floats
    triangles: Indices
    hubs: tuple[tuple[int, ...], ...]


def fans_of(decomposition: Decomposition, task: Task) -> Fans:
    """Cut every piece into a fan; a piece of three vertices stays one triangle.

    The hub is the centroid of the kernel, in each polygon its own. Where a kernel has no inside, the hub is
    a common star vertex, or the mean of all of them, whichever makes the best worst triangle.
    """
    points = [decomposition.source], [decomposition.target]
    count = len(decomposition.source)
    triangles: list[tuple[int, ...]] = []
    hubs: list[tuple[int, ...]] = []
    kernels = _hubs(decomposition, task)
    for piece in decomposition.pieces:
        if len(piece) == 3:
            triangles.append((piece[0], piece[1], piece[2]))
            hubs.append(piece)
            continue
        hub = next(kernels)
        if isinstance(hub, int):
            own = piece[hub]
        else:
            own, count = count, count + 1
            for side, place in zip(points, hub, strict=True):
                side.append(place[None])
        hubs.append((own,))
        triangles += [(own, a, b) for a, b in edges_of(piece) if own not in (a, b)]
    source, target = (np.concatenate(side) for side in points)
    return Fans(source, target, np.array(triangles, dtype=np.intp), tuple(hubs))


def origin_fans(decomposition: Decomposition) -> Indices:
    """Give the triangles round the star origins, which are numbered behind the points, as (k, 3) corners."""
    count = len(decomposition.source)
    return np.array(
        [(count + k, a, b) for k, piece in enumerate(decomposition.pieces) for a, b in edges_of(piece)],
        dtype=np.intp,
    )


def _exact_points(decomposition: Decomposition) -> tuple[Points, Points]:
    pair = decomposition.pair
    steiner = decomposition.source[len(pair) :], decomposition.target[len(pair) :]
    source, target = points_of(pair.source, pair.starts), points_of(pair.target, pair.starts)
    return source.with_free(steiner[0]), target.with_free(steiner[1])


def _hubs(decomposition: Decomposition, task: Task) -> Iterator[int | tuple[Floats, Floats]]:
    """Give for each piece of more than three vertices a point of both kernels.

    That is a place in each polygon, or a vertex by its place in the piece.
    """
    first, second = _exact_points(decomposition)
    pieces = [np.array(piece) for piece in decomposition.pieces if len(piece) > 3]
    (places, areas), (others, other_areas) = star_points((first, second), Rings.of(pieces), task)
    inside = (areas > 0) & (other_areas > 0)
    for number, piece in enumerate(pieces):
        task.reach(0)
        yield (places[number], others[number]) if inside[number] else _thin_hub(first, second, piece)


def _thin_hub(first: Points, second: Points, piece: Indices) -> int | tuple[Floats, Floats]:
    """Give a point of kernels without an inside: the best common star vertex, or the mean of all."""
    common = np.flatnonzero(star_vertices((first, second), Rings.of([piece])))
    source, target = first.coordinates[piece], second.coordinates[piece]
    mean = source[common].mean(axis=0), target[common].mean(axis=0)
    worst = [_worst(source, target, source[k], target[k], int(k)) for k in common]
    best = int(np.argmax(worst))
    return int(common[best]) if worst[best] >= _worst(source, target, *mean) else mean


def _worst(source: Floats, target: Floats, hub: Floats, other: Floats, vertex: int | None = None) -> float:
    """Give the least ratio of area to squared sides among a fan's triangles."""
    kept = np.ones(len(source), dtype=np.bool_)
    if vertex is not None:
        kept[[vertex - 1, vertex]] = False
    return min(
        float(_shapeliness(ring - place)[kept].min()) for ring, place in ((source, hub), (target, other))
    )


def _shapeliness(spokes: Floats) -> Floats:
    following = np.roll(spokes, -1, axis=0)
    areas = spokes[:, 0] * following[:, 1] - spokes[:, 1] * following[:, 0]
    squares = (spokes**2 + following**2 + (following - spokes) ** 2).sum(axis=1)
    return np.asarray(areas / squares)
