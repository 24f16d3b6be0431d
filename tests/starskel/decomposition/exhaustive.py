"""Compatible star decompositions by trying everything: slow, plain, and independent of the library's tables."""

from functools import cache
from itertools import pairwise


def fewest_pieces(sees, diagonal) -> int | None:
    """The least number of star pieces of two polygons, over all ways to cut with common diagonals."""
    n = len(sees)
    cuts = [(i, j) for i in range(n) for j in range(i + 2, n) if diagonal[i, j]]

    def crossing(a, b):
        (i, j), (k, m) = sorted((a, b))
        return i < k < j < m

    best = None

    def pieces_of(chosen):
        @cache
        def cut(ring):
            for a, b in chosen:
                if a in ring and b in ring:
                    i, j = ring.index(a), ring.index(b)
                    if 1 < j - i < len(ring) - 1:
                        return (*cut(ring[i : j + 1]), *cut(ring[: i + 1] + ring[j:]))
            return (ring,)

        return cut(tuple(range(n)))

    def try_from(start, chosen):
        nonlocal best
        if best is not None and len(chosen) + 1 >= best:
            return
        pieces = pieces_of(tuple(chosen))
        if all(any(all(sees[k][v] for v in piece) for k in piece) for piece in pieces):
            best = len(pieces)
            return
        for at in range(start, len(cuts)):
            if not any(crossing(cuts[at], other) for other in chosen):
                try_from(at + 1, [*chosen, cuts[at]])

    try_from(0, [])
    return best


def pairs_of_ring(ring) -> set[tuple[int, int]]:
    return {(min(a, b), max(a, b)) for a, b in pairwise((*ring, ring[0]))}
