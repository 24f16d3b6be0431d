"""How much the inside of a blend is distorted: the fans of its star pieces, triangle by triangle."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats
from starskel.blending.meshes.distortion import Shapes
from starskel.blending.meshes.fans import origin_fans
from starskel.blending.meshes.mesh import triangle_areas
from starskel.decomposition.pieces import Decomposition
from starskel.polar import as_complex


@dataclass(frozen=True)
class Distortion:
    """Factors of at least 1, over all triangles that have an area in both shapes, and all frames.

    Attributes
    ----------
    stretch, worst_stretch : float
        The conformal distortion beyond what the pair demands. The ratio of the singular values of a
        triangle's map, K, measures how much it is stretched; its logarithm is a distance between shapes of
        triangles. So K(source, frame) K(frame, target) is never below K(source, target). Here is the root of
        their quotient: the mean (of logarithms, weighted by the triangles' areas), and the worst.
    spread, worst_spread : float
        The area over the linear blend of the areas, or the other way round: likewise.
    folded : float
        The largest part of the area, in any frame, whose triangles are turned over or lack area there. They
        count in no factor.
    """

    stretch: float
    worst_stretch: float
    spread: float
    worst_spread: float
    folded: float


class Triangles:
    """The fans of a decomposition round star origins.

    Parameters
    ----------
    decomposition : Decomposition
        Its pieces name the rows of points; the star origins follow behind these.
    source, target : (m + pieces, 2) arrays
        The points of both shapes.
    """

    def __init__(self, decomposition: Decomposition, source: Floats, target: Floats) -> None:
        triangles = origin_fans(decomposition)
        self._source, self._target = as_complex(source), as_complex(target)
        shapes = Shapes.of(self._source, self._target, triangles)
        self._triangles = triangles[shapes.have_area(triangles)]
        shares = shapes.areas(self._triangles)
        self._weights = (shares[0] + shares[1]) / (shares[0] + shares[1]).sum()

    def logarithms(self, points: Floats, ts: Floats) -> tuple[Floats, Floats]:
        """Give the logarithms of both factors for each frame and triangle; nan where it is folded."""
        ends = self._source[self._triangles], self._target[self._triangles]
        corners = as_complex(points)[:, self._triangles]
        areas, t = triangle_areas(corners), ts[:, None]
        open_ = np.where(areas > 0, areas, np.nan)
        wanted = (1 - t) * triangle_areas(ends[0]) + t * triangle_areas(ends[1])
        on_the_way = _distances(ends[0], corners) + _distances(corners, ends[1])
        return (on_the_way - _distances(*ends)) / 2, np.abs(np.log(open_ / wanted))

    def distortion(self, stretches: Floats, spreads: Floats) -> Distortion:
        """Sum up the logarithms of all frames."""
        folded = np.isnan(spreads)
        weights = np.where(folded, 0, self._weights)

        def factors(logarithms: Floats) -> tuple[float, float]:
            found = np.maximum(np.where(folded, 0, logarithms), 0)  # rounding may leave them below
            return float(np.exp((weights * found).sum() / weights.sum())), float(np.exp(found.max()))

        return Distortion(*factors(stretches), *factors(spreads), float((folded @ self._weights).max()))


def _distances(first: Complex, second: Complex) -> Floats:
    """Give the logarithms of the ratios of singular values of the maps between (..., 3) triangles."""
    u, v = first[..., 1] - first[..., 0], first[..., 2] - first[..., 0]
    p, q = second[..., 1] - second[..., 0], second[..., 2] - second[..., 0]
    squares = np.abs(u * q) ** 2 + np.abs(v * p) ** 2 - 2 * (u.conj() * v).real * (p.conj() * q).real
    areas = (u.conj() * v).imag * (p.conj() * q).imag
    cosh = np.divide(squares, 2 * areas, out=np.full(squares.shape, np.nan), where=areas > 0)
    return np.asarray(np.arccosh(np.maximum(cosh, 1)))
