"""The cheapest monotone alignment of two sequences, by dynamic programming; that of two chains of vertices.

In chains a match costs the differences in share of the length and in turning angle; a vertex left alone has
its price.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

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


class Prices(Protocol):
    """What aligning two sequences of p and q costs; leading axes hold alternatives, aligned side by side."""

    @property
    def first_alone(self) -> Floats:
        """The prices of leaving alone each of the first, (..., p)."""

    @property
    def second_alone(self) -> Floats:
        """The prices of leaving alone each of the second, (..., q)."""

    def along(self, diagonal: int, low: int, high: int) -> Floats:
        """Give the prices of matching the i-th of the first, from 1, with the (diagonal - i)-th of the other.

        Parameters
        ----------
        diagonal : int
        low, high : int
            i goes from the one up to the other; where i or diagonal - i is 0 the price is infinite.
        """


@dataclass(frozen=True, eq=False)
class Table:
    """Prices of which each is known by itself.

    Attributes
    ----------
    match : (..., p, q) array
        The price of matching each of the first with each of the second.
    first_alone : (..., p) array
    second_alone : (..., q) array
    """

    match: Floats
    first_alone: Floats
    second_alone: Floats

    def along(self, diagonal: int, low: int, high: int) -> Floats:
        """Give the prices along a diagonal, as `Prices` says: they are evenly spaced in memory."""
        step = self.match.shape[-1] + 1
        return self._flat[..., diagonal + low * step : diagonal + (high - 1) * step + 1 : step]

    @cached_property
    def _flat(self) -> Floats:
        *alternatives, p, q = self.match.shape
        margins = [*[(0, 0)] * len(alternatives), (1, 0), (1, 1)]
        padded = np.pad(self.match, margins, constant_values=np.inf)
        return padded.reshape(*alternatives, (p + 1) * (q + 2))


def align(prices: Prices, task: Task) -> list[tuple[int, int]]:
    """Give the matched pairs of the cheapest alignment, in order."""
    _, moves = _cheapest(prices, task, keep_moves=True)
    pairs = []
    i, j = prices.first_alone.shape[-1], (q := prices.second_alone.shape[-1])
    while i and j:
        move = moves[i + j][i - max(0, i + j - q)]
        i -= move != _SKIP_SECOND
        j -= move != _SKIP_FIRST
        if move == _MATCH:
            pairs.append((i, j))
    return pairs[::-1]


def alignment_prices(prices: Prices, task: Task) -> Floats:
    """Give the (...) prices of the cheapest alignments, one for each of the alternatives."""
    return _cheapest(prices, task, keep_moves=False)[0]


def _cheapest(prices: Prices, task: Task, keep_moves: bool) -> tuple[Floats, list[NDArray[np.int8]]]:
    """Fill the table of prices by anti-diagonals; cell (i, j) aligns the first i and the first j.

    Column i of a diagonal stands at i + 1, behind a column of infinities. Of each diagonal only the moves are
    kept, a byte for each of its cells.
    """
    *alternatives, p = prices.first_alone.shape
    q = prices.second_alone.shape[-1]
    margins = [*[(0, 0)] * len(alternatives), (1, 0)]
    first = np.pad(prices.first_alone, margins, constant_values=np.inf)
    second = np.pad(prices.second_alone, margins, constant_values=np.inf)[..., ::-1]
    blank = np.full((*alternatives, p + 2), np.inf)
    before, last = blank, blank.copy()
    last[..., 1] = 0.0
    moves = [np.zeros(1, dtype=np.int8)]
    for diagonal in range(1, p + q + 1):
        if diagonal % _AT_ONCE == 0:
            task.reach(0)
        low, high = max(0, diagonal - q), min(p, diagonal) + 1
        rows, columns = slice(low, high), slice(q - diagonal + low, q - diagonal + high)
        matched = prices.along(diagonal, low, high) + before[..., rows]
        skip_first = last[..., rows] + first[..., rows]
        skip_second = last[..., low + 1 : high + 1] + second[..., columns]
        skip = np.minimum(skip_first, skip_second)
        before, last = last, blank.copy()
        last[..., low + 1 : high + 1] = np.minimum(matched, skip)
        if keep_moves:
            skipped = np.where(skip_first <= skip_second, _SKIP_FIRST, _SKIP_SECOND)
            moves.append(np.where(matched <= skip, _MATCH, skipped).astype(np.int8))
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


class ChainPrices:
    """What aligning two chains costs; the prices of matches are made when they are asked for.

    Parameters
    ----------
    first, second : Chain

    Raises
    ------
    StarskelError
        If there are too many pairs of their vertices.
    """

    def __init__(self, first: Chain, second: Chain) -> None:
        pairs = len(first.shares) * len(second.shares)
        mend = told("set marks between them, or simplify the shapes")
        check_size(told("pairs of vertices to be compared"), pairs, ALIGNED_PAIRS, mend)
        turns = [TURN_PRICE / np.pi * chain.turns for chain in (first, second)]
        self.first_alone, self.second_alone = (ALONE_PRICE + np.abs(own) for own in turns)
        self._count = len(second.shares)
        self._shares = _edged(first.shares, np.inf), _edged(second.shares, np.inf)[::-1]
        self._turns = _edged(turns[0], 0.0), _edged(turns[1], 0.0)[::-1]

    def along(self, diagonal: int, low: int, high: int) -> Floats:
        """Give the prices along a diagonal, as `Prices` says."""
        i, j = slice(low, high), slice(self._count - diagonal + low, self._count - diagonal + high)
        prices: Floats = np.abs(self._shares[0][i] - self._shares[1][j])
        prices += np.abs(self._turns[0][i] - self._turns[1][j])
        return prices


def _edged(values: Floats, edge: float) -> Floats:
    return np.concatenate([[edge], values])
