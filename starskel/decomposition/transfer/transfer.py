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

from starskel.arrays import Flags, Floats, Indices
from starskel.decomposition.board import Board, handfuls
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.pieces import Piece
from starskel.decomposition.transfer.convex import Cut, Price, convex_cuts
from starskel.decomposition.transfer.paths import MANY, bends_between
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import Grounds, Triangulation
from starskel.visibility import visibility
from starskel.visibility.cells import cells_of


def transfer(board: Board, whole: Piece, task: Task) -> list[Piece]:
    """Tile the whole of two polygons by star pieces that respect a convex decomposition of one of them.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    cuts, side = fewer_cuts(board, whole, task.part(0, 0.3))
    parts = drawn_parts(board, whole, cuts, side, task.part(0.3, 0.7))
    task.reach(0.7)
    return list(chain.from_iterable(climb(board, parts, by_fan, task.quiet)))


def fewer_cuts(board: Board, whole: Piece, task: Task) -> tuple[list[Cut], int]:
    """Give the cuts of the polygon that needs fewer, and which one that is."""
    grounds = board.triangulated([whole], task.quiet)
    seen = [visibility(ground, task) for ground in grounds]
    likely = _with_fewer_cells(grounds)
    found = {}
    for k, side in enumerate(likely):
        price = _price(grounds[side], seen[1 - side].diagonal)
        part = task.part(k / len(likely), (k + 1) / len(likely))
        found[side] = convex_cuts(grounds[side], seen[side], price, part)
    side = min(found, key=lambda side: len(found[side]))
    return [(whole[a], whole[b]) for a, b in found[side]], side


def _with_fewer_cells(grounds: Grounds) -> list[int]:
    """Give the sides where triangles are joined to the fewest convex cells, or to one more.

    That tells which polygon needs fewer cuts. Where the numbers of cells differ by more it is seldom wrong.
    """
    corners = [len(cells_of(ground).first) for ground in grounds]  # each cut adds two
    return [side for side in (0, 1) if corners[side] <= min(corners) + 2]


def _price(ground: Triangulation, free: Flags) -> Price:
    """Prefer diagonals that are diagonals of the other polygon as well, then short ones."""
    n = len(ground.rings.rows)
    longest = np.hypot(*np.ptp(ground.vertices, axis=0))

    def price(i: Indices, j: Indices) -> Floats:
        length = np.hypot(*np.moveaxis(ground.vertices[i] - ground.vertices[j], -1, 0))
        return np.asarray((np.where(free[i, j], 0, n) + length / longest) / (2 * n * (n + 1)))

    return price


def drawn_parts(board: Board, whole: Piece, cuts: list[Cut], side: int, task: Task) -> list[Piece]:
    """Cut a ring of both polygons along diagonals of one, drawn into the other as paths; give the parts.

    The diagonal that halves a part best is drawn first: paths through one corridor then share it evenly.
    """
    parts = {whole: cuts}
    while waiting := [part for part, inner in parts.items() if inner]:
        task.reach(1 - sum(map(len, parts.values())) / len(cuts))
        for handful in handfuls(waiting, MANY, len):
            chosen = [_halving(part, parts[part]) for part in handful]
            for part, cut, halves in zip(
                handful, chosen, _halves(board, handful, chosen, side, task.quiet), strict=True
            ):
                inner = [other for other in parts.pop(part) if other != cut]
                parts.update((half, _within(half, inner)) for half in halves)
    return list(parts)


def _halving(part: Piece, cuts: list[Cut]) -> Cut:
    at = {vertex: place for place, vertex in enumerate(part)}
    return min(cuts, key=lambda cut: (abs(2 * (at[cut[1]] - at[cut[0]]) - len(part)), cut))


def _within(part: Piece, cuts: list[Cut]) -> list[Cut]:
    vertices = set(part)
    return [cut for cut in cuts if vertices.issuperset(cut)]


def _halves(
    board: Board, parts: list[Piece], cuts: list[Cut], side: int, task: Task
) -> list[tuple[Piece, ...]]:
    """Cut parts in two, each along one cut, or keep them: the other polygon may be too narrow for a path."""
    rings = Rings.of(parts)
    places = [tuple(part.index(v) for v in cut) for part, cut in zip(parts, cuts, strict=True)]
    starts, ends = (rings.first + np.array(place) for place in zip(*places, strict=True))
    paths = bends_between(board.sides[1 - side], rings, starts, ends, task)
    rows = iter(
        _place(board, [(cut, path) for cut, path in zip(cuts, paths, strict=True) if path is not None], side)
    )
    halves: list[tuple[Piece, ...]] = []
    for part, (start, end), path in zip(parts, places, paths, strict=True):
        if path is None:
            halves.append((part,))
            continue
        between = tuple(next(rows) for _ in path)
        halves.append(((*part[start : end + 1], *between[::-1]), (*part[: start + 1], *between, *part[end:])))
    return halves


def _place(board: Board, drawn: list[tuple[Cut, Floats]], side: int) -> range:
    """Add the bends of paths as Steiner vertices, which stand on diagonals on the side that is cut."""
    if not drawn:
        return range(0)
    counts = [len(path) for _, path in drawn]
    first, last = np.repeat(np.array([cut for cut, _ in drawn]), counts, axis=0).T
    share = np.concatenate([np.arange(1, count + 1) / (count + 1) for count in counts])
    added = [points.with_free(np.concatenate([path for _, path in drawn])) for points in board.sides]
    added[side] = board.sides[side].with_on_chords(first, last, share)
    return board.add(*added)
