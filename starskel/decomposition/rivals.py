"""Freeing a stuck cell in several ways, to keep the one with the fewest Steiner vertices.

Small cells are freed by fans round one Steiner vertex at several places, larger ones by convex pieces of one
polygon carried over to the other as well: neither way is always the better.
"""

from collections.abc import Iterator
from contextlib import suppress

from starskel.decomposition.ladder import by_fan, by_fans, cheapest
from starskel.decomposition.pieces import Piece
from starskel.decomposition.reduce import reduce
from starskel.decomposition.tiling import Tiling
from starskel.decomposition.transfer import transfer
from starskel.task import Task
from starskel.triangulation import Grounds

MOST_TRIED = 6
"""Places of a Steiner vertex that are tried to the end before one is chosen, in small cells."""

TRIED_VERTICES = 80
"""In larger cells as many places are tried as have so many vertices together, but one at least."""

SMALL = 20
"""Up to so many vertices fans are as good as what is carried over, and quicker found."""

LARGE = 40
"""In cells of more vertices fans are good only where they need few Steiner vertices."""

FEW = 6
"""One Steiner vertex for so many vertices of the cell is so few that nothing is carried over."""

HOPELESS = 3
"""What needs so many times the Steiner vertices of a way that is reduced is not: it seldom gets better."""


class _TooManyError(Exception):
    """Fans need more Steiner vertices than are worth it."""


def by_rivals(tiling: Tiling, grounds: Grounds, task: Task) -> Tiling:
    """Free a stuck cell, the only piece of a tiling, in the cheapest of several ways."""
    (cell,) = tiling.pieces
    n = len(tiling.source.coordinates)
    found: list[Tiling] = []
    for rival in _fanned(tiling, grounds, task):
        _admit(rival, found, cell, n, task)
        if _placed(found[0], cell) == 1:  # a stuck cell needs one at least
            break
    if len(cell) > SMALL and not any(FEW * _placed(fan, cell) <= len(cell) for fan in found):
        _admit(transfer(tiling, cell, task.quiet), found, cell, n, task)
    return cheapest(tiling, grounds, found)


def _fanned(tiling: Tiling, grounds: Grounds, task: Task) -> Iterator[Tiling]:
    """Give the ways that begin with a fan; in large cells they are given up once they cost too much."""
    (cell,) = tiling.pieces
    tried = max(1, min(MOST_TRIED, TRIED_VERTICES // len(cell)))
    if len(cell) <= LARGE:
        yield from by_fans(tiling, grounds, tried, by_fan, task)
        return
    most = len(tiling.source.coordinates) + len(cell) // FEW

    def by_few(tiling: Tiling, grounds: Grounds, task: Task) -> Tiling:
        if len(tiling.source.coordinates) >= most:
            raise _TooManyError
        freed = cheapest(tiling, grounds, list(by_fans(tiling, grounds, 1, by_few, task)))
        if len(freed.source.coordinates) > most:  # an overlay
            raise _TooManyError
        return freed

    with suppress(_TooManyError):
        yield from by_fans(tiling, grounds, tried, by_few, task)


def _admit(rival: Tiling, found: list[Tiling], cell: Piece, n: int, task: Task) -> None:
    """Reduce a rival, unless it is hopeless, and put it among those found, the best first."""
    if not found or _placed(rival, cell) <= HOPELESS * _placed(found[0], cell):
        found.append(reduce(rival, n, task))
        found.sort(key=Tiling.cost)


def _placed(tiling: Tiling, cell: Piece) -> int:
    """Give how many Steiner vertices free the cell."""
    return tiling.cost()[0] - len(cell)
