"""The compatible star decomposition with the fewest pieces that needs no Steiner vertices.

A dynamic program over sub-polygons, after Keil (paper, references 11 and 12), for two polygons at once. A
link is an edge of the ring or a diagonal of both polygons. For i < j with a link (i, j), f[i, j] is the cost
of the sub-polygon i..j. The piece on (i, j) has a star vertex k, and its boundary is a chain of links
i = v0 < v1 < ... < k < ... < j over vertices that k sees in both polygons. The best half chains from i up to
k and from k down to j are tabulated as well,

    left[i, k]  = min over v in (i, k] with link (i, v) of f[i, v] + left[v, k],    left[k, k] = 0
    right[k, j] = min over v in [k, j) with link (v, j) of right[k, v] + f[v, j],   right[k, k] = 0
    f[i, j] = 1 + min over k of left[i, k] + right[k, j],           f of an edge of the ring = 0

so that each of the O(n^2) entries is a minimum over O(n): O(n^3) in all, where the paper has O(n^4). Entries
of equal span j - i are found together. The closing edge (0, n - 1) stands for the whole ring.

Where that has no answer, the same tables tell how far common diagonals lead: a cell bounded by a chain of any
links, star or not, is let in at a price that grows with its size,

    chain[i, j] = size price + min(f[i, j], min over v of f[i, v] + chain[v, j])

so that the cells that are no star pieces are few and small. These cells are called stuck.

A cost is the number of pieces plus the total length of shared edges, scaled to stay below 1/2: among the
decompositions with fewest pieces it chooses the one with the shortest cuts.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.decomposition.links import Links
from starskel.decomposition.pieces import Piece
from starskel.task import Task

_ROWS = 256
"""Rows of a table that are filled between two questions whether to stop."""

_SUMS = 1 << 15
"""Sums that are looked through at a time: so many stay near the processor, which is several times as fast."""


@dataclass(frozen=True, eq=False)
class _Tables:
    """Symmetric tables: entries [i, j] and [j, i], i < j, both belong to the span i..j.

    Every minimum then runs along two rows, which lie contiguous in memory.
    """

    f: Floats
    left: Floats
    right: Floats
    chain: Floats | None


def minimal_pieces(links: Links, task: Task) -> list[Piece] | None:
    """Give the pieces as rows of vertices, counter-clockwise, or None where there is no decomposition.

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    n = len(links.sees)
    f, left, right = (_table(n, task) for _ in range(3))
    tables = _fill(_Tables(f, left, right, None), links, task)
    return _pieces(tables, links, 0) if np.isfinite(f[0, n - 1]) else None


def least_stuck_cells(links: Links, task: Task) -> list[list[Piece]]:
    """Give for each ring star pieces and stuck cells that tile it in both polygons, these as small as can be.

    Several rings take hardly longer than the largest of them alone.
    """
    n = len(links.sees)
    f, left, right, chain = (_table(n, task) for _ in range(4))
    tables = _fill(_Tables(f, left, right, chain), links, task)
    return [_pieces(tables, links, ring) for ring in range(len(links.rings.counts))]


def _table(n: int, task: Task) -> Floats:
    table = np.empty((n, n))
    for row in range(0, n, _ROWS):  # the first touch of so much memory takes long
        task.reach(0)
        table[row : row + _ROWS] = np.inf
    return table


def _fill(tables: _Tables, links: Links, task: Task) -> _Tables:
    task.reach(0)
    rings = links.rings
    edges = np.flatnonzero(rings.owner[1:] == rings.owner[:-1])
    for table in (tables.f, tables.left, tables.right):
        _set(table, edges, 1, np.zeros(len(edges)))
    if tables.chain is not None:
        _set(tables.chain, edges, 1, links.sizes[edges])
    longest = int(rings.counts.max())
    for span in range(2, longest):
        task.reach((span / longest) ** 2)
        _lengthen(tables, np.flatnonzero(np.diagonal(links.sees, span)), span)
        _link(tables, links, span)
    return tables


def _lengthen(tables: _Tables, seen: Indices, span: int) -> None:
    """Fill in the half chains of a span between vertices that see each other."""
    if len(seen):
        left = _least(tables.f, tables.left, seen, span)
        right = _least(tables.right, tables.f, seen, span)
        _set(tables.left, seen, span, left)
        _set(tables.right, seen, span, right)


def _link(tables: _Tables, links: Links, span: int) -> None:
    """Fill in what links of a span cost; they are half chains as well, and longer chains of any links."""
    diagonal = np.flatnonzero(np.diagonal(links.diagonal, span))
    linked = np.concatenate([diagonal, links.rings.first[links.rings.counts == span + 1]])
    if not len(linked) and tables.chain is None:
        return
    cost = _costs(tables, linked, span)
    if tables.chain is not None:
        sizes = links.sizes[linked]
        chain = _chains(tables.f, tables.chain, links, linked[cost < sizes], span)
        cost = np.minimum(cost, chain[linked] + sizes)
    if len(linked):
        cost[: len(diagonal)] += links.price(diagonal, diagonal + span)
        _set(tables.f, linked, span, cost)
        for table in (tables.left, tables.right):  # every diagonal is seen
            _set(table, linked, span, np.minimum(table[linked, linked + span], cost))
    if tables.chain is not None:
        chain[linked] = np.minimum(chain[linked], cost)
        _set(tables.chain, np.arange(len(chain)), span, chain + links.sizes[: len(chain)])


