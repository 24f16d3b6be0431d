"""Better triangles than the bare fans have: hubs moved, edges flipped, in both polygons alike."""

from dataclasses import replace

from starskel.blending.meshes.distortion import Shapes
from starskel.blending.meshes.fans import Fans
from starskel.blending.meshes.flips import flipped
from starskel.blending.meshes.hub_places import with_hubs_moved
from starskel.polar import as_complex, as_points
from starskel.task import Task


def with_better_hubs(fans: Fans, rows: int, task: Task) -> Fans:
    """Move hubs, those behind the rows of the decomposition, to where their fans distort least.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    source, target = as_complex(fans.source), as_complex(fans.target)
    shapes = Shapes.of(source, target, fans.triangles)
    moved = with_hubs_moved(shapes, fans.triangles, rows, task)
    return replace(
        fans,
        source=as_points(source + shapes.units[0] * (moved.source - shapes.source)),
        target=as_points(target + shapes.units[1] * (moved.target - shapes.target)),
    )


def with_better_edges(fans: Fans, task: Task) -> Fans:
    """Flip edges while that lessens the distortion; the points stay.

    Alexa and others improve their triangulations likewise: thin triangles shear much, and pull others along.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    shapes = Shapes.of(as_complex(fans.source), as_complex(fans.target), fans.triangles)
    return replace(fans, triangles=flipped(fans.triangles, shapes, task))
