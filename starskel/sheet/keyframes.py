"""The keyframes of a blend."""

from collections.abc import Iterator, Sequence

import numpy as np

from starskel.arrays import Floats
from starskel.blending.frames import Blend
from starskel.errors import StarskelError, told
from starskel.shapes.shape_blend import ShapeBlend
from starskel.shapes.structure import Structure, structures_at, tree_at
from starskel.sheet.keyframe import ALONE, NO_PLACES, FramePart, Keyframe, PlacedSkeleton, Shown
from starskel.sheet.style import USUAL_PART, PartLook

_POINT = 1e-9
"""Rings smaller than this part of the largest are a point."""


def keyframes(
    blend: Blend | ShapeBlend,
    times: Sequence[float],
    shown: Shown = ALONE,
    looks: Sequence[PartLook] = (),
    *,
    moving: bool = False,
) -> tuple[Keyframe, ...]:
    """Give the keyframes of a blend.

    Parts and holes that are a point are left out; but where nothing else is to be seen, the points are.

    Parameters
    ----------
    blend : Blend or ShapeBlend
    times : sequence of float
        Numbers from 0 to 1.
    shown : Shown
        Star pieces and skeletons appear where the method has them; a meta-skeleton joins those of several
        parts.
    looks : sequence of PartLook
        For each ring of a frame its colours, and whether it is to be seen; none where all look as usual.
    moving : bool
        Whether all keyframes have all parts and holes, those that are a point too.

    Raises
    ------
    StarskelError
        Where a time is not a number from 0 to 1, or all parts are hidden.
    """
    outer = blend.pair.outer
    own = tuple(looks) or (USUAL_PART,) * len(outer)
    if not any(look.visible for look, outline in zip(own, outer, strict=True) if outline < 0):
        raise StarskelError(told("all parts are hidden"), told("show at least one of them"))
    marked = [list(ring.marked_rows) if shown.marks else [] for ring in blend.pair.ring_pairs]
    found = []
    for t, rings in zip(times, zip(*blend.rings(times), strict=True), strict=True):
        there, cut = _there(rings, outer, own, moving), _cut(blend, t, shown)
        parts = tuple(
            FramePart((rings[k], *_holes(rings, outer, there, k)), own[k], *cut.get(k, ((), None)))
            for k, outline in enumerate(outer)
            if outline < 0 and there[k]
        )
        tree = tree_at(blend, t) if shown.skeleton else np.empty((0, 2, 2))
        pins = [ring[rows] for ring, rows in zip(rings, marked, strict=True)]
        found.append(Keyframe(t, parts, tree, np.concatenate([NO_PLACES, *pins]), shown.vertices))
    return tuple(found)


def _there(
    rings: Sequence[Floats], outer: Sequence[int], looks: Sequence[PartLook], moving: bool
) -> list[bool]:
    """Tell which rings are to be seen."""
    sizes = [float(np.ptp(ring, axis=0).max()) for ring in rings]
    visible = [look.visible for look in looks]
    there = [see and (moving or size > _POINT * max(sizes)) for see, size in zip(visible, sizes, strict=True)]
    return there if any(there[k] for k, outline in enumerate(outer) if outline < 0) else visible


def _holes(
    rings: Sequence[Floats], outer: Sequence[int], there: Sequence[bool], number: int
) -> Iterator[Floats]:
    """Give the holes of an outline that are to be seen."""
    return (rings[k] for k, outline in enumerate(outer) if outline == number and there[k])


def _cut(
    blend: Blend | ShapeBlend, t: float, shown: Shown
) -> dict[int, tuple[tuple[Floats, ...], PlacedSkeleton | None]]:
    """Give the star pieces and the skeletons of outlines, by their numbers, as far as they are shown."""
    structures = structures_at(blend, t) if shown.pieces or shown.skeleton else ()
    return {
        own.number: (_pieces(own) if shown.pieces else (), _skeleton(own) if shown.skeleton else None)
        for own in structures
    }


def _pieces(structure: Structure) -> tuple[Floats, ...]:
    return tuple(structure.points[list(piece)] for piece in structure.blend.decomposition.pieces)


def _skeleton(structure: Structure) -> PlacedSkeleton:
    return PlacedSkeleton.of(structure.blend.skeleton, structure.skeleton)
