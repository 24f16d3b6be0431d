"""A keyframe of a blend of shapes: what one cell of a sheet shows, in the user's units."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely

from starskel.arrays import Floats
from starskel.outline import cross_themselves
from starskel.polar import as_points
from starskel.polygon import crossing_edges, meeting_places
from starskel.shapes.shape_blend import ShapeBlend
from starskel.shapes.structure import Structure, structures_at
from starskel.sheet.drawing import Painter
from starskel.sheet.keyframe import ALONE, PlacedSkeleton, Shown, hidden
from starskel.sheet.style import USUAL_PART, PartLook


@dataclass(frozen=True, eq=False)
class ShapePart:
    """A part that is to be seen.

    Attributes
    ----------
    rings : tuple of (n, 2) arrays
        The outline and the holes.
    own : PartLook
        Its own colours.
    pieces : tuple of (k, 2) arrays
        The rings of the star pieces; none where they are not shown.
    skeleton : PlacedSkeleton or None
        The skeleton; None where it is not shown.
    """

    rings: tuple[Floats, ...]
    own: PartLook = USUAL_PART
    pieces: tuple[Floats, ...] = ()
    skeleton: PlacedSkeleton | None = None


@dataclass(frozen=True, eq=False)
class ShapeKeyframe:
    """The rings at one time.

    Attributes
    ----------
    t : float
        The time, in [0, 1].
    parts : tuple of ShapePart
        Those that are a point are left out where it stands still.
    tree : (k, 2, 2) array
        The two ends of each link of the meta-skeleton; none where it is not shown.
    pins : (k, 2) array
        Where the user's marks are, in their order; no rows where they are not shown.
    dotted : bool
        Whether the vertices are shown.
    picture : Painter or None
        What paints the picture in it, in the user's units; it takes the place of fill and outline.
    """

    t: float
    parts: tuple[ShapePart, ...]
    tree: Floats
    pins: Floats
    dotted: bool = False
    picture: Painter | None = None

    @property
    def rings(self) -> tuple[Floats, ...]:
        """All rings that are to be seen."""
        return tuple(ring for part in self.parts for ring in part.rings)

    @property
    def vertices(self) -> Floats:
        """The vertices to be shown, as a (k, 2) array."""
        return np.concatenate([np.empty((0, 2)), *(self.rings if self.dotted else ())])

    @property
    def simple(self) -> bool:
        """Whether no ring meets itself, and holes are inside."""
        if any(cross_themselves(ring[None])[0] for ring in self.rings):
            return False
        polygons = (shapely.Polygon(part.rings[0], part.rings[1:]) for part in self.parts)
        return all(shapely.is_valid(polygon) for polygon in polygons)

    @cached_property
    def crossings(self) -> Floats:
        """The places where rings meet themselves, as a (k, 2) array."""
        return np.concatenate([meeting_places(ring, crossing_edges(ring)) for ring in self.rings])

    @property
    def box(self) -> Floats:
        """The lower left and the upper right corner of the box round all rings, as rows."""
        points = np.concatenate([part.rings[0] for part in self.parts])
        return np.array([points.min(axis=0), points.max(axis=0)])


def shape_keyframes(
    blend: ShapeBlend,
    times: Sequence[float],
    shown: Shown = ALONE,
    looks: Sequence[PartLook] = (),
    *,
    moving: bool = False,
) -> tuple[ShapeKeyframe, ...]:
    """Give the keyframes of a blend of shapes.

    Parameters
    ----------
    blend : ShapeBlend
    times : sequence of float
        Numbers from 0 to 1.
    shown : Shown
        Star pieces and skeletons appear where parts have them; the meta-skeleton joins the skeletons.
    looks : sequence of PartLook
        For each ring of a frame its colours, and whether it is to be seen; none where all look as usual.
    moving : bool
        Whether all keyframes have all parts and holes, those that are a point too.

    Raises
    ------
    StarskelError
        Where a time is not a number from 0 to 1, or all parts are hidden.
    """
    own = tuple(looks) or (USUAL_PART,) * len(blend.pair.pairing)
    if not any(look.visible for look, outer in zip(own, blend.pair.outer, strict=True) if outer < 0):
        raise hidden()
    rows = [ring.marked_rows if shown.marks else () for ring in blend.pair.ring_pairs]
    found = []
    for t, rings in zip(times, blend.frames(times), strict=True):
        tree = tree_at(blend, t) if shown.skeleton else np.empty((0, 2, 2))
        pins = [ring[list(own_rows)] for ring, own_rows in zip(rings, rows, strict=True) if own_rows]
        pinned = np.concatenate([np.empty((0, 2)), *pins])
        parts = tuple(_parts(blend, t, rings, shown, own, moving))
        found.append(ShapeKeyframe(t, parts, tree, pinned, shown.vertices))
    return tuple(found)


def _parts(  # noqa: PLR0913, PLR0917 -- the rings, and all that decides about how they are seen
    blend: ShapeBlend,
    t: float,
    rings: Sequence[Floats],
    shown: Shown,
    looks: Sequence[PartLook],
    moving: bool,
) -> Iterator[ShapePart]:
    size = max(float(np.ptp(ring, axis=0).max()) for ring in rings)
    there = [
        look.visible and (moving or bool(np.ptp(ring, axis=0).max() > 1e-9 * size))
        for ring, look in zip(rings, looks, strict=True)
    ]
    wanted = shown.pieces or shown.skeleton
    structures = {own.number: own for own in structures_at(blend, t)} if wanted else {}
    outer = blend.pair.outer
    for number in range(len(rings)):
        if outer[number] >= 0 or not there[number]:
            continue
        holes = (rings[k] for k, own in enumerate(outer) if own == number and there[k])
        pieces, skeleton = _cut(structures.get(number), shown)
        yield ShapePart((rings[number], *holes), looks[number], pieces, skeleton)


def _cut(structure: Structure | None, shown: Shown) -> tuple[tuple[Floats, ...], PlacedSkeleton | None]:
    """Give the star pieces and the skeleton of a part, as far as they are shown."""
    if structure is None:
        return (), None
    points, cut = structure.points, structure.blend.decomposition.pieces
    pieces = tuple(points[list(piece)] for piece in cut) if shown.pieces else ()
    placed = PlacedSkeleton.of(structure.blend.skeleton, structure.skeleton) if shown.skeleton else None
    return pieces, placed


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
