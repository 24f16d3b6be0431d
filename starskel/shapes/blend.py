"""Blend two polygons or two shapes: of shapes every part by a method, joined by the meta-skeleton."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any, overload

import numpy as np
import shapely

from starskel.blending import METHODS
from starskel.blending.blend import blend as blend_polygons
from starskel.blending.blend import checked_turns
from starskel.blending.frames import Blend, row_masses
from starskel.correspondence import Correspondence, PolygonLike
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError, UnknownMethod
from starskel.polar import as_complex
from starskel.predicates import Complex
from starskel.shapes.body import Manner, prepared
from starskel.shapes.certified import CertifiedShapeBlend
from starskel.shapes.correspondence import PartPair, ShapeCorrespondence
from starskel.shapes.given import Marks, Places
from starskel.shapes.likeness import rotation_of
from starskel.shapes.match import is_shape, match
from starskel.shapes.meta_skeleton import Tree, tree_of
from starskel.shapes.pairing import Link
from starskel.shapes.shape import Shape, ShapeLike
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Progress, ShouldStop, Task


@overload
def blend(
    source: Correspondence,
    target: str = ...,
    /,
    *,
    method: str = ...,
    decomposition: Decomposition | None = ...,
    root: int | None = ...,
    turns: int = ...,
    settled: bool = ...,
    progress: Progress | None = ...,
    should_stop: ShouldStop | None = ...,
) -> Blend: ...


@overload
def blend(
    source: PolygonLike,
    target: PolygonLike,
    marks: Iterable[tuple[int, int]] = ...,
    method: str = ...,
    *,
    decomposition: Decomposition | None = ...,
    root: int | None = ...,
    turns: int = ...,
    settled: bool = ...,
    progress: Progress | None = ...,
    should_stop: ShouldStop | None = ...,
) -> Blend: ...


@overload
def blend(
    source: ShapeCorrespondence,
    target: str = ...,
    /,
    *,
    method: str = ...,
    joined: bool = ...,
    roots: Places | None = ...,
    turns: int = ...,
    settled: bool = ...,
    progress: Progress | None = ...,
    should_stop: ShouldStop | None = ...,
) -> ShapeBlend: ...


@overload
def blend(
    source: Shape | shapely.MultiPolygon,
    target: ShapeLike,
    marks: Marks = ...,
    method: str = ...,
    *,
    pairing: Iterable[Link] | None = ...,
    places: Places | None = ...,
    joined: bool = ...,
    roots: Places | None = ...,
    turns: int = ...,
    settled: bool = ...,
    progress: Progress | None = ...,
    should_stop: ShouldStop | None = ...,
) -> ShapeBlend: ...


def blend(  # noqa: PLR0913 -- the calls differ in two or three of them
    source: Any,
    target: Any = None,
    marks: Any = (),
    method: str = "stitched",
    *,
    pairing: Iterable[Link] | None = None,
    places: Places | None = None,
    joined: bool = True,
    decomposition: Decomposition | None = None,
    root: int | None = None,
    roots: Places | None = None,
    turns: int = 0,
    settled: bool = True,
    progress: Progress | None = None,
    should_stop: ShouldStop | None = None,
) -> Blend | ShapeBlend:
    """Prepare a blend: of a pair, ``blend(pair, method=...)``, or of two polygons or shapes and marks.

    Polygons are blended as by `starskel.blending.blend.blend`. Of shapes every part is blended by the method,
    and a meta-skeleton joins the parts, so that they move together (paper, section 4).

    Parameters
    ----------
    source : Correspondence or ShapeCorrespondence; or what `match` takes
        A pair, or the source; then the target follows.
    target : as `match` takes it
    marks, pairing, places
        As for `match`.
    method : str
        One of `METHODS`. A "certified" blend of shapes is proven for all rings together.
    joined : bool
        False interpolates each part of a shape separately, for comparison (paper, figure 9).
    decomposition : Decomposition, optional
        That of the pair, where it is known already; for polygons only.
    root : int, optional
        The piece that is the skeleton's root, else the one with the most neighbours; for polygons only.
    roots : mapping from pairs of outlines to (x, y), optional
        For parts of shapes: the star origin in the source nearest to the place is the root of the part's
        star-skeleton.
    turns : int
        Whole turns of the whole besides, counter-clockwise: of shapes by all methods, of polygons by
        "star-skeleton".
    settled : bool
        False gives a blend sooner, where the method goes on improving one.
    progress : callable, optional
        Called with the fraction done.
    should_stop : callable, optional
        Asked often whether to stop.

    Raises
    ------
    UnknownMethod
        If there is no such method.
    InvalidPolygon, InvalidMarks
        As by `match`.
    StarskelError
        If turns is no int; where a region is too narrow for bridges to its holes; by "certified" where rings
        meet on the way.
    Cancelled
        If ``should_stop`` answered True.

    Examples
    --------
    >>> import starskel
    >>> straight = [(0, 0), (4, 0), (8, 0), (8, 1), (4, 1), (0, 1)]
    >>> bent = [(0, 0), (4, 0), (7, 3), (6.3, 3.7), (4, 1.5), (0, 1)]
    >>> blend = starskel.blend(straight, bent, marks=[(0, 0), (2, 2)])
    >>> blend.at(0.5).round(2)[:3].tolist()
    [[-0.03, -0.04], [3.94, -0.03], [7.63, 1.58]]
    >>> blend.frames([0, 0.5, 1]).shape
    (3, 6, 2)

    By another method, of a pair that is matched already:

    >>> starskel.blend(blend.pair, method="vertex").at(0.5)[:3].tolist()
    [[0.0, 0.0], [4.0, 0.0], [7.5, 1.5]]

    A shape of several rings:

    >>> ring = starskel.Shape([[(0, 0), (8, 0), (8, 8), (0, 8)], [(2, 2), (6, 2), (6, 6), (2, 6)]])
    >>> [rows.shape for rows in starskel.blend(ring, starskel.Shape([straight])).at(0.5)]
    [(6, 2), (4, 2)]
    """
    if not (isinstance(source, ShapeCorrespondence) or is_shape(source) or is_shape(target)):
        if pairing is not None or places is not None or roots is not None or not joined:
            raise StarskelError("two polygons need no pairing and are not joined", "give a Shape of each")
        return blend_polygons(
            source,
            target,
            marks,
            method,
            decomposition=decomposition,
            root=root,
            turns=turns,
            settled=settled,
            progress=progress,
            should_stop=should_stop,
        )
    if decomposition is not None or root is not None:
        raise StarskelError(
            "a shape has several decompositions and roots", "give places of roots, or leave them to the blend"
        )
    chosen = target if isinstance(target, str) else method
    if chosen not in METHODS:
        raise UnknownMethod(f'there is no method "{chosen}"', "choose one of " + ", ".join(METHODS))
    if isinstance(source, ShapeCorrespondence):
        given = target is not None and not isinstance(target, str)
        if given or marks or pairing is not None or places is not None:
            raise StarskelError("a pair has its target and its marks already", "give the pair alone")
    else:
        if target is None or isinstance(target, str):
            raise StarskelError("the target is missing", "give two shapes, or a pair made by match")
        source = match(
            source,
            target,
            marks,
            pairing=pairing,
            places=places,
            should_stop=should_stop,
        )
    turns = checked_turns(turns)
    task = Task(progress, should_stop)
    task.reach(0)
    known = _checked_roots(source, roots or {})
    made = _prepare(source, Manner(chosen, settled), known, turns if joined else None, task)
    task.reach(1)
    return made


def _checked_roots(pair: ShapeCorrespondence, roots: Places) -> Places:
    outlines = [part.links[0] for part in pair.parts if not part.alone]
    for link in roots:
        if link not in outlines:
            named = " or ".join(map(str, outlines)) or "none"
            raise StarskelError(f"{link} is no pair of outlines, and has no root", f"give roots for {named}")
    return roots


def _prepare(
    pair: ShapeCorrespondence, manner: Manner, roots: Places, turns: int | None, task: Task
) -> ShapeBlend:
    """Blend all parts; without a number of turns each by itself."""
    method = manner.method
    manner = replace(manner, settled=manner.settled or method == "certified")
    parts, owners = _bodies(pair, method)
    tree = None if turns is None else _tree(parts, owners, turns)
    rotations = tree.rotations if tree is not None else np.zeros(len(parts))
    bodies = []
    for number, (part, rotation) in enumerate(zip(parts, rotations.tolist(), strict=True)):
        share = task.part(0.9 * number / len(parts), 0.9 * (number + 1) / len(parts))
        own = replace(manner, root=roots.get(part.links[0]))
        bodies.append(prepared(part, own, rotation, share))
    if method == "certified":
        return CertifiedShapeBlend(pair, tuple(bodies), tree, task.part(0.9, 1))
    return ShapeBlend(pair, method, tuple(bodies), tree)


def _bodies(pair: ShapeCorrespondence, method: str) -> tuple[list[PartPair], list[int]]:
    """Give what moves as one, and for each whether it belongs to another one, or -1.

    Edges and angles know no inside: there holes move by themselves, on a link to their outline.
    """
    if method != "edge-angle":
        return list(pair.parts), [-1] * len(pair.parts)
    parts: list[PartPair] = []
    owners: list[int] = []
    for part in pair.parts:
        owners += [-1, *[len(parts)] * (len(part.links) - 1)]
        parts += part.by_rings()
    return parts, owners


def _tree(parts: Sequence[PartPair], owners: Sequence[int], turns: int) -> Tree:
    outlines = [part.by_rings()[0].pair for part in parts]
    places = np.array([_middles(pair) for pair in outlines]).T
    rotations = [
        None if part.alone else rotation_of(pair) for part, pair in zip(parts, outlines, strict=True)
    ]
    sizes = np.array(
        [np.ptp(pair.source, axis=0).max() + np.ptp(pair.target, axis=0).max() for pair in outlines]
    )
    return tree_of(places, rotations, owners, sizes, turns)


def _middles(pair: Correspondence) -> Complex:
    weights = row_masses(pair)
    return np.array([weights @ as_complex(pair.source), weights @ as_complex(pair.target)])
