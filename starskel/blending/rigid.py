"""As-rigid-as-possible blending (Alexa, Cohen-Or and Levin 2000) on the fans of the star pieces."""

from starskel.blending.fan_blend import FanBlend, Motion
from starskel.blending.meshes.fans import Fans
from starskel.blending.meshes.improvement import with_better_edges
from starskel.blending.meshes.mesh import mesh_of
from starskel.blending.rigid_triangles import RigidTriangles
from starskel.task import Task


class RigidBlend(FanBlend):
    """Every triangle turns evenly and stretches evenly; the points come as near to that as can be.

    What a triangle asks for counts by its area, in source and target alike.
    """

    method = "rigid"

    def _prepared(self, fans: Fans, task: Task) -> Motion:
        self._fans = with_better_edges(fans, task)
        mesh = mesh_of(self._fans)
        task.reach(0.6)
        return RigidTriangles.of(mesh).points
