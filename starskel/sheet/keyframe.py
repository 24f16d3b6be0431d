"""A keyframe: what one cell of a sheet shows, in the user's units."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely

from starskel.arrays import Floats
from starskel.crossings import crossing_places
from starskel.outline import cross_themselves
from starskel.sheet.drawing import Painter
from starskel.sheet.style import USUAL_PART, PartLook
from starskel.skeleton import Skeleton

NO_PLACES: Floats = np.empty((0, 2))


@dataclass(frozen=True, eq=False)
class PlacedSkeleton:
    """Where a skeleton lies.

    Attributes
    ----------
    origins : (k, 2) array
        The star origins.
    mid_points : (k - 1, 2) array
        The mid-points of shared edges.
    arcs : (2 k - 2, 2, 2) array
        The two ends of each arc.
    """

    origins: Floats
    mid_points: Floats
    arcs: Floats

    @classmethod
    def of(cls, skeleton: Skeleton, points: Floats) -> "PlacedSkeleton":
        """Give a skeleton whose points, the star origins and then the mid-points, lie there."""
        count = len(skeleton.parents)
        return cls(points[:count], points[count:], points[skeleton.arcs])


@dataclass(frozen=True, eq=False)
class FramePart:
    """A part that is to be seen; of a blend of polygons there is one.

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

    @property
    def extended(self) -> tuple[Floats, ...]:
        """The rings that are more than a point."""
        return tuple(ring for ring in self.rings if np.ptp(ring, axis=0).any())


@dataclass(frozen=True, eq=False)
class Keyframe:
    """The in-between shape at one time, and what is to be seen on it.

    Attributes
    ----------
    t : float
        The time, in [0, 1].
    parts : tuple of FramePart
        At least one.
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
    parts: tuple[FramePart, ...]
    tree: Floats
    pins: Floats
    dotted: bool = False
    picture: Painter | None = None

    @property
    def vertices(self) -> Floats:
        """The vertices to be shown, as a (k, 2) array."""
        rings = [ring for part in self.parts for ring in part.rings]
        return np.concatenate(rings) if self.dotted else NO_PLACES

    @property
    def simple(self) -> bool:
        """Whether no ring meets itself or is inside out, and holes are inside."""
        extended = [part.extended for part in self.parts]
        if any(cross_themselves(ring[None])[0] for rings in extended for ring in rings):
            return False
        return all(shapely.is_valid(shapely.Polygon(rings[0], rings[1:])) for rings in extended if rings)

    @cached_property
    def crossings(self) -> Floats:
        """The places where rings meet themselves, as a (k, 2) array; no rows where none does."""
        places = [crossing_places(ring) for part in self.parts for ring in part.extended]
        return np.concatenate([NO_PLACES, *places])

    @property
    def box(self) -> Floats:
        """The lower left and the upper right corner of the box round all rings, as rows."""
        points = np.concatenate([part.rings[0] for part in self.parts])
        return np.array([points.min(axis=0), points.max(axis=0)])


@dataclass(frozen=True)
class Shown:
    """What is to be seen on keyframes besides the shape; pictures in its place, where there are any."""

    marks: bool = False
    pieces: bool = False
    skeleton: bool = False
    vertices: bool = False
    pictures: bool = True


ALONE = Shown(pictures=False)
"""Nothing besides."""
