"""Moving the hubs of fans within both kernels to where the fans change their shape least."""

from dataclasses import dataclass, replace

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.blending.meshes.distortion import Shapes
from starskel.polar import as_complex, as_points
from starskel.predicates import ROUNDING
from starskel.task import Task

_STEPS = 30
"""The most Newton steps."""

_HALVINGS = 20
"""The most halvings of a step that goes too far."""

_SETTLED = 1e-12
"""Hubs stay where a step lessens the distortion by less than this part."""

_SPREAD = 0.8
"""What is added to a triangle's stretch, in products of its two areas before: a triangle that keeps its shape
has 8 of these. Without it triangles may vanish, as long as they do in both shapes alike.
"""

_FLATTEST = 1e-6
"""The least curvature that a step reckons with, as a part of the largest."""


@dataclass(frozen=True, eq=False)
class FreeFans:
    """Fans of free hubs: each triangle's first corner is a hub, and belongs to it alone.

    Attributes
    ----------
    shapes : Shapes
    hubs : (h,) array
        Their points.
    triangles : (k, 3) array
    owners : (k,) array
        For each triangle the place of its hub among the hubs.
    spread : (k,) array
        What keeps each triangle from getting small.
    """

    shapes: Shapes
    hubs: Indices
    triangles: Indices
    owners: Indices
    spread: Floats

    def moved(self, steps: Floats) -> Shapes:
        """Move the hubs by (h, 4) steps: in the source, and in the target."""
        source, target = self.shapes.source.copy(), self.shapes.target.copy()
        source[self.hubs] += as_complex(steps[:, :2])
        target[self.hubs] += as_complex(steps[:, 2:])
        return replace(self.shapes, source=source, target=target)

    def distortions(self, shapes: Shapes) -> Floats:
        """Give the distortion of each fan, infinite where a triangle loses its area."""
        each = shapes.distortions(self.triangles, self.spread)
        each[~shapes.have_area(self.triangles)] = np.inf
        return np.bincount(self.owners, each, len(self.hubs)).astype(np.float64)


def with_hubs_moved(shapes: Shapes, triangles: Indices, free: int, task: Task) -> Shapes:
    """Move all hubs at once, as no triangle has two of them, by damped Newton steps.

    Parameters
    ----------
    shapes : Shapes
    triangles : (k, 3) array
        Fans, the hub first.
    free : int
        Points from this one on are hubs that may move.
    task : Task

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    fans = free_fans(shapes, triangles, free)
    for _ in range(_STEPS if len(fans.hubs) else 0):
        task.reach(0)
        before = fans.distortions(fans.shapes)
        steps, after = _damped(fans, _newton_steps(fans), before)
        fans = replace(fans, shapes=fans.moved(steps))
        if (before - after <= _SETTLED * before).all():
            break
    return fans.shapes


def free_fans(shapes: Shapes, triangles: Indices, free: int) -> FreeFans:
    """Leave out hubs that have triangles without area: their kernels have none either."""
    own = triangles[triangles[:, 0] >= free]
    fixed = np.unique(own[~shapes.have_area(own), 0])
    own = own[~np.isin(own[:, 0], fixed)]
    hubs, owners = np.unique(own[:, 0], return_inverse=True)
    return FreeFans(shapes, hubs, own, owners, _SPREAD * np.multiply(*shapes.areas(own)))


def _damped(fans: FreeFans, steps: Floats, before: Floats) -> tuple[Floats, Floats]:
    """Halve each hub's step until the distortion of its fan grows less; give it up in the end."""
    scale = np.ones(len(before))
    for _ in range(_HALVINGS):
        after = fans.distortions(fans.moved(steps * scale[:, None]))
        worse = ~(after < before)
        if not worse.any():
            break
        scale[worse] /= 2
    scale[worse] = 0.0
    return steps * scale[:, None], np.where(worse, before, after)


