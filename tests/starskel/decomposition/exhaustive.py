"""Compatible star decompositions by trying everything: slow, plain, and independent of the tables."""

from itertools import pairwise


def fewest_pieces(links) -> tuple[int, float] | None:
    """The least number of star pieces, and the least price of the cuts that make so many."""
    stars = (
        (len(pieces), price(links, chosen))
        for chosen, pieces in ways_to_cut(links)
        if all(is_star(links.sees, piece) for piece in pieces)
    )
    return min(stars, default=None)


def least_stuck(links) -> float:
    """The least cost of star pieces, cells that are none, and the cuts between them."""
    return min(stuck_cost(links, pieces) + price(links, chosen) for chosen, pieces in ways_to_cut(links))


def stuck_cost(links, pieces) -> int:
    """What pieces cost: 1 if they are stars, else for each of their vertices as many as the ring has."""
    return sum(1 if is_star(links.sees, piece) else len(links.sees) * len(piece) for piece in pieces)


def ways_to_cut(links):
    """All sets of common diagonals that do not cross, with the pieces between them."""
    n = len(links.sees)
    cuts = [(i, j) for i in range(n) for j in range(i + 2, n) if links.diagonal[i, j]]
    return ((chosen, cut(tuple(range(n)), chosen)) for chosen in crossing_free(cuts))


def price(links, chosen) -> float:
    return sum(float(links.price([i], [j])[0]) for i, j in chosen)


def crossing_free(cuts, chosen=()):
    """All sets of cuts that do not cross."""
    yield chosen
    for at, (i, j) in enumerate(cuts):
        if not any(i < k < j < m or k < i < m < j for k, m in chosen):
            yield from crossing_free(cuts[at + 1 :], (*chosen, (i, j)))


def cut(ring, chosen):
    for a, b in chosen:
        if a in ring and b in ring:
            i, j = sorted((ring.index(a), ring.index(b)))
            if 1 < j - i < len(ring) - 1:
                return (*cut(ring[i : j + 1], chosen), *cut(ring[: i + 1] + ring[j:], chosen))
    return (ring,)


def is_star(sees, piece) -> bool:
    return any(all(sees[k][v] for v in piece) for k in piece)


def pairs_of_ring(ring) -> set[tuple[int, int]]:
    return {(min(a, b), max(a, b)) for a, b in pairwise((*ring, ring[0]))}
