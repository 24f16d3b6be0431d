"""Star pieces and skeletons of all parts of a blend, where they are at one time."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats
from starskel.blending.frames import Blend
from starskel.blending.pieces import PieceBlend
from starskel.polar import as_points
from starskel.shapes.shape_blend import ShapeBlend


@dataclass(frozen=True, eq=False)
class Structure:
    """One part's star pieces and skeleton.

    Attributes
    ----------
    number : int
        That of the part's outline among the rings of a frame.
    blend : PieceBlend
        What has the decomposition and the skeleton.
    points : (m, 2) array
        The points that the pieces name.
    skeleton : (2 k - 1, 2) array
        The k star origins, then the mid-points.
    """

    number: int
    blend: PieceBlend
    points: Floats
    skeleton: Floats


def structures_at(blend: Blend | ShapeBlend, t: float) -> Iterator[Structure]:
    """Give the star pieces and skeletons at t of the parts that have them.

    Parts without a partner have none, nor has any by methods that stand on no star pieces or leave these.
    """
    if isinstance(blend, PieceBlend):
        yield Structure(0, blend, blend.points_at(t), blend.skeleton_at(t))
    if not isinstance(blend, ShapeBlend):
        return
    rings = blend.at(t)
    for body, pieces in zip(blend.bodies, blend.pieces, strict=True):
        if pieces is not None:
            number = blend.pair.pairing.index(body.part.links[0])
            points, place = pieces.points_at(t), rings[number][0]
            skeleton = body.carried(t, pieces.skeleton_at(t), points[0], place)
            yield Structure(number, pieces, body.carried(t, points, points[0], place), skeleton)


def tree_at(blend: Blend | ShapeBlend, t: float) -> Floats:
    """Give the two ends of each link of the meta-skeleton at t, (k, 2, 2); none where nothing joins parts."""
    if not isinstance(blend, ShapeBlend) or blend.meta_skeleton is None:
        return np.empty((0, 2, 2))
    tree = blend.meta_skeleton.tree
    links = np.array([(tree.parents[part], part) for part in tree.order[1:]], dtype=np.intp).reshape(-1, 2)
    return np.asarray(as_points(blend.meta_skeleton.places(np.array([t])))[0, links])
