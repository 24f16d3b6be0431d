"""From a pair to its decomposition: the fewest pieces, or else the ladder."""

from collections.abc import Callable

import numpy as np

from starskel.arguments import choice, truth
from starskel.arrays import Floats
from starskel.correspondence import Correspondence, checked_pair
from starskel.decomposition.board import Board
from starskel.decomposition.canonical import PairReading, canonical
from starskel.decomposition.kernels.kernel import star_points, star_vertices
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.minimal import minimal_pieces
from starskel.decomposition.pieces import Decomposition, Piece
from starskel.decomposition.polish import polished
from starskel.decomposition.rivals import by_rivals
from starskel.decomposition.thinning import refilled, thinned
from starskel.decomposition.transfer.transfer import transfer
from starskel.errors import NoDecomposition, told
from starskel.limits import DECOMPOSED_VERTICES, check_size
from starskel.points import points_of
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
    a corner. Of more than 2000 vertices those on straight runs of both polygons are left out of the search as
    far as need be: then the pieces are few, not always as few as can be.

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
        If there is no algorithm of that name, something else is no pair of polygons, or the pair has too many
        vertices for the memory there is.
    Cancelled
        If `should_stop` answered True.

    Examples
    --------
    >>> import starskel
    >>> hook = [(0, 0), (6, 0), (6, 5), (3, 5), (3, 4), (5, 4), (5, 1), (0, 1)]
    >>> pair = starskel.match(hook, hook, marks=[(0, 0)])
    >>> decomposition = starskel.decompose(pair)
    >>> decomposition.pieces
    ((7, 0, 1, 6), (1, 2, 3, 4, 5, 6))
    >>> decomposition.source_origins.tolist()
    [[2.75, 0.5], [5.5, 4.5]]
    """
    checked_pair(pair)
    tile = _minimal if choice(algorithm, ALGORITHMS, "the algorithm") == "minimal" else _convex
    steiner = truth(steiner, "steiner")
    return _decomposed(
        pair, lambda board, whole, task: tile(board, whole, steiner, task), Task(progress, should_stop)
    )


def decompose_quickly(pair: Correspondence, task: Task) -> Decomposition:
    """Cut both polygons into compatible star pieces, as `decompose` does, but into more than need be.

    Stuck cells are freed by fans alone, without trying other ways: that is several times as fast.
    """
    return _decomposed(pair, _by_fans, task)


def _decomposed(
    pair: Correspondence, tile: Callable[[Board, Piece, Task], list[Piece]], task: Task
) -> Decomposition:
    task.reach(0)
    reading = canonical(pair)
    board = Board(*(points_of(ring) for ring in reading.read(pair)))
    whole = thinned(board)
    pieces = refilled(tile(board, whole, task), whole, board.n)
    found = _finished(pair, board, pieces, reading, task.quiet)
    task.reach(1)
    return found


def _minimal(board: Board, whole: Piece, steiner: bool, task: Task) -> list[Piece]:
    if board.are_stars([whole], task.quiet)[0]:  # the tables would take O(n^3) to end with no fewer
        return [whole]
    _check_size(whole)
    pieces = minimal_pieces(board.links([whole], task.quiet), task.part(0, 0.5))
    if pieces is not None:
        return pieces
    if not steiner:
        raise NoDecomposition(
            "the two polygons have no compatible star decomposition without Steiner vertices",
            "allow Steiner vertices, or change the marks",
        )
    (pieces,) = climb(board, [whole], by_rivals, task.part(0.5, 0.9))
    return polished(board, pieces, task.part(0.9, 1))


def _by_fans(board: Board, whole: Piece, task: Task) -> list[Piece]:
    _check_size(whole)
    return climb(board, [whole], by_fan, task)[0]


def _check_size(whole: Piece) -> None:
    mend = told("simplify the shapes, or take a method that needs no pieces")
    check_size(told("vertices to be cut into pieces"), len(whole), DECOMPOSED_VERTICES, mend)


def _convex(board: Board, whole: Piece, steiner: bool, task: Task) -> list[Piece]:
    if board.are_stars([whole], task.quiet)[0]:
        return [whole]
    _check_size(whole)
    pieces = transfer(board, whole, task.part(0, 0.9))
    pieces = polished(board, pieces, task.part(0.9, 1))
    if not steiner and any(v >= board.n for piece in pieces for v in piece):
        raise NoDecomposition(
            "the convex pieces of neither polygon can be carried over without Steiner vertices",
            'allow Steiner vertices, or take the algorithm "minimal"',
        )
    return pieces


def _finished(
    pair: Correspondence, board: Board, pieces: list[Piece], reading: PairReading, task: Task
) -> Decomposition:
    """Count rows from the pair's own, drop the Steiner vertices that no piece uses, and find the origins."""
    n = board.n
    placed = sorted({v for p in pieces for v in p if v >= n})
    name = dict(zip(placed, range(n, n + len(placed)), strict=True))
    name.update(enumerate(reading.rows(n).tolist()))
    named = tuple(reading.turned(tuple(name[v] for v in piece)) for piece in pieces)
    rows = [*np.argsort(reading.rows(n)).tolist(), *placed]
    source, target = reading.ordered([reading.placed(side.coordinates[rows]) for side in board.sides])
    origins = [reading.placed(places) for places in _origins(board, pieces, task)]
    return Decomposition(pair, source, target, named, *reading.ordered(origins))


def _origins(board: Board, pieces: list[Piece], task: Task) -> list[Floats]:
    """Give the means of the common star vertices (paper, section 2.4.2), or the centroids of both kernels."""
    rings = Rings.of(pieces)
    stars = np.flatnonzero(star_vertices(board.sides, rings, task))
    common = np.bincount(rings.owner[stars], minlength=len(pieces))
    without = np.flatnonzero(common == 0)
    left = Rings.of([pieces[k] for k in without.tolist()])
    origins = []
    for side, (places, areas) in zip(board.sides, star_points(board.sides, left, task), strict=True):
        if not (areas > 0).all():
            raise AssertionError("a piece is not star-shaped")
        means = np.zeros((len(pieces), 2))
        np.add.at(means, rings.owner[stars], side.coordinates[rings.rows[stars]])
        means /= np.maximum(common, 1)[:, None]
        means[without] = places
        origins.append(means)
    return origins
