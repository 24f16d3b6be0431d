"""Steiner vertices that may collapse into a neighbour: all pieces round them stay simple and star-shaped.

Of the kernels of all rings that might come of it most are empty. They are cut in floating point first: once
along what stays of a piece, then for each neighbour along the two edges that change. Only what has an inside
then is looked at exactly.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Indices
from starskel.decomposition.board import Board
from starskel.decomposition.clipping import kernels_of_chains
from starskel.decomposition.pieces import Around, Piece, chain_after, from_least
from starskel.rings import Rings, ranges
from starskel.task import Task


@dataclass(frozen=True)
class _Collapse:
    """What becomes of chains, the pieces round a vertex without it, as a neighbour takes its place."""

    at: int
    neighbour: int
    chains: range


def collapses(board: Board, stars: Sequence[Around], task: Task) -> dict[Around, list[list[Piece]]]:
    """Give for each vertex the pieces that may take the place of those round it, collapse by collapse."""
    chains = [chain_after(piece, vertex) for vertex, pieces in stars for piece in pieces]
    moves = list(_untorn(stars, chains))
    moves = _possible(board, stars, chains, moves, task)
    after = [_after(move, chains) for move in moves]
    rings = [ring for shrunk in after for ring in shrunk]
    proven = dict(zip(rings, board.have_kernels(rings, task), strict=True))
    found: dict[Around, list[list[Piece]]] = {star: [] for star in stars}
    for move, shrunk in zip(moves, after, strict=True):
        if all(proven[ring] for ring in shrunk):
            found[stars[move.at]].append(shrunk)
    return found


def _untorn(stars: Sequence[Around], chains: Sequence[Piece]) -> Iterable[_Collapse]:
    """Give the collapses after which no piece touches itself."""
    begun = 0
    for at, (_, pieces) in enumerate(stars):
        around = range(begun, begun + len(pieces))
        begun = around.stop
        inner = {v for k in around for v in chains[k][1:-1]}
        for neighbour in sorted({end for k in around for end in (chains[k][0], chains[k][-1])} - inner):
            yield _Collapse(at, neighbour, around)


def _possible(
    board: Board, stars: Sequence[Around], chains: Sequence[Piece], moves: list[_Collapse], task: Task
) -> list[_Collapse]:
    """Give the collapses after which all kernels of both polygons have an inside, but for rounding."""
    if not moves:
        return moves
    rings = Rings.of(chains)
    owner = np.repeat(np.arange(len(stars)), [len(pieces) for _, pieces in stars])
    cells = kernels_of_chains(board.at[:, rings.rows], rings, owner, task)
    chain, place, move = _meetings(moves)
    first, last = rings.rows[rings.first[chain]], rings.rows[rings.last[chain]]
    apart = (first != place) & (last != place)
    start, end, onto = (board.at[:, rows] for rows in (first, last, place))
    cells = cells.chosen(np.concatenate([chain, chain + len(chains)]))
    cells = cells.left_of(end.ravel(), np.where(apart, onto, start).ravel())
    cells = cells.left_of(np.where(apart, onto, end).ravel(), start.ravel())
    gone = ~apart & (rings.counts[chain] == 2)
    wrong = (cells.size == 0).reshape(2, -1).any(axis=0) & ~gone
    possible = np.bincount(move[wrong], minlength=len(moves)) == 0
    return [moves[k] for k in np.flatnonzero(possible).tolist()]


def _meetings(moves: list[_Collapse]) -> tuple[Indices, Indices, Indices]:
    """Give for each collapse its chains: the chain, the vertex that closes it to a ring, the collapse."""
    first, counts, neighbours = np.array([(m.chains.start, len(m.chains), m.neighbour) for m in moves]).T
    move, chain = ranges(first, counts)
    return chain, neighbours[move], move


def _after(move: _Collapse, chains: Sequence[Piece]) -> list[Piece]:
    """Give what is left of the pieces: triangles at the neighbour vanish."""
    rings = []
    for chain in chains[move.chains.start : move.chains.stop]:
        if move.neighbour not in {chain[0], chain[-1]}:
            rings.append(from_least((move.neighbour, *chain)))
        elif len(chain) > 2:
            rings.append(from_least(chain))
    return rings
