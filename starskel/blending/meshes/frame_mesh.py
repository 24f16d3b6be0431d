"""The triangles that a blend moves, for what is to be carried along inside the frame."""

from dataclasses import dataclass
from typing import Protocol

from starskel.arrays import Floats, Indices


@dataclass(frozen=True, eq=False)
class FrameMesh:
    """Corresponding triangulations of source and target.

    Attributes
    ----------
    source, target : (m, 2) arrays
        The nodes; the first ones are the rows of the pair.
    triangles : (k, 3) array of int
        Corners, counter-clockwise in both; a triangle may lack area. They tile both polygons.
    """

    source: Floats
    target: Floats
    triangles: Indices


class MeshBlend(Protocol):
    """A blend that moves a mesh, whose triangles are the same at all times."""

    @property
    def mesh(self) -> FrameMesh:
        """What is moved."""

    def mesh_at(self, t: float) -> Floats:
        """Give the (m, 2) nodes at t, the frame's rows first; triangles may be folded over in between."""
