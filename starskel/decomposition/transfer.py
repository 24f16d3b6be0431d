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

import numpy as np

from starskel.decomposition.convex import Cut, Price, convex_cuts
from starskel.decomposition.ladder import by_fan, climb, triangulated
from starskel.decomposition.paths import bends_between
from starskel.decomposition.pieces import Piece
from starskel.decomposition.tiling import Tiling
from starskel.predicates import Floats, Indices, Relation
from starskel.task import Task
from starskel.triangulation import Triangulation
from starskel.visibility import visibility


def transfer(tiling: Tiling, whole: Piece, task: Task) -> Tiling:
    """Replace the whole of two polygons by star pieces that respect a convex decomposition of one of them.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    cuts, swap = _fewer_cuts(tiling, whole, task.part(0, 0.3))
    if swap:
        tiling = tiling.swapped()
    tiling = _draw(tiling, whole, cuts, task.part(0.3, 0.7))
    parts = tiling.pieces
    for at, part in enumerate(parts):
        done = 0.7 + 0.3 * at / len(parts)
        task.reach(done)
        tiling = climb(tiling, part, by_fan, task.quiet)
    return tiling.swapped() if swap else tiling


def _fewer_cuts(tiling: Tiling, whole: Piece, task: Task) -> tuple[list[Cut], bool]:
    """Give the cuts of the polygon that needs fewer, and whether that is the target."""
    grounds = triangulated(tiling, whole, task.quiet)
    seen = [visibility(ground, task) for ground in grounds]
    cuts = [
        convex_cuts(
            grounds[i], seen[i], _price(grounds[i], seen[1 - i].diagonal), task.part(i / 2, i / 2 + 0.5)
        )
        for i in (0, 1)
    ]
    swap = len(cuts[1]) < len(cuts[0])
    return [(whole[a], whole[b]) for a, b in cuts[swap]], swap


def _price(ground: Triangulation, free: Relation) -> Price:
    """Prefer diagonals that are diagonals of the other polygon as well, then short ones."""
    n = len(ground.rings.rows)
    longest = np.hypot(*np.ptp(ground.vertices, axis=0))

    def price(i: Indices, j: Indices) -> Floats:
        length = np.hypot(*np.moveaxis(ground.vertices[i] - ground.vertices[j], -1, 0))
        return np.asarray((np.where(free[i, j], 0, n) + length / longest) / (2 * n * (n + 1)))

    return price


def _draw(tiling: Tiling, whole: Piece, cuts: list[Cut], task: Task) -> Tiling:
    """Cut a ring of both polygons along diagonals of the source, drawn into the target as paths.

    The diagonal that halves a part best is drawn first: paths through one corridor then share it evenly.
    """
    waiting = [(whole, cuts)]
    drawn = 0
    while waiting:
        part, inner = waiting.pop()
        if not inner:
            continue
        done = drawn / len(cuts)
        drawn += 1
        chosen = _halving(part, inner)
        inner = [cut for cut in inner if cut != chosen]
        task.reach(done)
        cut = _cut(tiling, part, chosen, task.quiet)
        if cut is None:
            waiting.append((part, inner))
            continue
        tiling, halves = cut
        waiting += [(half, _within(half, inner)) for half in halves]
    return tiling


def _halving(part: Piece, cuts: list[Cut]) -> Cut:
    at = {vertex: place for place, vertex in enumerate(part)}
    return min(cuts, key=lambda cut: (abs(2 * (at[cut[1]] - at[cut[0]]) - len(part)), cut))


def _within(part: Piece, cuts: list[Cut]) -> list[Cut]:
    vertices = set(part)
    return [cut for cut in cuts if vertices.issuperset(cut)]


def _cut(tiling: Tiling, part: Piece, cut: Cut, task: Task) -> tuple[Tiling, tuple[Piece, Piece]] | None:
    """Cut a part in two; None where the target is too narrow for a path."""
    start, end = (part.index(v) for v in cut)
    bends = bends_between(tiling.target, np.array(part), start, end, task)
    if bends is None:
        return None
    count = len(tiling.source.coordinates)
    between = tuple(range(count, count + len(bends)))
    share = np.arange(1, len(bends) + 1) / (len(bends) + 1)
    halves = (*part[start : end + 1], *between[::-1]), (*part[: start + 1], *between, *part[end:])
    pieces = tuple(piece for piece in tiling.pieces if piece != part)
    first, last = (np.full(len(bends), v) for v in cut)
    source = tiling.source.with_on_chords(first, last, share)
    return Tiling(source, tiling.target.with_free(bends), (*pieces, *halves)), halves
