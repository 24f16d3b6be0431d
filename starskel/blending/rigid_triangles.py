"""Triangles that turn and stretch by themselves, and the points that come nearest to all of them.

M. Alexa, D. Cohen-Or, D. Levin, "As-Rigid-As-Possible Shape Interpolation" (SIGGRAPH 2000): the affine map A
of a triangle is a rotation R(angle) times a stretch S, and at t it is R(t angle) ((1 - t) I + t S). An edge a
that becomes b is then R(t angle) ((1 - t) a + t R(-angle) b), which is the same from the target backwards.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.blending.laplacian import Factored, factor
from starskel.blending.meshes.mesh import Mesh
from starskel.polar import as_complex, as_points
from starskel.predicates import ROUNDING

_FLATTEST = 0.01
"""Triangles lower than this part of their longest side insist no more than one of that height."""

_FAINT = 1e-6
"""How much every side insists at least: triangles without area alone would leave points loose."""


@dataclass(frozen=True, eq=False)
class RigidTriangles:
    """The least-squares problem, factored.

    Attributes
    ----------
    rotations : (k,) array
        By how much each triangle turns, whole turns included.
    source_pulls, target_pulls : (k, 3) arrays
        How the triangles, not turned, pull at their corners at t = 0 and, turned back, at t = 1.
    corners : (3 k,) array, firsts : (m,) array
        All corners of triangles, ordered by point; and where each point's begin.
    matrix : Factored
        The normal equations.
    """

    rotations: Floats
    source_pulls: Complex
    target_pulls: Complex
    corners: Indices
    firsts: Indices
    matrix: Factored

    @classmethod
    def of(cls, mesh: Mesh) -> "RigidTriangles":
        """Factor the problem, the first point held, as it leaves the place free."""
        count = len(mesh.source)
        weights = side_weights(mesh)
        rotations = triangle_rotations(mesh)
        by_edge = np.zeros(len(mesh.edges))
        np.add.at(by_edge, mesh.sides, weights)
        held = np.zeros(count)
        held[0] = np.abs(by_edge).max()
        corners = np.argsort(mesh.triangles.ravel(), kind="stable")
        return cls(
            rotations=rotations,
            source_pulls=_pulls(mesh.source[mesh.triangles], weights),
            target_pulls=_pulls(mesh.target[mesh.triangles], weights) * np.exp(-1j * rotations)[:, None],
            corners=corners,
            firsts=np.searchsorted(mesh.triangles.ravel()[corners], np.arange(count)),
            matrix=factor(mesh.edges, by_edge, held),
        )

    def points(self, ts: Floats) -> Complex:
        """Give all points of the mesh at each t, (k, m), up to a translation."""
        t = ts[:, None, None]
        turned = np.exp(1j * ts[:, None] * self.rotations)[:, :, None]
        pulls = turned * ((1 - t) * self.source_pulls + t * self.target_pulls)
        right = np.add.reduceat(pulls.reshape(len(ts), -1)[:, self.corners], self.firsts, axis=1)
        return as_complex(self.matrix.solve(as_points(right)))


def triangle_rotations(mesh: Mesh) -> Floats:
    """Give the (k,) angles of the triangles' rotations, in radians, unwrapped over the mesh.

    That of the polar decomposition; its direction is finite where an area is 0. No edge turns by more than a
    quarter turn more or less than its triangle, so the mean of their rotations tells the whole turns. Where
    there is no area in either shape, the edges themselves tell the rotation.
    """
    a, b = mesh.source[mesh.triangles], mesh.target[mesh.triangles]
    u, v, p, q = a[:, 1] - a[:, 0], a[:, 2] - a[:, 0], b[:, 1] - b[:, 0], b[:, 2] - b[:, 0]
    # the part of the affine map that is a rotation and a scaling, times the area in the source
    conformal = 1j * (p * v.conj() - q * u.conj())
    lengths = mesh.lengths[mesh.sides]
    mean = (mesh.wishes.rotations[mesh.sides] * lengths).sum(axis=1) / lengths.sum(axis=1)
    flat = np.maximum(_height(a), _height(b)) <= np.sqrt(ROUNDING)
    angles = np.where(flat, mean, np.angle(np.where(flat, 1.0, conformal)))
    return np.asarray(angles + 2 * np.pi * np.round((mean - angles) / (2 * np.pi)))


def side_weights(mesh: Mesh) -> Floats:
    """Give how much each side of each triangle insists, (k, 3): the sums for source and target.

    The squared Frobenius norm of the difference of two affine maps of a triangle, times its area, is half the
    sum over its sides of the cotangent of the angle opposite times the squared difference of what becomes of
    the side (Pinkall and Polthier 1993). Both shapes count, the blend being that of either with the other.
    """
    return _cotangents(mesh.source[mesh.triangles]) + _cotangents(mesh.target[mesh.triangles]) + _FAINT


def _cotangents(corners: Complex) -> Floats:
    """Give half the cotangents opposite the sides of (k, 3) corners; flat triangles' are reduced."""
    apexes = np.roll(corners, 1, axis=1)
    u, v = corners - apexes, np.roll(corners, -1, axis=1) - apexes
    longest = np.abs(u).max(axis=1) ** 2
    doubled = np.maximum(_height(corners), _FLATTEST) * longest
    return np.asarray((u.conj() * v).real / (2 * doubled[:, None]))


def _height(corners: Complex) -> Floats:
    """Give the heights of triangles over their longest sides, as parts of these."""
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    longest = np.maximum(np.maximum(np.abs(u), np.abs(v)), np.abs(v - u))
    return np.asarray(np.abs((u.conj() * v).imag) / longest**2)


def _pulls(corners: Complex, weights: Floats) -> Complex:
    """Give for each corner the weighted sum of the sides that end there, less those that start there."""
    pulls = weights * (np.roll(corners, -1, axis=1) - corners)
    return np.asarray(np.roll(pulls, 1, axis=1) - pulls)
