"""Which vertices of two outlines correspond: the cheapest monotone alignment, by dynamic programming.

A match costs the differences in share of the length and in turning angle; a vertex left alone has its price.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from starskel.outline import edge_lengths, turning_angles
from starskel.predicates import Floats
from starskel.task import Task

TURN_PRICE = 0.3
"""The price of a difference in turning angle by pi; a difference in share by the whole length costs 1."""

ALONE_PRICE = 0.3
"""The price of a vertex without a partner, beside that of its turning angle."""

_UNWATCHED = 16
"""So many diagonals are filled between two questions whether to stop."""

_MATCH, _SKIP_FIRST, _SKIP_SECOND = 0, 1, 2


@dataclass(frozen=True, eq=False)
class Chains:
    """The inner vertices of chains of an outline: shares of the chain's length, and turning angles.

    Attributes
    ----------
    shares, turns : (..., p) arrays
        Leading axes hold alternatives that are aligned side by side.
    """

    shares: Floats
    turns: Floats

    @classmethod
    def of(cls, ring: Floats, start: int, end: int) -> "Chains":
        """Give the chain from one vertex of a ring to another, all the way round where they are the same."""
        n = len(ring)
        edges = (start + np.arange((end - start - 1) % n + 1)) % n
        arcs = np.cumsum(edge_lengths(ring)[edges])
        return cls(arcs[:-1] / arcs[-1], turning_angles(ring)[edges[1:]])

    @classmethod
    def round(cls, ring: Floats, starts: NDArray[np.intp]) -> "Chains":
        """Give for each start the chain from there all the way round."""
        order = (starts[:, None] + np.arange(len(ring))) % len(ring)
        arcs = np.cumsum(edge_lengths(ring)[order], axis=1)
        return cls(arcs[:, :-1] / arcs[:, -1:], turning_angles(ring)[order[:, 1:]])


def align(first: Chains, second: Chains, task: Task) -> list[tuple[int, int]]:
    """Give the matched pairs of inner vertices of two chains, in order."""
    _, moves = _cheapest(first, second, task, keep_moves=True)
    pairs = []
    i, j = first.shares.shape[-1], second.shares.shape[-1]
    while i and j:
        move = moves[i + j][i]
        i -= move != _SKIP_SECOND
        j -= move != _SKIP_FIRST
        if move == _MATCH:
            pairs.append((i, j))
    return pairs[::-1]


def alignment_prices(first: Chains, second: Chains, task: Task) -> Floats:
    """Give the price of the cheapest alignment of the chains, for each of the alternatives."""
    return _cheapest(first, second, task, keep_moves=False)[0]


def _cheapest(
    first: Chains, second: Chains, task: Task, keep_moves: bool
) -> tuple[Floats, list[NDArray[np.int8]]]:
    """Fill the table of prices by anti-diagonals; cell (i, j) aligns the first i and j inner vertices.

    Whole diagonals at once, with the second chain reversed so that both are read forwards. Column i of a
    diagonal stands at i + 1, behind a column of infinities.
    """
    p, q = first.shares.shape[-1], second.shares.shape[-1]
    one, other = _padded(first, front=True), _padded(second, front=False)
    blank = np.full((*np.broadcast_shapes(first.shares.shape[:-1], second.shares.shape[:-1]), p + 2), np.inf)
    before, last = blank, blank.copy()
    last[..., 1] = 0.0
    moves = [np.zeros(p + 1, dtype=np.int8)]
    for diagonal in range(1, p + q + 1):
        if diagonal % _UNWATCHED == 0:
            task.reach(0)
        low, high = max(0, diagonal - q), min(p, diagonal) + 1
        rows, columns = slice(low, high), slice(q - diagonal + low, q - diagonal + high)
        match = np.abs(one.shares[..., rows] - other.shares[..., columns])
        match += np.abs(one.turns[..., rows] - other.turns[..., columns]) + before[..., rows]
        skip_first = last[..., rows] + one.alone[..., rows]
        skip_second = last[..., low + 1 : high + 1] + other.alone[..., columns]
        skip = np.minimum(skip_first, skip_second)
        before, last = last, blank.copy()
        last[..., low + 1 : high + 1] = np.minimum(match, skip)
        if keep_moves:
            move = np.zeros(p + 1, dtype=np.int8)
            move[rows] = np.where(
                match <= skip, _MATCH, np.where(skip_first <= skip_second, _SKIP_FIRST, _SKIP_SECOND)
            )
            moves.append(move)
    return last[..., p + 1], moves


@dataclass(frozen=True, eq=False)
class _Padded:
    """Chains in the units of the price, with one vertex more that fits nothing."""

    shares: Floats
    turns: Floats
    alone: Floats


def _padded(chains: Chains, front: bool) -> _Padded:
    """Put the extra vertex in front; or reverse the chain and put it at the end."""
    turns = TURN_PRICE / np.pi * chains.turns
    rows = (chains.shares, turns, ALONE_PRICE + np.abs(turns))
    width = [(0, 0)] * (chains.shares.ndim - 1) + [(1, 0) if front else (0, 1)]
    shares, turns, alone = (
        np.pad(row if front else row[..., ::-1], width, constant_values=value)
        for row, value in zip(rows, (np.inf, 0.0, np.inf), strict=True)
    )
    if not front:
        shares[..., -1] = -np.inf  # infinitely far from the first chain's extra vertex, too
    return _Padded(shares, turns, alone)