def _costs(tables: _Tables, linked: Indices, span: int) -> Floats:
    """Give what the star pieces on links cost, with what is beyond their other links."""
    if not len(linked):
        return np.empty(0)
    ends = np.minimum(tables.left[linked, linked + span], tables.right[linked, linked + span])
    return 1 + np.minimum(_least(tables.left, tables.right, linked, span), ends)


def _chains(f: Floats, chain: Floats, links: Links, cheap: Indices, span: int) -> Floats:
    """Give for spans i..j what chains of two links or more cost; those beyond their ring are infinite.

    Where a link is cheap no chain costs less, and none is looked for. Where no diagonal leads from i to
    before j the chain begins with an edge.
    """
    n = len(f)
    chains: Floats = np.diagonal(f, 1)[: n - span] + np.diagonal(chain, span - 1)[1:]
    chains[cheap] = np.inf
    open_still = np.flatnonzero((chains < np.inf) & (links.nearest[: n - span] < np.arange(span, n)))
    chains[open_still] = _least(f, chain, open_still, span)
    return chains


def _least(first: Floats, second: Floats, rows: Indices, span: int) -> Floats:
    """For spans i..j at the given i, the least first[i, v] + second[v, j] over i < v < j."""
    least = np.empty(len(rows))
    along_i, along_j = _spans(first, 0, span), _spans(second, span, span)
    step = max(1, _SUMS // span)
    for begun in range(0, len(rows), step):
        some = rows[begun : begun + step]
        sums = along_i[some]
        sums += along_j[some]
        sums.min(axis=1, out=least[begun : begun + step])
    return least


def _spans(table: Floats, offset: int, span: int) -> Floats:
    """View row i of the result as table[i + offset, i + 1 : i + span]."""
    n, (down, right) = len(table), table.strides
    return np.ndarray(
        (n - span, span - 1), table.dtype, table, offset * down + right, strides=(down + right, right)
    )


def _set(table: Floats, rows: Indices, span: int, values: Floats) -> None:
    table[rows, rows + span] = values
    table[rows + span, rows] = values


def _pieces(tables: _Tables, links: Links, ring: int) -> list[Piece]:
    """Walk back through the tables; equal costs are decided for the lowest index."""
    pieces: list[Piece] = []
    waiting = [(int(links.rings.first[ring]), int(links.rings.last[ring]))]
    while waiting:
        boundary = _boundary(tables, links, *waiting.pop())
        pieces.append(tuple(links.rings.rows[boundary].tolist()))
        waiting += [(a, b) for a, b in pairwise(boundary) if b - a > 1]
    return pieces


def _boundary(tables: _Tables, links: Links, i: int, j: int) -> list[int]:
    """Give the vertices of the piece on the link (i, j), from i to j."""
    inner = np.full(j - i + 1, np.inf)
    inner[1:-1] = _through(tables.left, tables.right, i, j)
    if links.sees[i, j]:
        inner[0] = _through(tables.right, tables.f, i, j).min()
        inner[-1] = _through(tables.f, tables.left, i, j).min()
    k = i + int(inner.argmin())
    if tables.chain is not None:
        chain = _through(tables.f, tables.chain, i, j)
        if chain.min() + links.sizes[i] < 1 + inner.min():
            first = i + 1 + int(chain.argmin())
            return [i, first, *_chain_of_links(tables.f, tables.chain, first, j)]
    ahead = _chain_of_links(tables.f, tables.left, i, k, closing=(i, j))
    back = _chain_of_links(tables.f, tables.right, j, k, closing=(j, i))
    return [i, *ahead, *back[-2::-1], j] if k < j else [i, *ahead]


def _chain_of_links(
    f: Floats, rest: Floats, start: int, end: int, closing: tuple[int, int] | None = None
) -> list[int]:
    """Give the cheapest chain from start, without it, to end; the piece's closing link is not in it."""
    chain = []
    at = start
    while at != end:
        low = min(at, end)
        through = _through(f, rest, at, end)
        direct = f[at, end] if (at, end) != closing else np.inf
        straight_on = not len(through) or direct <= through.min()
        at = end if straight_on else low + 1 + int(through.argmin())
        chain.append(at)
    return chain


def _through(first: Floats, second: Floats, i: int, j: int) -> Floats:
    """For all v strictly between i and j, in rising order, give first[i, v] + second[v, j]."""
    inner = slice(min(i, j) + 1, max(i, j))
    through: Floats = first[i, inner] + second[j, inner]
    return through
