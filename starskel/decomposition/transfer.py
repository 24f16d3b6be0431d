"""The paper's second algorithm: convex pieces of one polygon are carried over to the other (section 2.4.1).

The polygon that falls into fewer convex pieces is cut into them along diagonals. Each diagonal is drawn into
the other polygon as a path with few links, inside the part that it cuts, so that paths do not cross. The
bends are Steiner vertices; in the first polygon they stand on the diagonal. Then every part is convex in the
one polygon, where every vertex sees all, and it remains to cut it into star pieces in the other.

A path is never longer than needed. So two of its vertices see each other in the other polygon only if they
are next to each other, and no piece has all its vertices on one diagonal, where it would have no area. Only
runs of straight vertices of the ring itself can lead there; parts which that leaves stuck are climbed.

A path has O(n) links: it can run along the ring, or along paths drawn before, of which each adds a few links
at most, as it is itself as short as can be. That is O(n^2) Steiner vertices for the O(n) diagonals.
"""

from itertools import chain

import numpy as np

from starskel.decomposition.board import Board
from starskel.decomposition.convex import Cut, Price, convex_cuts
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.paths import bends_between
from starskel.decomposition.pieces import Piece
from starskel.predicates import Floats, Indices, Relation
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import visibility


def transfer(board: Board, whole: Piece, task: Task) -> list[Piece]:
    """Tile the whole of two polygons by star pieces that respect a convex decomposition of one of them.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    cuts, side = _fewer_cuts(board, whole, task.part(0, 0.3))
    parts = _draw(board, whole, cuts, side, task.part(0.3, 0.7))
    task.reach(0.7)
    return list(chain.from_iterable(climb(board, parts, by_fan, task.quiet)))


def _fewer_cuts(board: Board, whole: Piece, task: Task) -> tuple[list[Cut], int]:
    """Give the cuts of the polygon that needs fewer, and which one that is."""
    grounds = board.triangulated([whole], task.quiet)
    seen = [visibility(ground, task) for ground in grounds]
    cuts = [
        convex_cuts(
            grounds[i], seen[i], _price(grounds[i], seen[1 - i].diagonal), task.part(i / 2, i / 2 + 0.5)
        )
        for i in (0, 1)
    ]
    side = int(len(cuts[1]) < len(cuts[0]))
    return [(whole[a], whole[b]) for a, b in cuts[side]], side


def _price(ground: Triangulation, free: Relation) -> Price:
    """Prefer diagonals that are diagonals of the other polygon as well, then short ones."""
    n = len(ground.rings.rows)
    longest = np.hypot(*np.ptp(ground.vertices, axis=0))

    def price(i: Indices, j: Indices) -> Floats:
        length = np.hypot(*np.moveaxis(ground.vertices[i] - ground.vertices[j], -1, 0))
        return np.asarray((np.where(free[i, j], 0, n) + length / longest) / (2 * n * (n + 1)))

    return price


def _draw(board: Board, whole: Piece, cuts: list[Cut], side: int, task: Task) -> list[Piece]:
    """Cut a ring of both polygons along diagonals of one, drawn into the other as paths; give the parts.

    The diagonal that halves a part best is drawn first: paths through one corridor then share it evenly.
    """
    parts = []
    waiting = [(whole, cuts)]
    drawn = 0
    while waiting:
        part, inner = waiting.pop()
        if not inner:
            parts.append(part)
            continue
        task.reach(drawn / len(cuts))
        drawn += 1
        chosen = _halving(part, inner)
        inner = [cut for cut in inner if cut != chosen]
        halves = _cut(board, part, chosen, side, task.quiet)
        waiting += [(half, _within(half, inner)) for half in halves or [part]]
    return parts


def _halving(part: Piece, cuts: list[Cut]) -> Cut:
    at = {vertex: place for place, vertex in enumerate(part)}
    return min(cuts, key=lambda cut: (abs(2 * (at[cut[1]] - at[cut[0]]) - len(part)), cut))


def _within(part: Piece, cuts: list[Cut]) -> list[Cut]:
    vertices = set(part)
    return [cut for cut in cuts if vertices.issuperset(cut)]


def _cut(board: Board, part: Piece, cut: Cut, side: int, task: Task) -> tuple[Piece, Piece] | None:
    """Cut a part in two; None where the other polygon is too narrow for a path."""
    start, end = (part.index(v) for v in cut)
    bends = bends_between(board.sides[1 - side], np.array(part), start, end, task)
    if bends is None:
        return None
    share = np.arange(1, len(bends) + 1) / (len(bends) + 1)
    first, last = (np.full(len(bends), v) for v in cut)
    added = [points.with_free(bends) for points in board.sides]
    added[side] = board.sides[side].with_on_chords(first, last, share)
    between = tuple(board.add(*added))
    return (*part[start : end + 1], *between[::-1]), (*part[: start + 1], *between, *part[end:])