def _newton_steps(fans: FreeFans) -> Floats:
    """Give the steps to where the second-order models of the fans' distortions are least.

    Along directions in which a model is not convex, its curvature is turned over.
    """
    gradients, curvatures = derivatives(fans)
    values, vectors = np.linalg.eigh(curvatures)
    values = np.abs(values)
    values = np.maximum(values, np.maximum(_FLATTEST * values.max(axis=1, keepdims=True), ROUNDING))
    along = np.einsum("hij,hi->hj", vectors, gradients) / values
    return np.asarray(-np.einsum("hij,hj->hi", vectors, along))


def derivatives(fans: FreeFans) -> tuple[Floats, Floats]:
    """Give the gradients (h, 4) and the second derivatives (h, 4, 4) of the fans' distortions.

    A triangle's distortion is a product: of its stretch and of the mean reciprocal of its areas.
    """
    source = _sides(fans.shapes.source[fans.triangles])
    target = _sides(fans.shapes.target[fans.triangles])
    stretch, stretch_slope, stretch_bend = _stretch(source, target)
    stretch += fans.spread
    inverse, inverse_slope, inverse_bend = _reciprocals(
        source[2], target[2], *fans.shapes.areas(fans.triangles)
    )
    mixed = stretch_slope[:, :, None] * inverse_slope[:, None, :]
    slopes = inverse[:, None] * stretch_slope + stretch[:, None] * inverse_slope
    bends = inverse[:, None, None] * stretch_bend + stretch[:, None, None] * inverse_bend
    bends += mixed + mixed.transpose(0, 2, 1)
    gradients, curvatures = np.zeros((len(fans.hubs), 4)), np.zeros((len(fans.hubs), 4, 4))
    np.add.at(gradients, fans.owners, slopes)
    np.add.at(curvatures, fans.owners, bends)
    return gradients, curvatures


_Sides = tuple[Floats, Floats, Floats]
"""The (k, 2) spokes from the hubs to the two other corners of triangles, and the sides between these."""


def _sides(corners: Complex) -> _Sides:
    points = as_points(corners)
    first, second = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    return first, second, second - first


def _dot(first: Floats, second: Floats) -> Floats:
    return np.asarray((first * second).sum(axis=1))


def _stretch(source: _Sides, target: _Sides) -> tuple[Floats, Floats, Floats]:
    """Give |u|^2 |q|^2 + |v|^2 |p|^2 - 2 (u.v)(p.q) of spokes u, v and p, q, with its derivatives."""
    (u, v, across), (p, q, beyond) = source, target
    uu, vv, uv, pp, qq, pq = (_dot(*two)[:, None] for two in ((u, u), (v, v), (u, v), (p, p), (q, q), (p, q)))
    slope = 2 * np.concatenate([(u + v) * pq - u * qq - v * pp, (p + q) * uv - p * vv - q * uu], axis=1)
    bend = np.zeros((len(u), 4, 4))
    bend[:, :2, :2] = 2 * _dot(beyond, beyond)[:, None, None] * np.eye(2)
    bend[:, 2:, 2:] = 2 * _dot(across, across)[:, None, None] * np.eye(2)
    bend[:, :2, 2:] = -2 * across[:, :, None] * beyond[:, None, :]
    bend[:, 2:, :2] = bend[:, :2, 2:].transpose(0, 2, 1)
    return (uu * qq + vv * pp - 2 * uv * pq)[:, 0], slope, bend


def _reciprocals(across: Floats, beyond: Floats, *areas: Floats) -> tuple[Floats, Floats, Floats]:
    """Give (1 / area + 1 / area') / 4 of triangles with these sides across, with its derivatives."""
    value, slopes, bend = np.zeros(len(across)), [], np.zeros((len(across), 4, 4))
    for part, side, area in zip((slice(2), slice(2, 4)), (across, beyond), areas, strict=True):
        # an area loses half the cross product of the hub's step and the side across
        change = np.stack([-side[:, 1], side[:, 0]], axis=1) / 2
        value += 1 / area / 4
        slopes.append(-change / area[:, None] ** 2 / 4)
        bend[:, part, part] = change[:, :, None] * change[:, None, :] / area[:, None, None] ** 3 / 2
    return value, np.concatenate(slopes, axis=1), bend
