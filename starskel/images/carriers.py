"""What carries pictures: the meshes of a blend's parts, and their outlines."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.blending.frames import Blend
from starskel.blending.inner_mesh import InnerMesh, mesh_blend
from starskel.blending.pieces import PieceBlend
from starskel.correspondence import Correspondence
from starskel.decomposition.pieces import Decomposition
from starskel.shapes.body import Body
from starskel.shapes.correspondence import PartPair
from starskel.shapes.holes.pieces import decompose_region
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Task


@dataclass(frozen=True, eq=False)
class Carrier:
    """One part of a shape on its way, as a mesh.

    Attributes
    ----------
    triangles : (k, 3) array of int
        Corners, counter-clockwise in source and target.
    edges : (n, 2) array of int
        The outline, and those of holes: from which node to which.
    nodes_at : callable
        Gives the (m, 2) nodes at t.
    in_source, in_target : bool
        Whether the part is there at all: one that grows from a point is not in the source.
    number : int
        That of its outline among the rings of a frame.
    """

    triangles: Indices
    edges: Indices
    nodes_at: Callable[[float], Floats]
    in_source: bool = True
    in_target: bool = True
    number: int = 0


def carriers_of(
    blend: Blend | ShapeBlend, decomposition: Decomposition | None, task: Task
) -> tuple[Carrier, ...]:
    """Give what carries pictures, in the order in which parts are painted.

    Parameters
    ----------
    blend : Blend or ShapeBlend
    decomposition : Decomposition or None
        That of the blend's pair, where it is known; for polygons only.
    task : Task

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    if isinstance(blend, Blend):
        moved = mesh_blend(blend, decomposition, task)
        return (Carrier(moved.mesh.triangles, _edges(blend.pair), moved.mesh_at),)
    moved_by = {
        body.part.links[0]: (body, pieces) for body, pieces in zip(blend.bodies, blend.pieces, strict=True)
    }
    parts = blend.pair.parts
    return tuple(
        _carrier(blend, part, *moved_by[part.links[0]], task.part(k / len(parts), (k + 1) / len(parts)))
        for k, part in enumerate(parts)
    )


def _carrier(blend: ShapeBlend, part: PartPair, body: Body, pieces: PieceBlend | None, task: Task) -> Carrier:
    places = [blend.pair.pairing.index(link) for link in part.links]

    def rows_at(t: float) -> Floats:
        rings = blend.at(t)
        outline, *holes = (rings[place] for place in places)
        return np.concatenate([outline, *(hole[::-1] for hole in holes)])

    edges = _edges(part.pair)
    if pieces is not None:
        moved = _Moved(body, pieces, rows_at)
        return Carrier(pieces.mesh.triangles, edges, moved.nodes_at, number=places[0])
    pair, (source, target) = part.pair, (ring is not None for ring in part.links[0])
    if part.alone:
        there = pair.source if source else pair.target
        pair = replace(pair, source=there, target=there)
    known = body.blend.decomposition or decompose_region(pair, task.part(0, 0.9))
    inner = InnerMesh(rows_at, known, task.part(0.9, 1))
    return Carrier(inner.mesh.triangles, edges, inner.mesh_at, source, target, places[0])


@dataclass(frozen=True, eq=False)
class _Moved:
    """The mesh of a part that moves and turns as one with others."""

    body: Body
    blend: PieceBlend
    rows_at: Callable[[float], Floats]

    def nodes_at(self, t: float) -> Floats:
        rows, nodes = self.rows_at(t), self.blend.mesh_at(t)
        return np.concatenate([rows, self.body.carried(t, nodes[len(rows) :], nodes[0], rows[0])])


def _edges(pair: Correspondence) -> Indices:
    return np.stack([np.arange(len(pair)), pair.following], axis=1)
