"""Freeing a stuck cell in several ways, to keep the one with the fewest Steiner vertices.

Small cells are freed by fans round one Steiner vertex at several places, larger ones by convex pieces of one
polygon carried over to the other as well: neither way is always the better.
"""

from starskel.decomposition.ladder import by_fans, cheapest
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

FEW = 6
"""One Steiner vertex for so many vertices of the cell is so few that nothing is carried over."""

HOPELESS = 4
"""What needs so many times the vertices of another way is not reduced: that takes long and seldom helps."""


def by_rivals(tiling: Tiling, grounds: Grounds, task: Task) -> Tiling:
    """Free a stuck cell, the only piece of a tiling, in the cheapest of several ways."""
    (cell,) = tiling.pieces
    n = len(tiling.source.coordinates)
    tried = max(1, min(MOST_TRIED, TRIED_VERTICES // len(cell)))
    found = by_fans(tiling, grounds, tried, task)
    if len(cell) > SMALL and not any(FEW * (fan.cost()[0] - len(cell)) <= len(cell) for fan in found):
        found.append(transfer(tiling, cell, task.quiet))
    hope = HOPELESS * min((rival.cost() for rival in found), default=(0, 0))[0]
    return cheapest(tiling, grounds, [reduce(rival, n, task) for rival in found if rival.cost()[0] <= hope])
