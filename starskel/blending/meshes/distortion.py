"""How far a triangle's affine map is from a rigid motion, both ways alike."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Flags, Floats, Indices
from starskel.blending.meshes.mesh import triangle_areas

_LEAST_AREA = 1e-9
"""Triangles under this part of the whole area count as having none."""


@dataclass(frozen=True, eq=False)
class Shapes:
    """The points of two corresponding triangulations, each in the unit that makes its whole area 1.

    Attributes
    ----------
    source, target : (m,) arrays
    units : two floats
        The units' lengths.
    """

    source: Complex
    target: Complex
    units: tuple[float, float]

    @classmethod
    def of(cls, source: Complex, target: Complex, triangles: Indices) -> "Shapes":
        """Choose the units."""
        units = [float(np.sqrt(triangle_areas(z[triangles]).sum())) for z in (source, target)]
        return cls(
            (source - source.mean()) / units[0], (target - target.mean()) / units[1], (units[0], units[1])
        )

    def areas(self, triangles: Indices) -> tuple[Floats, Floats]:
        """Give the areas of (..., 3) triangles in source and target."""
        return triangle_areas(self.source[triangles]), triangle_areas(self.target[triangles])

    def have_area(self, triangles: Indices) -> Flags:
        """Tell which of (k, 3) triangles have an area in both, and run counter-clockwise."""
        first, second = self.areas(triangles)
        return np.asarray((first > _LEAST_AREA) & (second > _LEAST_AREA))

    def distortions(self, triangles: Indices, spread: Floats | float = 0.0) -> Floats:
        """Give the symmetric Dirichlet energies of the maps of (..., 3) triangles.

        That is the sum of the squared singular values of the map times the area in the source, and of the
        inverse map times that in the target (Schreiner, Asirvatham, Praun and Hoppe 2004, "Inter-Surface
        Mapping"). Areas count as no less than the least. What is given as spread, in squared areas, makes
        small triangles dear even where they keep their shape.
        """
        a, b = (np.maximum(area, _LEAST_AREA) for area in self.areas(triangles))
        u, v = _spokes(self.source[triangles])
        p, q = _spokes(self.target[triangles])
        stretch = np.abs(u * q) ** 2 + np.abs(v * p) ** 2 - 2 * (u.conj() * v).real * (p.conj() * q).real
        return np.asarray((stretch + spread) * (1 / a + 1 / b) / 4)


def _spokes(corners: Complex) -> tuple[Complex, Complex]:
    return corners[..., 1] - corners[..., 0], corners[..., 2] - corners[..., 0]
