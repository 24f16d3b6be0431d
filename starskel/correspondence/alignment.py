"""The cheapest monotone alignment of two sequences, by dynamic programming; that of two chains of vertices.

In chains a match costs the differences in share of the length and in turning angle; a vertex left alone has
its price.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from starskel.arrays import Floats
from starskel.errors import told
from starskel.limits import ALIGNED_PAIRS, check_size
from starskel.outline import edge_lengths, turning_angles
from starskel.task import Task

TURN_PRICE = 0.3
"""The price of a difference in turning angle by pi; a difference in share by the whole length costs 1."""

ALONE_PRICE = 0.3
"""The price of a vertex without a partner, beside that of its turning angle."""

_AT_ONCE = 16
"""So many diagonals are filled between two questions whether to stop."""

_MATCH, _SKIP_FIRST, _SKIP_SECOND = 0, 1, 2


@dataclass(frozen=True, eq=False)
class Prices:
    """What aligning two sequences costs.

    Attributes
    ----------
    match : (..., p, q) array
        The price of matching each of the first with each of the second.
    first_alone : (..., p) array
    second_alone : (..., q) array
        The prices of leaving them alone. Leading axes hold alternatives that are aligned side by side.
    """

    match: Floats
    first_alone: Floats
    second_alone: Floats


def align(prices: Prices, task: Task) -> list[tuple[int, int]]:
    """Give the matched pairs of the cheapest alignment, in order."""
    _, moves = _cheapest(prices, task, keep_moves=True)
    pairs = []
    i, j = prices.match.shape
    while i and j:
        move = moves[i + j][i]
        i -= move != _SKIP_SECOND
        j -= move != _SKIP_FIRST
        if move == _MATCH:
            pairs.append((i, j))
    return pairs[::-1]


def alignment_prices(prices: Prices, task: Task) -> Floats:
    """Give the price of the cheapest alignment, for each of the alternatives."""
    return _cheapest(prices, task, keep_moves=False)[0]


def _cheapest(prices: Prices, task: Task, keep_moves: bool) -> tuple[Floats, list[NDArray[np.int8]]]:
    """Fill the table of prices by anti-diagonals; cell (i, j) aligns the first i and the first j.

    Column i of a diagonal stands at i + 1, behind a column of infinities. The prices of matching lie so that
    those of a diagonal are evenly spaced in memory.
    """
    *alternatives, p, q = prices.match.shape
    margins = [(0, 0)] * len(alternatives)
    match = np.pad(prices.match, [*margins, (1, 0), (1, 1)], constant_values=np.inf)
    match = match.reshape(*alternatives, (p + 1) * (q + 2))
    first = np.pad(prices.first_alone, [*margins, (1, 0)], constant_values=np.inf)
    second = np.pad(prices.second_alone, [*margins, (1, 0)], constant_values=np.inf)[..., ::-1]
    blank = np.full((*alternatives, p + 2), np.inf)
    before, last = blank, blank.copy()
    last[..., 1] = 0.0
    moves = [np.zeros(p + 1, dtype=np.int8)]
    for diagonal in range(1, p + q + 1):
        if diagonal % _AT_ONCE == 0:
            task.reach(0)
        low, high = max(0, diagonal - q), min(p, diagonal) + 1
        rows, columns = slice(low, high), slice(q - diagonal + low, q - diagonal + high)
        cells = slice(diagonal + low * (q + 1), diagonal + (high - 1) * (q + 1) + 1, q + 1)
        matched = match[..., cells] + before[..., rows]
        skip_first = last[..., rows] + first[..., rows]
        skip_second = last[..., low + 1 : high + 1] + second[..., columns]
        skip = np.minimum(skip_first, skip_second)
        before, last = last, blank.copy()
        last[..., low + 1 : high + 1] = np.minimum(matched, skip)
        if keep_moves:
            move = np.zeros(p + 1, dtype=np.int8)
            move[rows] = np.where(
                matched <= skip, _MATCH, np.where(skip_first <= skip_second, _SKIP_FIRST, _SKIP_SECOND)
            )
            moves.append(move)
    return last[..., p + 1], moves


@dataclass(frozen=True, eq=False)
class Chain:
    """The p inner vertices of a chain of an outline: shares of the chain's length, and turning angles."""

    shares: Floats
    turns: Floats

    @classmethod
    def of(cls, ring: Floats, start: int, end: int) -> "Chain":
        """Give the chain from one vertex of a ring to another, all the way round where they are the same."""
        n = len(ring)
        edges = (start + np.arange((end - start - 1) % n + 1)) % n
        arcs = np.cumsum(edge_lengths(ring)[edges])
        return cls(arcs[:-1] / arcs[-1], turning_angles(ring)[edges[1:]])


def chain_prices(first: Chain, second: Chain) -> Prices:
    """Give what aligning two chains costs.

    Raises
    ------
    StarskelError
        If the table of all pairs of their vertices would be too large.
    """
    pairs = len(first.shares) * len(second.shares)
    mend = told("set marks between them, or simplify the shapes")
    check_size(told("pairs of vertices to be compared"), pairs, ALIGNED_PAIRS, mend)
    turns = TURN_PRICE / np.pi * first.turns, TURN_PRICE / np.pi * second.turns
    match = np.abs(np.subtract.outer(first.shares, second.shares))
    match += np.abs(np.subtract.outer(*turns))
    return Prices(match, ALONE_PRICE + np.abs(turns[0]), ALONE_PRICE + np.abs(turns[1]))
