"""Blend two polygons or two shapes, matched or not."""

from collections.abc import Iterable
from typing import Any, overload

import shapely

from starskel.arguments import items, truth
from starskel.blending.frames import Blend
from starskel.blending.methods import blend_pair, checked_turns, chosen_method
from starskel.correspondence import Correspondence, PolygonLike, checked_pair
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError
from starskel.shapes.body import Manner
from starskel.shapes.correspondence import ShapeCorrespondence
from starskel.shapes.joining import blend_shapes
from starskel.shapes.matching.given import Marks, Places
from starskel.shapes.matching.match import match
from starskel.shapes.matching.pairing import RingLink
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
    pairing: Iterable[RingLink] | None = ...,
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
    method: str | None = None,
    *,
    pairing: Iterable[RingLink] | None = None,
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

    Of shapes every part is blended by the method, and a meta-skeleton joins the parts, so that they move
    together (paper, section 4).

    Parameters
    ----------
    source : Correspondence or ShapeCorrespondence; or what `match` takes
        A pair, or the source; then the target follows.
    target : as `match` takes it
    marks, pairing, places
        As for `match`.
    method : str
        One of `METHODS`, by default "stitched"; behind a pair it may stand in the target's place. A
        "certified" blend of shapes is proven for all rings together.
    joined : bool
        False interpolates each part of a shape separately, for comparison (paper, figure 9).
    decomposition : Decomposition, optional
        That of the pair, where it is known already, else it is computed if the method needs it; for polygons
        only.
    root : int, optional
        The piece that is the skeleton's root, else the one with the most neighbours; for polygons only.
    roots : mapping from pairs of outlines to (x, y), optional
        For parts of shapes: the star origin in the source nearest to the place is the root of the part's
        star-skeleton.
    turns : int
        Whole turns of the whole besides, counter-clockwise: of shapes by all methods, of polygons by
        "star-skeleton", while the others leave them out of account.
    settled : bool
        False gives a blend sooner, where the method goes on improving one: `Blend.improvements` goes on.
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
        If something that is given is of a wrong kind; where a region is too narrow for bridges to its holes;
        by "certified" where rings have to meet on the way.
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
    task = Task(progress, should_stop)
    chosen = chosen_method(target, method)
    turns, settled, joined = checked_turns(turns), truth(settled, "settled"), truth(joined, "joined")
    task.reach(0)
    pair = _pair(source, None if isinstance(target, str) else target, marks, pairing, places, should_stop)
    made: Blend | ShapeBlend
    if isinstance(pair, Correspondence):
        if roots is not None or not joined:
            raise StarskelError("two polygons have one root, and are not joined", "give a Shape of each")
        made = blend_pair(
            pair, chosen, decomposition=decomposition, root=root, turns=turns, settled=settled, task=task
        )
    elif decomposition is None and root is None:
        manner = Manner(chosen, settled)
        made = blend_shapes(pair, manner, {} if roots is None else roots, turns if joined else None, task)
    else:
        raise StarskelError(
            "a shape has several decompositions and roots", "give places of roots, or leave them to the blend"
        )
    task.reach(1)
    return made


def _pair(  # noqa: PLR0913, PLR0917 -- what match takes
    source: Any,
    target: Any,
    marks: Any,
    pairing: Iterable[RingLink] | None,
    places: Places | None,
    should_stop: ShouldStop | None,
) -> Correspondence | ShapeCorrespondence:
    """Give the pair to be blended, as it is given, or of what is given."""
    if isinstance(source, Correspondence | ShapeCorrespondence):
        mend = "give the pair alone"
        if target is not None or items(marks, "the marks", mend) or not (pairing is places is None):
            raise StarskelError("a pair has its target and its marks already", mend)
        return source if isinstance(source, ShapeCorrespondence) else checked_pair(source)
    if target is None:
        raise StarskelError("the target is missing", "give source and target, or a pair made by match")
    return match(source, target, marks, pairing=pairing, places=places, should_stop=should_stop)
