"""A keyframe: what one cell of a sheet shows, in the user's units."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.blending.frames import Blend
from starskel.blending.pieces import PieceBlend
from starskel.errors import StarskelError, told
from starskel.polygon import crossing_edges, meeting_places
from starskel.sheet.drawing import Painter
from starskel.sheet.style import USUAL_PART, PartLook
from starskel.skeleton import Skeleton


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
class Keyframe:
    """The in-between polygon at one time, and what is to be seen on it.

    Attributes
    ----------
    t : float
        The time, in [0, 1].
    ring : (n, 2) array
        The polygon.
    marks : tuple of int
        The rows of the ring that bear the user's marks, in their order.
    pieces : tuple of (k, 2) arrays
        The rings of the star pieces; none where they are not shown.
    skeleton : PlacedSkeleton or None
        The skeleton; None where it is not shown.
    dotted : bool
        Whether the vertices are shown.
    picture : Painter or None
        What paints the picture in it, in the user's units; it takes the place of fill and outline.
    own : PartLook
        Its own colours.
    """

    t: float
    ring: Floats
    marks: tuple[int, ...] = ()
    pieces: tuple[Floats, ...] = ()
    skeleton: PlacedSkeleton | None = None
    dotted: bool = False
    picture: Painter | None = None
    own: PartLook = USUAL_PART

    @property
    def vertices(self) -> Floats:
        """The vertices to be shown, as a (k, 2) array."""
        return self.ring if self.dotted else self.ring[:0]

    @cached_property
    def crossings(self) -> Floats:
        """The places where the ring meets itself, as a (k, 2) array; no rows where it is simple."""
        return meeting_places(self.ring, self._crossing_edges)

    @property
    def simple(self) -> bool:
        """Whether the ring nowhere meets itself."""
        return not len(self._crossing_edges)

    @cached_property
    def _crossing_edges(self) -> Indices:
        return crossing_edges(self.ring)

    @property
    def box(self) -> Floats:
        """The lower left and the upper right corner of the ring's box, as rows."""
        return np.array([self.ring.min(axis=0), self.ring.max(axis=0)])


@dataclass(frozen=True)
class Shown:
    """What is to be seen on keyframes besides the polygon; pictures in its place, where there are any."""

    marks: bool = False
    pieces: bool = False
    skeleton: bool = False
    vertices: bool = False
    pictures: bool = True


ALONE = Shown(pictures=False)
"""Nothing besides."""


def keyframes(
    blend: Blend, times: Sequence[float], shown: Shown = ALONE, own: PartLook = USUAL_PART
) -> tuple[Keyframe, ...]:
    """Give the keyframes of a blend.

    Parameters
    ----------
    blend : Blend
    times : sequence of float
        Numbers from 0 to 1.
    shown : Shown
        Star pieces and skeleton appear where the method has them.
    own : PartLook
        The colours of the polygon.

    Raises
    ------
    StarskelError
        Where a time is not a number from 0 to 1, or the polygon is hidden.
    """
    if not own.visible:
        raise hidden()
    rows = blend.pair.marked_rows if shown.marks else ()
    return tuple(
        Keyframe(t, ring, rows, _pieces(blend, t, shown), _skeleton(blend, t, shown), shown.vertices, own=own)
        for t, ring in zip(times, blend.frames(times), strict=True)
    )


def _pieces(blend: Blend, t: float, shown: Shown) -> tuple[Floats, ...]:
    if not (shown.pieces and isinstance(blend, PieceBlend)):
        return ()
    points = blend.points_at(t)
    return tuple(points[list(piece)] for piece in blend.decomposition.pieces)


def _skeleton(blend: Blend, t: float, shown: Shown) -> PlacedSkeleton | None:
    if not (shown.skeleton and isinstance(blend, PieceBlend)):
        return None
    return PlacedSkeleton.of(blend.skeleton, blend.skeleton_at(t))


def hidden() -> StarskelError:
    """Give the error of frames in which nothing is to be seen."""
    return StarskelError(told("all parts are hidden"), told("show at least one of them"))
