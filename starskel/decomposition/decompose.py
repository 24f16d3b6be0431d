"""From a pair to its decomposition: the fewest pieces, or else the ladder."""

import numpy as np

from starskel.correspondence import Correspondence
from starskel.decomposition.kernel import star_point, star_vertices
from starskel.decomposition.ladder import climb
from starskel.decomposition.links import links_of
from starskel.decomposition.minimal import minimal_pieces
from starskel.decomposition.pieces import Decomposition
from starskel.decomposition.reduce import reduce
from starskel.decomposition.tiling import Tiling
from starskel.errors import NoDecomposition
from starskel.predicates import Floats
from starskel.task import Progress, ShouldStop, Task
from starskel.triangulation import triangulate


def decompose(
    pair: Correspondence,
    *,
    steiner: bool = True,
    progress: Progress | None = None,
    should_stop: ShouldStop | None = None,
) -> Decomposition:
    """Cut both polygons of a pair into compatible star pieces (paper, section 2.4.1).

    Where no Steiner vertices are needed the pieces are as few as can be, and of the decompositions with so
    few pieces it is the one with the shortest cuts. Elsewhere Steiner vertices are placed, few of them.

    Parameters
    ----------
    pair : Correspondence
        Two simple polygons of equal count.
    steiner : bool
        Whether Steiner vertices are allowed.
    progress : callable, optional
        Called with the fraction done.
    should_stop : callable, optional
        Asked often whether to give up.

    Raises
    ------
    NoDecomposition
        If Steiner vertices are needed and not allowed.
    Cancelled
        If `should_stop` answered True.
    """
    task = Task(progress, should_stop)
    task.reach(0)
    pieces = minimal_pieces(links_of(triangulate(pair.source), triangulate(pair.target)), task.part(0.1, 0.5))
    if pieces is not None:
        tiling = Tiling(pair.source, pair.target, tuple(pieces))
    elif steiner:
        tiling = climb(pair.source, pair.target, task.part(0.5, 0.9))
        tiling = reduce(tiling, len(pair.source), task.part(0.9, 1))
    else:
        raise NoDecomposition(
            "the two polygons have no compatible star decomposition without Steiner vertices",
            "allow Steiner vertices, or change the marks",
        )
    task.reach(1)
    return _with_origins(pair, tiling)


def _with_origins(pair: Correspondence, tiling: Tiling) -> Decomposition:
    origins = [_origins(tiling.source[list(piece)], tiling.target[list(piece)]) for piece in tiling.pieces]
    source, target = (np.array(side) for side in zip(*origins, strict=True))
    return Decomposition(pair, tiling.source, tiling.target, tiling.pieces, source, target)


def _origins(source: Floats, target: Floats) -> tuple[Floats, Floats]:
    """Give the mean of the common star vertices (paper, section 2.4.2), or the centroids of both kernels."""
    common = star_vertices(source) & star_vertices(target)
    if common.any():
        return source[common].mean(axis=0), target[common].mean(axis=0)
    places = star_point(source), star_point(target)
    if places[0] is None or places[1] is None:
        raise AssertionError("a piece is not star-shaped")
    return places[0], places[1]
