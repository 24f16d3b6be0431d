"""Choose a method by its name, and prepare it."""

import operator
from collections.abc import Callable, Iterable
from typing import overload

from starskel.blending import METHODS
from starskel.blending.certified import CertifiedBlend
from starskel.blending.edge_angle import EdgeAngleBlend
from starskel.blending.frames import Blend
from starskel.blending.rigid import RigidBlend
from starskel.blending.star_skeleton import StarSkeletonBlend
from starskel.blending.stitched import StitchedBlend
from starskel.blending.vertex import VertexBlend
from starskel.correspondence import Correspondence, PolygonLike, match
from starskel.decomposition import decompose
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError, UnknownMethod
from starskel.task import Progress, ShouldStop, Task

_DECOMPOSING = 0.5
"""The share of the work that the decomposition is taken to be."""


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


def blend(  # noqa: PLR0913 -- the calls differ in two or three of them
    source: Correspondence | PolygonLike,
    target: PolygonLike | str | None = None,
    marks: Iterable[tuple[int, int]] = (),
    method: str = "stitched",
    *,
    decomposition: Decomposition | None = None,
    root: int | None = None,
    turns: int = 0,
    settled: bool = True,
    progress: Progress | None = None,
    should_stop: ShouldStop | None = None,
) -> Blend:
    """Prepare a blend: of a pair, ``blend(pair, method=...)``, or of two polygons and marks.

    Parameters
    ----------
    source : Correspondence, or Polygon, shapely Polygon or (n, 2) array-like
        A pair, or the source polygon; then the target follows.
    target : Polygon, shapely Polygon or (n, 2) array-like
    marks : iterable of (int, int)
        Vertices that correspond, as for `match`.
    method : str
        One of `METHODS`.
    decomposition : Decomposition, optional
        That of the pair, where it is known already; else it is computed if the method needs it.
    root : int, optional
        The piece that is the skeleton's root; else the one with the most neighbours.
    turns : int
        Whole turns of the whole shape that the star-skeleton makes besides, counter-clockwise. The other
        methods leave it out of account.
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
        If turns is no int.
    Cancelled
        If ``should_stop`` answered True.
    """
    chosen = target if isinstance(target, str) else method
    if chosen not in METHODS:
        raise UnknownMethod(f'there is no method "{chosen}"', "choose one of " + ", ".join(METHODS))
    turns = checked_turns(turns)
    task = Task(progress, should_stop)
    task.reach(0)
    pair = _pair(source, None if isinstance(target, str) else target, marks, should_stop)
    whole: dict[str, Callable[[], Blend]] = {
        "vertex": lambda: VertexBlend(pair),
        "edge-angle": lambda: EdgeAngleBlend(pair),
        "star-skeleton": lambda: StarSkeletonBlend(_decomposition(pair, decomposition, task), root, turns),
        "stitched": lambda: StitchedBlend(
            _decomposition(pair, decomposition, task), root, task.part(_DECOMPOSING, 1), settled=settled
        ),
        "rigid": lambda: RigidBlend(
            _decomposition(pair, decomposition, task), root, task.part(_DECOMPOSING, 1)
        ),
        "certified": lambda: CertifiedBlend(
            _decomposition(pair, decomposition, task), root, task.part(_DECOMPOSING, 1)
        ),
    }
    prepared = whole[chosen]()
    task.reach(1)
    return prepared


def checked_turns(given: int) -> int:
    """Give whole turns as an int.

    Raises
    ------
    StarskelError
        If they are none.
    """
    try:
        return operator.index(given)
    except TypeError:
        raise StarskelError(f"turns is {given!r}, and no int", "give whole turns, such as 1 or -2") from None


def _pair(
    source: Correspondence | PolygonLike,
    target: PolygonLike | None,
    marks: Iterable[tuple[int, int]],
    should_stop: ShouldStop | None,
) -> Correspondence:
    if not isinstance(source, Correspondence):
        if target is None:
            raise StarskelError("the target is missing", "give two polygons, or a pair made by match")
        return match(source, target, marks, should_stop=should_stop)
    if target is not None or tuple(marks):
        raise StarskelError("a pair has its target and its marks already", "give the pair alone")
    return source


def _decomposition(pair: Correspondence, known: Decomposition | None, task: Task) -> Decomposition:
    if known is None:
        return decompose(pair, progress=task.part(0, _DECOMPOSING).reach, should_stop=task.should_stop)
    if known.pair is not pair:
        raise StarskelError("the decomposition belongs to another pair", "decompose the pair to be blended")
    return known
