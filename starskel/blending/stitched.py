"""The stitched blend: every edge of every fan wishes to turn evenly, and all get as near to it as can be."""

from starskel.blending.fan_blend import FanBlend, Motion
from starskel.blending.fans import Fans
from starskel.blending.mesh import Mesh, mesh_of
from starskel.blending.stiffening import stiffened
from starskel.blending.stitch import graph_of
from starskel.task import Task


class StitchedBlend(FanBlend):
    """One least-squares problem over the fans of all pieces, in place of a tree and a mean."""

    def _prepared(self, fans: Fans, task: Task) -> tuple[Mesh, Motion]:
        count = len(self.pair)
        mesh = mesh_of(fans, count)
        task.reach(0.02)
        return mesh, stiffened(graph_of(mesh), count, task.part(0.1, 1)).points
