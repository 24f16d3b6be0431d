"""From a pair to its decomposition: the fewest pieces, or else the ladder."""

from collections.abc import Callable

import numpy as np

from starskel.correspondence import Correspondence
from starskel.decomposition.kernel import star_points, star_vertices
from starskel.decomposition.ladder import by_fan, climb, triangulated
from starskel.decomposition.links import links_of
from starskel.decomposition.minimal import minimal_pieces
from starskel.decomposition.pieces import Decomposition, Piece
from starskel.decomposition.reduce import reduce
from starskel.decomposition.rivals import by_rivals
from starskel.decomposition.shape import shaped
from starskel.decomposition.tiling import Tiling
from starskel.decomposition.transfer import transfer
from starskel.errors import NoDecomposition, StarskelError
from starskel.outline import precedes
from starskel.points import points_of
from starskel.predicates import Floats
from starskel.rings import Rings
from starskel.task import Progress, ShouldStop, Task

ALGORITHMS = ("minimal", "convex")


def decompose(
    pair: Correspondence,
    *,
    algorithm: str = "minimal",
    steiner: bool = True,
    progress: Progress | None = None,
    should_stop: ShouldStop | None = None,
) -> Decomposition:
    """Cut both polygons of a pair into compatible star pieces (paper, section 2.4.1).

    The paper has two algorithms. By "minimal", polygons that are star-shaped are one piece, also where their
    kernels have no vertex in common. Else, where no Steiner vertices are needed, the pieces, each with a
    common star vertex, are as few as can be, and of the decompositions with so few pieces it is the one with
    the shortest cuts. Elsewhere Steiner vertices are placed, few of them. By "convex" a convex decomposition
    of one polygon is carried over to the other and refined, with Steiner vertices where a cut has to go round
    a corner.

    Parameters
    ----------
    pair : Correspondence
        Two simple polygons of equal count.
    algorithm : str
        "minimal" or "convex".
    steiner : bool
        Whether Steiner vertices are allowed.
    progress : callable, optional
        Called with the fraction done.
    should_stop : callable, optional
        Asked often whether to give up.

    Raises
    ------
    NoDecomposition
        If the algorithm needs Steiner vertices and they are not allowed.
    StarskelError
        If there is no algorithm of that name.
    Cancelled
        If `should_stop` answered True.
    """
    if algorithm not in ALGORITHMS:
        raise StarskelError(f"there is no algorithm {algorithm!r}", f"take one of {', '.join(ALGORITHMS)}")
    tile = _minimal if algorithm == "minimal" else _convex
    return _decomposed(
        pair, lambda tiling, whole, task: tile(tiling, whole, steiner, task), Task(progress, should_stop)
    )


def decompose_quickly(pair: Correspondence, task: Task) -> Decomposition:
    """Cut both polygons into compatible star pieces, as `decompose` does, but into more than need be.

    Stuck cells are freed by fans alone, without trying other ways: that is several times as fast.
    """
    return _decomposed(pair, lambda tiling, whole, task: climb(tiling, whole, by_fan, task), task)


def _decomposed(
    pair: Correspondence, tile: Callable[[Tiling, Piece, Task], Tiling], task: Task
) -> Decomposition:
    task.reach(0)
    whole = tuple(range(len(pair.source)))
    swapped, start = _canonical(pair)
    source, target = (points_of(np.roll(ring, -start, axis=0)) for ring in (pair.source, pair.target))
    tiling = Tiling(target, source, (whole,)) if swapped else Tiling(source, target, (whole,))
    tiling = tile(tiling, whole, task)
    found = _finished(pair, tiling.swapped() if swapped else tiling, start, task.quiet)
    task.reach(1)
    return found


