"""Steiner vertices that may collapse into a neighbour: all pieces round them stay simple and star-shaped.

Of the kernels of all rings that might come of it most are empty. They are looked for in floating point first;
only what has an inside then is looked at exactly.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Indices
from starskel.decomposition.board import Board
from starskel.decomposition.kernels.half_planes import Lines, left_of_all
from starskel.decomposition.pieces import Around, Piece, Replacements, chain_after, from_least
from starskel.rings import Rings, ranges
from starskel.task import Task


@dataclass(frozen=True)
class _Collapse:
    """What becomes of chains, the pieces round a vertex without it, as a neighbour takes its place."""

    at: int
    neighbour: int
    chains: range


def collapses(board: Board, stars: Sequence[Around], task: Task) -> dict[Around, Replacements]:
    """Give for each vertex the pieces that may take the place of those round it, collapse by collapse."""
    chains = [chain_after(piece, vertex) for vertex, pieces in stars for piece in pieces]
    moves = list(_untorn(board, stars, chains))
    moves = _possible(board, chains, moves, task)
    after = [_after(move, chains) for move in moves]
    rings = [ring for shrunk in after for ring in shrunk]
    proven = dict(zip(rings, board.have_kernels(rings, task), strict=True))
    found: dict[Around, Replacements] = dict.fromkeys(stars, ())
    for move, shrunk in zip(moves, after, strict=True):
        if all(proven[ring] for ring in shrunk):
            found[stars[move.at]] += (shrunk,)
    return found


def _untorn(board: Board, stars: Sequence[Around], chains: Sequence[Piece]) -> Iterable[_Collapse]:
    """Give the collapses after which no piece touches itself, but for those known to be in vain."""
    begun = 0
    for at, (_, pieces) in enumerate(stars):
        around = range(begun, begun + len(pieces))
        begun = around.stop
        near = [chains[k] for k in around]
        ends = {end for chain in near for end in (chain[0], chain[-1])}
        in_vain = (board.in_vain.get(chain, ()) for chain in near)
        for neighbour in sorted(ends.difference(*(chain[1:-1] for chain in near), *in_vain)):
            yield _Collapse(at, neighbour, around)


def _possible(board: Board, chains: Sequence[Piece], moves: list[_Collapse], task: Task) -> list[_Collapse]:
    """Give the collapses after which all kernels of both polygons have an inside, but for rounding.

    The middles of these kernels prove most of them.
    """
    if not moves:
        return moves
    rings = Rings.of(chains)
    meetings, middles = _meetings(moves), np.empty((0, sum(len(m.chains) for m in moves)), complex)
    for at in board.at:  # in the second polygon only what is possible in the first
        chain, place, move = meetings
        kernels = left_of_all(Lines.round(_closed(rings, chain, place), at), task)
        wrong = (kernels.size == 0) & ~_vanish(rings, chain, place)
        for k, vertex in meetings[:2, wrong].T.tolist():
            board.in_vain[chains[k]] = *board.in_vain.get(chains[k], ()), vertex
        possible = np.bincount(move[wrong], minlength=len(moves))[move] == 0
        meetings = meetings[:, possible]
        middles = np.concatenate([middles, kernels.measured()[0][None]])[:, possible]
    chain, place, move = meetings
    left = ~_vanish(rings, chain, place)
    shrunk = [_shrunk(chains[c], p) for c, p in meetings[:2, left].T.tolist()]
    board.note_kernels(shrunk, [middle[left, None].view(np.float64) for middle in middles])
    return [moves[k] for k in np.unique(move).tolist()]


def _meetings(moves: list[_Collapse]) -> Indices:
    """Give for each collapse its chains: the chain, the vertex that closes it to a ring, the collapse."""
    first, counts, neighbours = np.array([(m.chains.start, len(m.chains), m.neighbour) for m in moves]).T
    move, chain = ranges(first, counts)
    return np.stack([chain, neighbours[move], move])


def _vanish(chains: Rings, chain: Indices, place: Indices) -> Flags:
    """Tell of which chains nothing is left: links that begin or end where they are to be closed."""
    ends = chains.rows[chains.first[chain]], chains.rows[chains.last[chain]]
    vanish: Flags = (chains.counts[chain] == 2) & ((ends[0] == place) | (ends[1] == place))
    return vanish


def _closed(chains: Rings, chain: Indices, place: Indices) -> Rings:
    """Close some of the chains to rings, by a vertex each, which may stand there twice."""
    counts = chains.counts[chain]
    _, vertex = ranges(chains.first[chain], counts)
    return Rings(np.insert(chains.rows[vertex], np.cumsum(counts) - counts, place), counts + 1)


def _after(move: _Collapse, chains: Sequence[Piece]) -> tuple[Piece, ...]:
    """Give what is left of the pieces: triangles at the neighbour vanish."""
    left = [_shrunk(chain, move.neighbour) for chain in chains[move.chains.start : move.chains.stop]]
    return tuple(ring for ring in left if len(ring) > 2)


def _shrunk(chain: Piece, vertex: int) -> Piece:
    """Close a chain by a vertex, which may be one of its ends."""
    return from_least(chain if vertex in {chain[0], chain[-1]} else (vertex, *chain))
