"""Freeing stuck cells in several ways, to keep the one with the fewest Steiner vertices.

Small cells are freed by fans round one Steiner vertex at several places, larger ones by convex pieces of one
polygon carried over to the other as well: neither way is always the better.
"""

from collections.abc import Sequence
from contextlib import suppress

from starskel.decomposition.board import Board
from starskel.decomposition.ladder import by_fan, cheapest, spread
from starskel.decomposition.moves.reduce import reduce
from starskel.decomposition.pieces import Piece, cost
from starskel.decomposition.steiner import Fan, Stuck, survey
from starskel.decomposition.transfer.transfer import transfer
from starskel.task import Task

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

HIDDEN = 0.5
"""In a large cell a fan that leaves more of the vertices hidden is never the first of few."""

HOPE = 0.65
"""The best fan at one place in each triangle hides little more than the best of all: beyond this share of the
vertices it is not worth looking for that."""

HOPELESS = 3
"""What needs so many times the Steiner vertices of a way that is reduced is not: it seldom gets better."""


class _TooManyError(Exception):
    """Fans need more Steiner vertices than are worth it."""


class _Contest:
    """A stuck cell and the ways to free it that were found, reduced, the best first."""

    def __init__(self, stuck: Stuck) -> None:
        self.stuck = stuck
        self.found: list[list[Piece]] = []

    @property
    def fewest(self) -> int | None:
        """The Steiner vertices of the best way."""
        return self.placed(self.found[0]) if self.found else None

    def placed(self, pieces: list[Piece]) -> int:
        """Give how many Steiner vertices free the cell in a way."""
        return cost(pieces)[0] - len(self.stuck.ring)


def by_rivals(board: Board, cells: list[Piece], task: Task) -> list[list[Piece]]:
    """Free stuck cells, each in the cheapest of several ways."""
    contests = [_Contest(stuck) for stuck in _surveyed(board, cells, task.quiet)]
    task.reach(0.1)
    small = [contest for contest in contests if len(contest.stuck.ring) <= LARGE]
    _fan_out(board, [(c, fan) for c in small for fan in c.stuck.fans[:1]], task.quiet)
    open_still = [c for c in small if c.fewest != 1]  # a stuck cell needs one at least
    _fan_out(board, [(c, fan) for c in open_still for fan in c.stuck.fans[1:]], task.quiet)
    for at, contest in enumerate(contests):
        task.reach(0.3 + 0.7 * at / len(contests))
        if len(contest.stuck.ring) > LARGE:
            with suppress(_TooManyError):
                _admit(board, [(contest, _few(board, contest.stuck, task.quiet))], task)
        _carry_over(board, contest, task.quiet)
    return [cheapest(board, contest.stuck, contest.found, task.quiet) for contest in contests]


def _surveyed(board: Board, cells: list[Piece], task: Task) -> list[Stuck]:
    """Look for fans in all cells, but in large ones thoroughly only where a glance gives hope."""
    large = [cell for cell in cells if len(cell) > LARGE]
    glanced = survey(board, large, [1] * len(large), task, samples=1)
    found = {stuck.ring: stuck for stuck in glanced if _hides(stuck, HOPE)}
    left = [cell for cell in cells if cell not in found]
    tried = [max(1, min(MOST_TRIED, TRIED_VERTICES // len(cell))) for cell in left]
    found.update((stuck.ring, stuck) for stuck in survey(board, left, tried, task))
    return [found[cell] for cell in cells]


def _hides(stuck: Stuck, share: float) -> bool:
    """Tell whether the best fan leaves more than a share of the vertices hidden."""
    return not stuck.fans or stuck.fans[0].hidden > share * len(stuck.ring)


def _fan_out(board: Board, fans: list[tuple[_Contest, Fan]], task: Task) -> None:
    """Free cells beginning with fans, all of them at once."""
    rings = [(contest.stuck.ring, fan) for contest, fan in fans]
    tiled = spread(board, rings, by_fan, task)
    _admit(board, [(contest, pieces) for (contest, _), pieces in zip(fans, tiled, strict=True)], task)


def _few(board: Board, stuck: Stuck, task: Task) -> list[Piece]:
    """Free a large cell by fans, as long as these are few."""
    if _hides(stuck, HIDDEN):
        raise _TooManyError
    most = len(board) + len(stuck.ring) // FEW

    def free(board: Board, cells: list[Piece], task: Task) -> list[list[Piece]]:
        if len(board) + len(cells) > most:
            raise _TooManyError
        looked = survey(board, cells, [1] * len(cells), task)
        if len(board) + sum(1 if cell.fans else cell.crossings for cell in looked) > most:
            raise _TooManyError
        fanned = iter(spread(board, [(cell.ring, cell.fans[0]) for cell in looked if cell.fans], free, task))
        return [cheapest(board, cell, [next(fanned)] if cell.fans else [], task) for cell in looked]

    return spread(board, [(stuck.ring, stuck.fans[0])], free, task)[0]


def _carry_over(board: Board, contest: _Contest, task: Task) -> None:
    """Carry convex pieces over where the cell is large and fans need many Steiner vertices."""
    n = len(contest.stuck.ring)
    if n > SMALL and (contest.fewest is None or FEW * contest.fewest > n):
        _admit(board, [(contest, transfer(board, contest.stuck.ring, task))], task)


def _admit(board: Board, rivals: Sequence[tuple[_Contest, list[Piece]]], task: Task) -> None:
    """Reduce rivals, unless they are hopeless, and put them among those found."""
    hopeful = [
        (contest, pieces)
        for contest, pieces in rivals
        if contest.fewest is None or contest.placed(pieces) <= HOPELESS * contest.fewest
    ]
    reduced = reduce(board, [pieces for _, pieces in hopeful], task)
    for (contest, _), pieces in zip(hopeful, reduced, strict=True):
        contest.found.append(pieces)
        contest.found.sort(key=cost)
