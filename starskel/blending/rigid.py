"""As-rigid-as-possible blending (Alexa, Cohen-Or and Levin 2000) on the fans of the star pieces."""

from dataclasses import replace

from starskel.blending.distortion import Shapes
from starskel.blending.fan_blend import FanBlend, Motion
from starskel.blending.fans import Fans
from starskel.blending.flips import flipped
from starskel.blending.hub_places import with_hubs_moved
from starskel.blending.mesh import Mesh, mesh_of
from starskel.blending.rigid_triangles import RigidTriangles
from starskel.polar import as_complex, as_points
from starskel.task import Task


class RigidBlend(FanBlend):
    """Every triangle turns evenly and stretches evenly; the points come as near to that as can be.

    What a triangle asks for counts by its area, in source and target alike.
    """

    def _prepared(self, fans: Fans, task: Task) -> tuple[Mesh, Motion]:
        improved = _improved(fans, len(self.decomposition.source), task)
        task.reach(0.5)
        mesh = mesh_of(improved, len(self.pair))
        task.reach(0.6)
        return mesh, RigidTriangles.of(mesh).points


def _improved(fans: Fans, rows: int, task: Task) -> Fans:
    """Move hubs, those behind the rows of the decomposition, and flip edges, so that less is distorted.

    Alexa and others improve their triangulations likewise: thin triangles shear much, and pull others along.
    """
    source, target = as_complex(fans.source), as_complex(fans.target)
    shapes = Shapes.of(source, target, fans.triangles)
    moved = with_hubs_moved(shapes, fans.triangles, rows, task)
    return replace(
        fans,
        source=as_points(source + shapes.units[0] * (moved.source - shapes.source)),
        target=as_points(target + shapes.units[1] * (moved.target - shapes.target)),
        triangles=flipped(fans.triangles, moved, task),
    )