def _canonical(pair: Correspondence) -> tuple[bool, int]:
    """Choose which polygon counts as the source, and which row as the first, by the points alone.

    So a pair is decomposed in one way, whichever of its polygons is the source and whatever row it starts at.
    """
    rings = pair.source, pair.target
    starts = [int(np.lexsort(ring.T[::-1])[0]) for ring in rings]
    ways = [
        np.roll(np.concatenate(ordered, axis=1), -start, axis=0)
        for ordered, start in zip((rings, rings[::-1]), starts, strict=True)
    ]
    swapped = precedes(ways[1], ways[0])
    return swapped, starts[swapped]


def _minimal(tiling: Tiling, whole: Piece, steiner: bool, task: Task) -> Tiling:
    if tiling.is_star(whole, task.quiet):  # the tables would take O(n^3) to end with no fewer
        return tiling
    pieces = _fewest(tiling, whole, task.part(0, 0.5))
    if pieces is not None:
        return tiling.replace(whole, pieces)
    if not steiner:
        raise NoDecomposition(
            "the two polygons have no compatible star decomposition without Steiner vertices",
            "allow Steiner vertices, or change the marks",
        )
    tiling = climb(tiling, whole, by_rivals, task.part(0.5, 0.9))
    return _polished(tiling, len(whole), task.part(0.9, 1))


def _convex(tiling: Tiling, whole: Piece, steiner: bool, task: Task) -> Tiling:
    if tiling.is_star(whole, task.quiet):
        return tiling
    tiling = transfer(tiling, whole, task.part(0, 0.9))
    tiling = _polished(tiling, len(whole), task.part(0.9, 1))
    if not steiner and any(v >= len(whole) for piece in tiling.pieces for v in piece):
        raise NoDecomposition(
            "the convex pieces of neither polygon can be carried over without Steiner vertices",
            'allow Steiner vertices, or take the algorithm "minimal"',
        )
    return tiling


def _polished(tiling: Tiling, n: int, task: Task) -> Tiling:
    """Drop Steiner vertices and pieces that are not needed; vertices in better places free more of them."""
    tiling = reduce(tiling, n, task.quiet)
    tiling = shaped(tiling, n, task.quiet)
    return reduce(tiling, n, task)


def _fewest(tiling: Tiling, whole: Piece, task: Task) -> list[Piece] | None:
    task.quiet.reach(0)
    grounds = triangulated(tiling, whole, task.quiet)
    return minimal_pieces(links_of(*grounds, task.quiet), task)


def _finished(pair: Correspondence, tiling: Tiling, start: int, task: Task) -> Decomposition:
    """Count rows from the pair's own, drop the Steiner vertices that no piece uses, and find the origins."""
    n = len(pair.source)
    rows = [*((v - start) % n for v in range(n)), *sorted({v for p in tiling.pieces for v in p if v >= n})]
    name = {old: new for new, old in enumerate(rows)}
    return Decomposition(
        pair,
        tiling.source.coordinates[rows],
        tiling.target.coordinates[rows],
        tuple(tuple(name[v] for v in piece) for piece in tiling.pieces),
        *_origins(tiling, task),
    )


def _origins(tiling: Tiling, task: Task) -> tuple[Floats, Floats]:
    """Give the means of the common star vertices (paper, section 2.4.2), or the centroids of both kernels."""
    rings = Rings.of(tiling.pieces)
    stars = np.flatnonzero(star_vertices((tiling.source, tiling.target), rings, task))
    common = np.bincount(rings.owner[stars], minlength=len(tiling.pieces))
    without = np.flatnonzero(common == 0)
    left = Rings.of([tiling.pieces[k] for k in without.tolist()])
    origins = []
    for side in (tiling.source, tiling.target):
        places = np.zeros((len(tiling.pieces), 2))
        np.add.at(places, rings.owner[stars], side.coordinates[rings.rows[stars]])
        places /= np.maximum(common, 1)[:, None]
        places[without], areas = star_points(side, left, task)
        if not (areas > 0).all():
            raise AssertionError("a piece is not star-shaped")
        origins.append(places)
    return origins[0], origins[1]
