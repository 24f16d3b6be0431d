"""One linear least-squares problem over all fans, factored once; a product or two for every frame."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.blending.laplacian import Factored, factor
from starskel.blending.meshes.distortion import Shapes
from starskel.blending.meshes.mesh import Mesh, triangle_areas
from starskel.polar import as_complex, as_points

SHORTEST_EDGE = 1e-3
"""Edges shorter than this part of the size count as so long."""

SMOOTHED_OVER = 0.3
"""How far area corrections are smoothed, as a part of the size."""

SWOLLEN, SQUEEZED = 4.0, 1.5
"""The largest factors by which a triangle's area is corrected at once, downwards and upwards.

Squeezed triangles must not make up for swollen ones: a mean of both would leave the whole too large.
"""

STRAY = 0.1
"""How far the logarithm of the whole area strays from that of its linear blend, at most.

Gross deviations are scaled away; small ones are left, as parts that keep their shape would pulse.
"""

PASSES = 2
"""How often areas are corrected: more often gains little."""

MOST_DISTORTED = 10.0
"""Distortions count as no more than this, and as this where triangles have no area."""

_LEAST_MASS = 1e-3
"""The least mass of a triangle, as a part of the mean: no point may be left without any."""


@dataclass(frozen=True, eq=False)
class Graph:
    """What does not change while weights do: the mesh, which edges end where.

    Attributes
    ----------
    mesh : Mesh
    ends : (2 e,) array
        All ends of edges, ordered by point: edge i as i where it ends, as i + e where it starts.
    firsts : (m,) array
        Where each point's begin.
    corners : (3 k,) array, corner_firsts : (m,) array
        All corners of triangles, ordered by point, as triangles; and where each point's begin.
    smoothing : Factored
        Spreads what is wanted of triangles smoothly over the points.
    masses : (k,) array
        A third of each triangle's share of the area, the mean of source and target.
    """

    mesh: Mesh
    ends: Indices
    firsts: Indices
    corners: Indices
    corner_firsts: Indices
    smoothing: Factored
    masses: Floats


def graph_of(mesh: Mesh) -> Graph:
    """Prepare what all weights share."""
    count = len(mesh.source)
    points = mesh.edges.T[::-1].ravel()
    ends = np.argsort(points, kind="stable")
    corners = np.argsort(mesh.triangles.ravel(), kind="stable")
    every = np.arange(count)
    shares = mesh.source_areas / mesh.source_areas.sum() + mesh.target_areas / mesh.target_areas.sum()
    masses = shares / 6
    held = np.maximum(masses, _LEAST_MASS * masses.mean())
    at_points = _sums(mesh.triangles, held, count)
    at_edges = _sums(mesh.sides, held, len(mesh.edges))
    stiffness = at_edges * (SMOOTHED_OVER / _relative_lengths(mesh)) ** 2
    return Graph(
        mesh=mesh,
        ends=ends,
        firsts=np.searchsorted(points[ends], every),
        corners=corners // 3,
        corner_firsts=np.searchsorted(mesh.triangles.ravel()[corners], every),
        smoothing=factor(mesh.edges, stiffness, at_points),
        masses=masses,
    )


@dataclass(frozen=True, eq=False)
class Stitch:
    """A least-squares problem, factored: each edge wishes to be its own vector, turned evenly.

    Attributes
    ----------
    graph : Graph
    weights : (e,) array
        How much each edge insists.
    area_share : float
        0 leaves areas as they come, 1 corrects them in full at the expense of lengths.
    matrix : Factored
        The normal equations.
    """

    graph: Graph
    weights: Floats
    area_share: float
    matrix: Factored

    @classmethod
    def of(cls, graph: Graph, weights: Floats, area_share: float) -> "Stitch":
        """Factor the problem with these weights, the first point held, as they leave the place free."""
        held = np.zeros(len(graph.mesh.source))
        held[0] = weights.max()
        return cls(graph, weights, area_share, factor(graph.mesh.edges, weights, held))

    def points(self, ts: Floats) -> Complex:
        """Give all points of the mesh at each t, (k, m), up to a translation."""
        wishes = self.graph.mesh.wishes.at(ts)
        points = self._nearest(wishes)
        i, j = self.graph.mesh.edges.T
        for _ in range(PASSES if self.area_share else 0):
            growth = self._growth(points, ts)
            wishes = wishes * np.exp((growth[:, i] + growth[:, j]) / 2)
            points = self._nearest(wishes)
        return points * self._whole_scale(points, ts)[:, None]

    def _nearest(self, wishes: Complex) -> Complex:
        """Solve: the points whose edges come nearest to the wishes."""
        pulls = wishes * self.weights
        both = np.concatenate([pulls, -pulls], axis=1)[:, self.graph.ends]
        right = np.add.reduceat(both, self.graph.firsts, axis=1)
        return as_complex(self.matrix.solve(as_points(right)))

    def _growth(self, points: Complex, ts: Floats) -> Floats:
        """Give for each point the logarithm of the factor by which edges there should grow.

        A triangle counts by its share of the area, the mean one or that at the time, whichever is less: what
        vanishes towards an end must not ask for anything there.
        """
        graph = self.graph
        mesh, t = graph.mesh, ts[:, None]
        wanted = (1 - t) * mesh.source_areas + t * mesh.target_areas
        there = np.clip(triangle_areas(points[:, mesh.triangles]), wanted / SQUEEZED, wanted * SWOLLEN)
        has_area = wanted > 0
        lacking = np.log(np.where(has_area, wanted, 1.0) / np.where(has_area, there, 1.0))
        masses = np.minimum(graph.masses, np.maximum(wanted, 0.0) / (3 * wanted.sum(axis=1, keepdims=True)))
        loads = (self.area_share / 2 * masses * lacking)[:, graph.corners]
        return graph.smoothing.solve(np.add.reduceat(loads, graph.corner_firsts, axis=1))

    def _whole_scale(self, points: Complex, ts: Floats) -> Floats:
        """Give for each t the factor that brings the whole area back to within `STRAY` of its linear blend.

        Scaling makes nothing cross. Of a deviation of g, as a logarithm, g / (1 + (g / (2 STRAY))^2) is left.
        """
        mesh = self.graph.mesh
        wanted = (1 - ts) * mesh.source_areas.sum() + ts * mesh.target_areas.sum()
        there = triangle_areas(points[:, mesh.triangles]).sum(axis=1)
        excess = np.log(np.maximum(there / wanted, 1 / SWOLLEN))
        taken = excess**3 / (excess**2 + (2 * STRAY) ** 2)
        return np.asarray(np.exp(-taken / 2))


def _relative_lengths(mesh: Mesh) -> Floats:
    return np.asarray(np.maximum(mesh.lengths / mesh.size, SHORTEST_EDGE))


def edge_weights(mesh: Mesh, on_ring: float, yielding: float) -> Floats:
    """Give the (e,) weights of the edges: 1 / length^2, those of the outline times a factor.

    Parts that keep their shape shall do so all the time: an edge inside insists the less the more its
    triangles are distorted from source to target, by that power of the distortion.
    """
    inside = edge_distortions(mesh) ** -yielding
    return np.asarray(np.where(mesh.on_ring, on_ring, inside) / _relative_lengths(mesh) ** 2)


def edge_distortions(mesh: Mesh) -> Floats:
    """Give (e,) geometric means of the distortions of edges' triangles, 1 where they keep their shape."""
    shapes = Shapes.of(mesh.source, mesh.target, mesh.triangles)
    least = 2 * np.add(*shapes.areas(mesh.triangles))
    has_area = shapes.have_area(mesh.triangles)
    ratios = np.where(has_area, shapes.distortions(mesh.triangles), np.inf) / np.where(has_area, least, 1.0)
    logarithms = np.log(np.clip(ratios, 1.0, MOST_DISTORTED))
    uses = np.bincount(mesh.sides.ravel(), minlength=len(mesh.edges))
    return np.asarray(np.exp(_sums(mesh.sides, logarithms, len(mesh.edges)) / uses))


def _sums(places: Indices, values: Floats, count: int) -> Floats:
    """Add each triangle's value at its three places."""
    sums = np.zeros(count)
    np.add.at(sums, places, values[:, None])
    return sums
