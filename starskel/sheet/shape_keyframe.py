"""A keyframe of a blend of shapes: what one cell of a sheet shows, in the user's units."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely

from starskel.outline import cross_themselves
from starskel.polar import as_points
from starskel.polygon import crossing_edges, meeting_places
from starskel.predicates import Floats
from starskel.shapes.shape_blend import ShapeBlend
from starskel.sheet.drawing import Painter
from starskel.sheet.keyframe import ALONE, Shown


@dataclass(frozen=True, eq=False)
class ShapeKeyframe:
    """The rings at one time.

    Attributes
    ----------
    t : float
        The time, in [0, 1].
    parts : tuple of tuples of (n, 2) arrays
        For each part the outline and the holes; those that are a point are left out where it stands still.
    tree : (k, 2, 2) array
        The two ends of each link of the meta-skeleton; none where it is not shown.
    dotted : bool
        Whether the vertices are shown.
    picture : Painter or None
        What paints the picture in it, in the user's units; it takes the place of fill and outline.
    """

    t: float
    parts: tuple[tuple[Floats, ...], ...]
    tree: Floats
    dotted: bool = False
    picture: Painter | None = None

    @property
    def vertices(self) -> Floats:
        """The vertices to be shown, as a (k, 2) array."""
        rings = [ring for part in self.parts for ring in part] if self.dotted else []
        return np.concatenate([np.empty((0, 2)), *rings])

    @property
    def simple(self) -> bool:
        """Whether no ring meets itself, and holes are inside."""
        rings = [ring for part in self.parts for ring in part]
        if any(cross_themselves(ring[None])[0] for ring in rings):
            return False
        return all(shapely.is_valid(shapely.Polygon(part[0], part[1:])) for part in self.parts)

    @cached_property
    def crossings(self) -> Floats:
        """The places where rings meet themselves, as a (k, 2) array."""
        rings = [ring for part in self.parts for ring in part]
        return np.concatenate([meeting_places(ring, crossing_edges(ring)) for ring in rings])

    @property
    def box(self) -> Floats:
        """The lower left and the upper right corner of the box round all rings, as rows."""
        points = np.concatenate([part[0] for part in self.parts])
        return np.array([points.min(axis=0), points.max(axis=0)])


def shape_keyframes(
    blend: ShapeBlend, times: Sequence[float], shown: Shown = ALONE, *, moving: bool = False
) -> tuple[ShapeKeyframe, ...]:
    """Give the keyframes of a blend of shapes.

    Parameters
    ----------
    blend : ShapeBlend
    times : sequence of float
        Numbers from 0 to 1.
    shown : Shown
        The meta-skeleton is the skeleton; marks and pieces are not drawn.
    moving : bool
        Whether all keyframes have all parts and holes, those that are a point too.

    Raises
    ------
    StarskelError
        Where a time is not a number from 0 to 1.
    """
    frames = blend.frames(times)
    trees = _trees(blend, np.array(times)) if shown.skeleton else np.empty((len(frames), 0, 2, 2))
    return tuple(
        ShapeKeyframe(t, _parts(rings, blend.pair.outer, moving), tree, shown.vertices)
        for t, rings, tree in zip(times, frames, trees, strict=True)
    )


def _parts(rings: Sequence[Floats], outer: Sequence[int], moving: bool) -> tuple[tuple[Floats, ...], ...]:
    size = max(float(np.ptp(ring, axis=0).max()) for ring in rings)
    there = [moving or bool(np.ptp(ring, axis=0).max() > 1e-9 * size) for ring in rings]
    return tuple(
        (ring, *(rings[k] for k, own in enumerate(outer) if own == number and there[k]))
        for number, ring in enumerate(rings)
        if outer[number] < 0 and there[number]
    )


def tree_at(blend: ShapeBlend, t: float) -> Floats:
    """Give the two ends of each link of the meta-skeleton at t, (k, 2, 2); none where nothing joins parts."""
    return np.asarray(_trees(blend, np.array([t]))[0])


def _trees(blend: ShapeBlend, ts: Floats) -> Floats:
    """Give the links of the meta-skeleton at each time, (times, k, 2, 2)."""
    if blend.meta_skeleton is None:
        return np.empty((len(ts), 0, 2, 2))
    places = as_points(blend.meta_skeleton.places(ts))
    tree = blend.meta_skeleton.tree
    links = np.array([(tree.parents[part], part) for part in tree.order[1:]], dtype=np.intp).reshape(-1, 2)
    return np.asarray(places[:, links])
